# SPDX-License-Identifier: MIT
"""Asks every fuzz target in the ordinary build: kept and made seeds, and spoilt ones of them.

    python3 tests/fuzz/replay.py [--inputs N] [TARGET...]

EDGECASE_BIN has the programs fuzz_replay and edgecase (build/release/bin). The inputs are the same
each time. A bounded run is a part of the tests; --inputs asks a target as often as one likes. Exit
code 1 where something was found: the input lies where the message says, and belongs into
tests/fuzz/found/TARGET once its fault is mended.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import fuzz

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import share  # noqa: E402  the path comes first

# How many spoilt files each target is asked, or the share of them that is wanted: about four seconds
# each.
INPUTS = {"case_file": 6000, "policy": 10000, "known_faults": 10000, "decisions": 20000,
          "results": 4000, "recording": 10000, "answer": 6000, "compare": 1500, "mesh": 6000, "image": 2000}
FINDS = fuzz.BIN.parent / "fuzz-finds"


def replay(target, inputs, folders, find):
    """The finished process; where it failed, `find` is the input that did it."""
    # A part of ours that loses memory shows in the preset `asan`; OpenImageIO's losses are not ours.
    sanitizer = f"abort_on_error=1:detect_leaks={int(target not in fuzz.LEAKING)}"
    return subprocess.run([fuzz.BIN / "fuzz_replay", target, str(inputs), find, *folders],
                          capture_output=True, text=True, errors="replace",
                          env={**os.environ, "ASAN_OPTIONS": sanitizer})


def check_control(work):
    """A target that breaks its promise is found, with the input that broke it."""
    seeds, find = work / "seeds", work / "find"
    seeds.mkdir()
    (seeds / "balanced").write_bytes(b'{"a": {"b": [1, 2, 3]}}')
    process = replay("balanced", 1000, [seeds], find)
    kept = find.read_bytes() if find.exists() else b""
    found = process.returncode < 0 and kept.count(b"{") != kept.count(b"}")
    if not found:
        print(f"a broken promise is not found: {process}", flush=True)
    return found


def check(target, inputs):
    """Did the target keep its promises?"""
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        fuzz.write_seeds(target, work / "seeds")
        kept = fuzz.HERE / "found" / target
        find = work / "find"
        folders = [work / "seeds", *([kept] if kept.is_dir() else [])]
        process = replay(target, inputs, folders, find)
        if process.returncode == 0:
            print(process.stdout, end="", flush=True)
            return True
        print(f"{target}: exit code {process.returncode}\n{process.stderr[-4000:]}", flush=True)
        if find.exists():
            FINDS.mkdir(exist_ok=True)
            print(f"the input is {shutil.copy(find, FINDS / target)}", flush=True)
        return False


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", choices=[*INPUTS, []], metavar="TARGET",
                        help=", ".join(INPUTS))
    parser.add_argument("--inputs", type=int, help="spoilt files for each target")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        outcomes = [check_control(pathlib.Path(folder))]
    outcomes += [check(target, INPUTS[target] // share.COUNT if options.inputs is None
                       else options.inputs)
                 for target in options.targets or INPUTS]
    sys.exit(0 if all(outcomes) else 1)


if __name__ == "__main__":
    main()
