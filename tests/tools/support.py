# SPDX-License-Identifier: MIT
"""What the tests of the whole command share: starting it, and cases, results and truths.

A test owns a temporary folder and runs the command there; it never touches the checkout. The
program is the built one (EDGECASE_BIN), the suite that of the checkout (EDGECASE_ROOT), both set by
tests/tools/CMakeLists.txt.
"""
import functools
import glob
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import results_file

HERE = pathlib.Path(__file__).resolve().parent
ROOT = pathlib.Path(os.environ.get("EDGECASE_ROOT", HERE.parent.parent))
BIN = pathlib.Path(os.environ.get("EDGECASE_BIN", ROOT / "build" / "release" / "bin"))
EDGECASE = str(BIN / "edgecase")
SUITE = str(ROOT / "cases")
# The suite but for its whole scenes: the fragments of one of those are as many as all others
# together have, and scenes_test.py is about them.
PROBES = [SUITE, "--exclude", "scenes/*"]
# Mesa ended OSMesa in 25.1.
FRONT_ENDS = ("osmesa", "egl") if glob.glob("/usr/lib/*/libOSMesa.so.*") else ("egl",)
MESA = [f"{front_end}:{driver}" for front_end in FRONT_ENDS for driver in ("llvmpipe", "softpipe")]
# What CI systems set, for their own shards for instance, must not reach the command under test.
CI_VARIABLES = ("CI", "TEST_TOTAL_SHARDS", "TEST_SHARD_INDEX", "TEST_SHARD_STATUS_FILE",
                "CI_NODE_TOTAL", "CI_NODE_INDEX")
