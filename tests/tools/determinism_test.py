# SPDX-License-Identifier: MIT
"""tools/determinism on a sample of the suite: the same bytes on one core and two, by every SIMD
target, by none, and as libm is on an older processor. A program that writes one byte otherwise is
found, and so is one that cannot be asked."""
import shlex
import shutil
import subprocess
import unittest

from suite_data import COUNT, files_of_share, in_share
from support import EDGECASE, PATIENCE, ROOT, SUITE, CommandTest, environment

TOOL = ROOT / "tools/determinism"
# Without whole scenes: as many fragments as in all others together.
FOLDERS = ("clipping", "lines", "output", "points", "samples", "surfaces", "textures", "triangles",
           "values")

# Answers as the command does, but the file that follows the option named is spoilt at one place.
SPOILING = """#!/bin/sh
{command} "$@"
code=$?
while [ $# -gt 1 ]; do
  [ "$1" = {option} ] && printf '\\377' | dd of="$2" bs=1 seek={at} conv=notrunc 2>/dev/null
  shift
done
exit $code
"""


class Determinism(CommandTest):
    def compare(self, *arguments):
        """(exit code, what it says)"""
        run = subprocess.run([TOOL, *map(str, arguments)], env=environment(), capture_output=True,
                             text=True, timeout=PATIENCE, check=False)
        return run.returncode, run.stdout + run.stderr

    def test_a_sample_is_the_same_each_time(self):
        sample = ["--share", "1/120", *(f"{SUITE}/{folder}" for folder in FOLDERS)]
        if COUNT > 1:
            self.copy_cases(files_of_share(*FOLDERS))
            sample = ["--share", "1/20", self.folder / "cases"]
        code, text = self.compare("--program", EDGECASE, *sample)
        self.assertEqual(code, 0, text)
        lines = text.splitlines()
        self.assertTrue(all(line.endswith(": the same") for line in lines[1:-1]), text)
        self.assertTrue(lines[-1].endswith(" cases: the same bytes each time"), text)
        ways = [line.split(":")[0] for line in lines]
        for way in ("on one core", "on two cores", "kernels none",
                    "libm without FMA"):
            self.assertIn(way, ways)

    def test_one_byte_is_found(self):
        for option, name in in_share((("--csv", "report.csv"), ("-o", "exact.rec"))):
            case = self.folder / "one.json"
            shutil.copy(f"{SUITE}/lines/short/between-diamonds.json", case)
            program = self.folder / "spoiling"
            program.write_text(SPOILING.format(command=shlex.quote(str(EDGECASE)), option=option,
                                               at=50), encoding="utf-8")
            program.chmod(0o755)
            code, text = self.compare("--program", EDGECASE, "--program", program, case)
            self.assertEqual(code, 1, text)
            self.assertIn(f"{name} differs at byte 50, line ", text)
            self.assertIn("differences, see above", text)
            self.assertEqual(text.count(" differs "), 1, text)

    def test_what_cannot_be_compared_is_no_success(self):
        code, text = self.compare("--program", EDGECASE, self.folder / "none")
        self.assertEqual(code, 2, text)
        code, text = self.compare("--program", "/bin/true", SUITE)
        self.assertEqual(code, 2, text)
        code, text = self.compare("--trees", "g++-O7")
        self.assertEqual(code, 2, text)
        self.assertIn("no such tree: g++-O7", text)


class Kernels(CommandTest):
    def test_a_kernel_that_there_is_not_is_refused(self):
        run = self.command("--version", expect=2, EDGECASE_KERNELS="mmx")
        self.assertIn('EDGECASE_KERNELS="mmx"', run.stderr)
        self.assertIn(", none", run.stderr)


if __name__ == "__main__":
    unittest.main()
