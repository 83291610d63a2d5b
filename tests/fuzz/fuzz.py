# SPDX-License-Identifier: MIT
"""Runs the fuzz targets, each from seeds made of the repository's own files.

    python3 tests/fuzz/fuzz.py [--seconds N] [TARGET...]

EDGECASE_FUZZ_BIN has the targets (build/fuzz/bin), EDGECASE_BIN the command (build/release/bin),
which writes the seeds that are its own output. What a target learns stays in build/fuzz/corpus, and
the next run goes on from it. Exit code 1 where something was found: the input's path is printed,
and running the target with that path shows it again. An input that was a fault belongs into
tests/fuzz/found/TARGET, with which every run begins.
"""
import argparse
import json
import os
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
import zlib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TARGETS = pathlib.Path(os.environ.get("EDGECASE_FUZZ_BIN", ROOT / "build/fuzz/bin"))
BIN = pathlib.Path(os.environ.get("EDGECASE_BIN", ROOT / "build/release/bin"))
CORPUS = ROOT / "build/fuzz/corpus"
SCENES = re.findall(r'"\\"([\w/-]+)\\""', (HERE / "CMakeLists.txt").read_text(encoding="utf-8"))
# Seconds for one input. The most texels that a file may have take 0.3 s, and a hundred times as
# long where sanitizers watch every one of them on a busy machine.
PATIENCE = 120
# Where what leaks is a library's: of a broken PNG file OpenImageIO loses some 30 bytes.
LEAKING = {"image"}
END_SIZE = 26  # of a recording: size and checksum of its index


def edgecase(*arguments, cwd):
    """Runs the command; what it says of renderers and known faults does not matter here."""
    run = subprocess.run([BIN / "edgecase", *arguments], cwd=cwd, capture_output=True)
    if run.returncode in (2, 3):
        raise SystemExit(f"{arguments}: {run.stderr.decode()}")


def files(*patterns, most=1 << 16):
    paths = [path for pattern in patterns for path in sorted(ROOT.glob(pattern))]
    return [path.read_bytes() for path in paths
            if path.is_file() and path.stat().st_size <= most]


def case_seeds(_):
    # Those of limits would take all of a short run's time.
    return [text for text in files("tests/casefile/good/*.json", "tests/casefile/bad*/*.json",
                                   "cases/**/s*.json", most=4096) if b"1024, 1024" not in text]


def policy_seeds(_):
    return files("cases/policies/*.json", "cases/profiles/*.json", "cases/galleries/*.json")


def known_fault_seeds(_):
    return files("cases/known/*.json")


def decision_seeds(_):
    example = re.search(r"```json\n(\{\n  \"edgecase_decisions\".*?)```",
                        (ROOT / "reports/pages/reviewing.md").read_text(encoding="utf-8"),
                        re.DOTALL)[1]
    other = json.loads(example)
    other["decisions"][0].update(decision="reject", renderer="egl:softpipe")
    return [example.encode(), json.dumps(other).encode()]


def result_seeds(folder):
    seeds = []
    for number, scene in enumerate(SCENES):
        path = folder / f"{number}.zst"
        edgecase("run", ROOT / "cases" / f"{scene}.json", "--against", "egl:softpipe",
                 "--against", "exact", "--json", path, cwd=folder)
        packed = path.read_bytes()
        seeds += [packed, subprocess.run(["zstdcat"], input=packed, capture_output=True).stdout]
    return seeds


def recording_seeds(folder):
    edgecase("record", ROOT / "cases/lines/short", "--against", "exact", "-o", "all.rec",
             cwd=folder)
    whole = (folder / "all.rec").read_bytes()
    size = int(whole[-END_SIZE:-END_SIZE + 16], 16)
    index = whole[-END_SIZE - size:-END_SIZE]
    text = zlib.decompress(index[index.index(b"\x78"):])
    entries = json.loads(text)
    begin = entries["head"]["size"]
    block = whole[begin:begin + entries["blocks"][0]["size"]]
    return [b"r" + whole, b"i" + text, b"b" + block]