# Seconds, for a command over the whole suite on a busy machine; builds that are slow need more.
PATIENCE = int(os.environ.get("EDGECASE_TEST_PATIENCE", "1200"))
# For one answer of a renderer: the command's own ten seconds, and as many more as builds are slow.
UNHURRIED = ["--timeout", str(PATIENCE // 120)]

# Exit codes.
AS_EXPECTED, UNEXPECTED, USAGE, INTERNAL, RENDERER, NOTHING_SELECTED, NOTHING_DRAWN = range(7)


@functools.cache
def mesa_release():
    """Mesa's release, as its drivers report it: "22.3.6". What each draws differs from release to
    release, so some tests are about one."""
    told = subprocess.run([EDGECASE, "backends", "egl:softpipe"], capture_output=True, text=True,
                          timeout=PATIENCE, env=environment(), check=True).stdout
    return re.search(r" Mesa (\d[\d.]*)", told)[1]


def environment(**more):
    result = {k: v for k, v in os.environ.items() if k not in CI_VARIABLES}
    result.update(more)
    return result


def triangle_case(**changes):
    """A well-formed case: a triangle with no sample on an edge. Keys can be replaced or added."""
    case = {
        "title": "A plain triangle",
        "rules": ["triangle.fill-rule"],
        "target": {"width": 8, "height": 8},
        "draws": [{"primitive": "triangles", "vertices": [[1, 1], [6.25, 1], [1, 6]]}],
    }
    case.update(changes)
    return case


def float32(value):
    """The bits of the float32 nearest to a number; NaN and infinities come as strings."""
    return struct.pack("<f", float(value))


def component_bits(fragment):
    """Colour and depth of a fragment, as float32."""
    return [float32(c) for c in fragment["color"]], float32(fragment["depth"])


def places(fragments):
    """Pixel, primitive and sample of what is covered."""
    return sorted((f["x"], f["y"], f["primitive"], s) for f in fragments
                  for s in range(f["coverage"].bit_length()) if f["coverage"] >> s & 1)


def drawings(rendering):
    """What was drawn at once: each pass of a supersampled scene, else the whole."""
    size = {key: rendering[key] for key in ("width", "height", "samples")}
    return [{**size, **drawn} for drawn in rendering.get("passes", [rendering])]


# What a release's llvmpipe says of samples: the numbers that it makes, and why none can be placed.
SAMPLES_OF_26 = ((4, 8), "this driver does not place the samples where the case asks for them")
SAMPLES_BEFORE = ((4,), "samples cannot be placed on this driver: it lacks GL_ARB_sample_locations")


CLAMPED_OFFSET = re.compile(r"output/offset/clamp:.*clamp=(?!0:)")


def known_not_run(renderer, name, samples):
    """Why one of MESA does not render a case with so many samples; none where it has to."""
    if renderer.endswith(":softpipe") and CLAMPED_OFFSET.match(name):
        return "polygon offsets cannot be clamped on this driver"
    if samples == 1:
        return None
    if renderer.endswith(":softpipe"):
        return "this driver has no multisampled targets"
    made, unplaced = SAMPLES_OF_26 if mesa_release().startswith("26.") else SAMPLES_BEFORE
    if name.startswith("samples/placed/"):
        return unplaced
    if samples in made:
        return None
    return f"asked for {samples} samples, this driver makes {', '.join(map(str, made))}"


class CommandTest(unittest.TestCase):
    """A test with a folder of its own, `self.folder`, in which the command runs."""

    maxDiff = 4000

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="edgecase-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def command(self, *arguments, expect=AS_EXPECTED, program=EDGECASE, **variables):
        """Runs the command; its exit code must be the expected one, or any if that is None."""
        run = subprocess.run([program, *map(str, arguments)], cwd=self.folder,
                             env=environment(**variables), stdin=subprocess.DEVNULL,
                             capture_output=True, text=True, timeout=PATIENCE)
        if expect is not None:
            self.assertEqual(run.returncode, expect, f"{arguments}\n{run.stdout}\n{run.stderr}")
        return run

    def results(self, *arguments, expect=AS_EXPECTED, **variables):
        """`edgecase run`, and the results that it wrote; `self.summary` is what it printed."""
        path = self.folder / "results.json"
        path.unlink(missing_ok=True)
        self.summary = self.command("run", *arguments, "--json", path, expect=expect,
                                    **variables).stdout
        return results_file.read(path)

    def write_results(self, name, results):
        return self.write(name, results_file.text_of(results))

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        text = content if isinstance(content, str) else json.dumps(content, indent=1)
        path.write_text(text, encoding="utf-8")
        return path

    def write_cases(self, *names):
        """Well-formed cases in the folder `cases`."""
        for name in names:
            self.write(f"cases/{name}.json", triangle_case(title=f"Triangle {name}"))

    def copy_suite(self, *folders):
        """These folders of the suite's cases, with what is known of renderers."""
        for folder in folders:
            shutil.copytree(f"{SUITE}/{folder}", self.folder / "cases" / folder)
        self.copy_knowledge()

    def copy_cases(self, files):
        """These files of the suite, with what is known of renderers."""
        for file in files:
            place = pathlib.Path(file).relative_to(SUITE)
            (self.folder / "cases" / place).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, self.folder / "cases" / place)
        shutil.copytree(f"{SUITE}/meshes", self.folder / "cases/meshes")
        self.copy_knowledge()

    def copy_knowledge(self):
        """Policies, profiles and known faults."""
        for folder in ("known", "policies", "profiles"):
            shutil.copytree(f"{SUITE}/{folder}", self.folder / "cases" / folder)

    def odd_renderer(self, behaviour, victim="", cases=SUITE):
        """exec: name of a program that answers as exact does, save for an odd behaviour."""
        truth = self.folder / "truth.jsonl"
        if cases == SUITE and not truth.exists():
            import suite_data  # which needs this module
            truth.symlink_to(suite_data.truth_of_suite())
        elif cases != SUITE:
            self.command("render", cases, "--json", truth, expect=None)
        words = [sys.executable, str(HERE / "odd_renderer.py"), behaviour, str(truth)]
        return "exec:" + " ".join(map(shlex.quote, words + ([victim] if victim else [])))


def processes_that_mention(text):
    """The numbers of processes with the text in their command line."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and text.encode() in (entry / "cmdline").read_bytes():
                found.append(int(entry.name))
        except OSError:
            pass  # it ended meanwhile
    return found


REPORTS = ("json", "junit", "html")


def report_options(folder):
    """The options that write each kind of report to a folder; a large page has files beside it."""
    return [word for kind in REPORTS for word in (f"--{kind}", f"{folder}/reports.{kind}")]


def contents(folder):
    """name -> bytes, of a folder's files."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def only_result(case):
    """The result of a case that one renderer ran."""
    (result,) = case["results"].values()
    return result


def verdicts(results):
    """id -> verdict, of results with one renderer."""
    return {case["id"]: only_result(case)["verdict"] for case in results["cases"]}
