# SPDX-License-Identifier: MIT
"""What several tests read of the suite's probes, made once and kept in the build folder: exact's
renderings of all of them, and of this process's share what the four Mesa renderers make of them.

Fixtures of ctest make it before the tests that read it: suite_data.py exact, or mesa. A test that
runs alone makes what it lacks. What is of another program or of other cases is made anew.
"""
import fcntl
import functools
import hashlib
import itertools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from support import (AS_EXPECTED, BIN, EDGECASE, MESA, PATIENCE, PROBES, RENDERER, ROOT, UNHURRIED,
                     environment, report_options)

sys.path.insert(0, str(ROOT / "tests" / "support"))

from share import COUNT, IS_QUICK, NUMBER, in_full_tier, in_share, least_of  # noqa: E402

KEPT = pathlib.Path(os.environ.get("EDGECASE_BUILD", BIN.parent)) / "suite-data"
SHARE = f"{NUMBER}-of-{COUNT}"
AGAINST_MESA = [word for renderer in MESA for word in ("--against", renderer)] + UNHURRIED
NO_CASES = {"galleries", "known", "meshes", "policies", "profiles"}
# How the line of a rendering or of a result begins; ids hold nothing that JSON escapes.
ID = re.compile(r'\{"id":"([^"\\]+)"')


def shard(part=1, parts=1):
    """Options: of this process's share of a selection, one part in so many. They deal the cases in
    turn, as in_share does."""
    return ["--sample", f"{NUMBER + COUNT * (part - 1)}/{COUNT * parts}"]


def files_of_share(*folders):
    """The case files of this share, of these folders of the suite or of all that hold cases."""
    suite = ROOT / "cases"
    folders = folders or sorted({path.name for path in suite.iterdir() if path.is_dir()} - NO_CASES)
    return in_share(file for folder in folders for file in sorted((suite / folder).rglob("*.json")))


@functools.lru_cache(maxsize=None)
def state():
    """What changes when the programs, the cases, or what is made of them do."""
    files = [BIN / "edgecase", BIN / "edgecase-gl", pathlib.Path(__file__),
             *sorted(path for path in (ROOT / "cases").rglob("*") if path.is_file())]
    facts = [[str(path), path.stat().st_size, path.stat().st_mtime_ns] for path in files]
    facts += [PROBES, UNHURRIED, os.environ.get("EDGECASE_KERNELS", "")]
    return hashlib.sha256(json.dumps(facts).encode()).hexdigest()


def kept(name, make):
    """The folder of that name, which `make` fills where it is missing or out of date."""
    folder = KEPT / name
    KEPT.mkdir(parents=True, exist_ok=True)
    with (KEPT / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        made_of = folder / "made-of"
        if not made_of.exists() or made_of.read_text("utf-8") != state():
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
            make(folder)
            made_of.write_text(state(), "utf-8")
    return folder


def command(folder, *words, expect=(AS_EXPECTED,)):
    """Runs the command in the folder; the lines of its standard error."""
    run = subprocess.run([EDGECASE, *words], cwd=folder, env=environment(), text=True,
                         stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                         stderr=subprocess.PIPE, timeout=PATIENCE)
    if run.returncode not in expect:
        raise AssertionError(f"{words}: exit {run.returncode}: {run.stderr[:1000]}")
    return run.stderr.splitlines()


def make_exact(folder):
    if command(folder, "render", *PROBES, "--json", "truth.jsonl"):
        raise AssertionError("exact complains")


@functools.lru_cache(maxsize=None)
def truth_of_suite():
    """The file in which `edgecase render` wrote what exact makes of the suite's probes."""
    return kept("exact", make_exact) / "truth.jsonl"


def run_share(folder, jobs, *renderers):
    """Runs this share of the suite against renderers, with each kind of report in the folder. All
    has to be as expected."""
    command(folder, "run", *PROBES, *shard(), *renderers, *report_options("."), "--jobs", str(jobs))


def make_mesa(folder):
    """Results of several threads, and each renderer's renderings by way of a recording: `render` takes no share."""
    run_share(folder, 4, *AGAINST_MESA)
    for renderer in MESA:
        command(folder, "record", *PROBES, *shard(), "--against", renderer, *UNHURRIED, "-o",
                "one.rec")
        told = command(folder, "render", *PROBES, "--with", "recording:one.rec", "--json",
                       f"{renderer}.jsonl", expect=(AS_EXPECTED, RENDERER))
        with (folder / f"{renderer}.errors").open("w", encoding="utf-8") as errors:
            errors.writelines(f"{line}\n" for line in told if "not recorded" not in line)
        (folder / "one.rec").unlink()


@functools.lru_cache(maxsize=None)
def mesa():
    """The folder with what the four Mesa renderers make of this share: reports.json and its other
    reports, and for each renderer RENDERER.jsonl, as `edgecase render` writes it, and
    RENDERER.errors, a line for each case without a rendering."""
    return kept(f"mesa-{SHARE}", make_mesa)


def exact_lines(of_all=False):
    """(id, line) of exact's renderings of this share or of all the suite's probes, in order."""
    with truth_of_suite().open(encoding="utf-8") as lines:
        for line in lines if of_all else itertools.islice(lines, NUMBER - 1, None, COUNT):
            yield ID.match(line)[1], line


def lines_of(renderer):
    """id -> line of what one of MESA renders of this share."""
    with (mesa() / f"{renderer}.jsonl").open(encoding="utf-8") as lines:
        return {ID.match(line)[1]: line for line in lines}


if __name__ == "__main__":
    {"exact": truth_of_suite, "mesa": mesa}[sys.argv[1]]()