def answer_seeds(folder):
    programs = [[str(BIN / "edgecase-gl"), "egl-surfaceless"],
                [sys.executable, str(ROOT / "reference/examples/rasterizer.py")]]
    seeds = []
    for number, scene in enumerate(SCENES):
        for program in programs:
            answers = folder / "answers"
            line = f"{shlex.join(program)} | tee {shlex.quote(str(answers))}"
            edgecase("render", ROOT / "cases" / f"{scene}.json", "--with", f'exec:sh -c "{line}"',
                     "--json", "rendered.jsonl", cwd=folder)
            seeds += [bytes([number]) + answer for answer in answers.read_bytes().splitlines()[:2]]
    return seeds


def compare_seeds(_):
    # Decisions, not files: any bytes are a scene, an answer to it and what is wrong with that.
    decide = random.Random(62)
    return [decide.randbytes(decide.randint(12, 48)) for _ in range(200)]


def mesh_seeds(_):
    return [text[:4096] for text in files("cases/**/*.obj", "tests/**/*.obj", most=1 << 20)]


def image_seeds(folder):
    edgecase("render", ROOT / "cases/lines/short", "--png", "pictures", cwd=folder)
    rendered = [path.read_bytes() for path in sorted(folder.glob("pictures/**/*.png"))[:4]]
    return rendered + files("tests/**/*.png", "tests/**/*.exr", most=8192)


SEEDS = {"case_file": case_seeds, "policy": policy_seeds, "known_faults": known_fault_seeds,
         "decisions": decision_seeds, "results": result_seeds, "recording": recording_seeds,
         "answer": answer_seeds, "compare": compare_seeds, "mesh": mesh_seeds, "image": image_seeds}


def write_seeds(target, folder):
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        seeds = SEEDS[target](pathlib.Path(work))
    if not seeds:
        raise SystemExit(f"{target} has no seeds")
    for number, seed in enumerate(seeds):
        (folder / f"{number:04}").write_bytes(seed)


def fuzz(target, seconds):
    """Did it find nothing?"""
    learnt, seeds, finds = (CORPUS / target / name for name in ("learnt", "seeds", "finds"))
    write_seeds(target, seeds)
    for folder in (learnt, finds):
        folder.mkdir(parents=True, exist_ok=True)
    kept = HERE / "found" / target
    run = subprocess.run(
        [TARGETS / f"fuzz_{target}", learnt, seeds, *([kept] if kept.is_dir() else []),
         f"-max_total_time={seconds}", f"-timeout={PATIENCE}", "-rss_limit_mb=2560",
         "-max_len=65536",
         "-print_final_stats=1", f"-artifact_prefix={finds}/"],
        cwd=ROOT, capture_output=True, text=True, errors="replace",
        env={**os.environ, "ASAN_OPTIONS": f"detect_leaks={int(target not in LEAKING)}"})
    asked = re.search(r"number_of_executed_units: (\d+)", run.stderr)
    covered = re.findall(r" cov: (\d+)", run.stderr)
    print(f"{target}: {asked[1] if asked else '?'} inputs, {covered[-1] if covered else '?'} edges "
          f"covered, {'nothing found' if run.returncode == 0 else 'FOUND'}", flush=True)
    if run.returncode != 0:
        print(run.stderr[-4000:], flush=True)
    return run.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", choices=[*SEEDS, []], metavar="TARGET",
                        help=", ".join(SEEDS))
    parser.add_argument("--seconds", type=int, default=10, help="for each target (default: 10)")
    options = parser.parse_args()
    outcomes = [fuzz(target, options.seconds) for target in options.targets or SEEDS]
    sys.exit(0 if all(outcomes) else 1)


if __name__ == "__main__":
    main()
