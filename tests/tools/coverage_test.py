# SPDX-License-Identifier: MIT
"""What tools/coverage counts of a program of which each line and branch is known."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools/coverage"
SOURCES = {
    # Of a program that is run without an argument: lines 3, 4 and 6, and there "zero".
    "src/sign.cpp": """#include <string>
#include "sign.h"
std::string sign(int number) {
  if (number < 0)
    return std::string("negative, ") + "and far from small";
  return larger(number, 0) > 0 ? "positive" : "zero";
}
""",
    # The branch of line 5 that leads to line 7.
    "src/sign.h": """#pragma once
#include <string>
std::string sign(int number);
template <class T> T larger(T a, T b) {
  if (a > b)
    return a;
  return b;
}
""",
    "src/deep/never.cpp": "int never() {\n  return 1;\n}\n",
    "reports/print.cpp": """#include <cstdio>
#include <string>
void print(const std::string& text) {
  std::puts(text.c_str());
}
""",
    "reports/print.h": "void print(const std::string& text);\n",
    "tests/main.cpp": """#include "../src/sign.h"
#include "../reports/print.h"
int main(int count, char**) { print(sign(count - 1)); }
""",
}
TABLE = """\
                 lines     run         branches   taken
reports              3       3  100.0 %       0       0  100.0 %
src                  7       5   71.4 %       6       3   50.0 %
src/deep             2       0    0.0 %       0       0  100.0 %
all of src           9       5   55.6 %       6       3   50.0 %
all of reports       3       3  100.0 %       0       0  100.0 %
total               12       8   66.7 %       6       3   50.0 %
"""
UNCOVERED = """\
src/sign.cpp:5: return std::string("negative, ") + "and far from small";
src/sign.h:6: return a;
"""


class Coverage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="edgecase-coverage-")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        for name, text in SOURCES.items():
            path = self.root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        self.build = self.root / "build/coverage"
        self.program = self.build / "main"
        objects = [self.compiled(name) for name in SOURCES
                   if name.endswith(".cpp") and name != "tests/main.cpp"]
        self.compiler("../../tests/main.cpp", *objects, "-o", self.program)

    def compiled(self, name):
        """As CMakeLists.txt has it compiled, by a path from the build folder."""
        made = self.build / name.replace(".cpp", ".o")
        made.parent.mkdir(parents=True, exist_ok=True)
        self.compiler("-O1", "-fno-ssa-phiopt", "-c", f"../../{name}", "-o", made)
        return made

    def compiler(self, *arguments):
        subprocess.run(["c++", "--coverage", *arguments], cwd=self.build, check=True)

    def run_program(self, *arguments):
        subprocess.run([self.program, *arguments], check=True, capture_output=True)

    def coverage(self, *arguments):
        """(exit code, output, errors)"""
        done = subprocess.run([TOOL, "--again", *arguments], cwd=self.root, capture_output=True,
                              env={**os.environ, "EDGECASE_ROOT": str(self.root)}, text=True,
                              check=False)
        return done.returncode, done.stdout, done.stderr

    def test_lines_and_branches(self):
        self.run_program()
        self.assertEqual(self.coverage(), (0, TABLE, ""))
        self.assertEqual(self.coverage("--uncovered", "src/sign.cpp", "--uncovered", "src/sign.h"),
                         (0, UNCOVERED + TABLE, ""))

    def test_runs_add_up(self):
        self.run_program()
        self.run_program("positive")
        code, table, _ = self.coverage("--uncovered", "src/sign.cpp")
        self.assertEqual(code, 0)
        self.assertEqual(table.splitlines()[0], UNCOVERED.splitlines()[0])
        self.assertIn("src                  7       6   85.7 %       6       5   83.3 %", table)

    def test_json(self):
        self.run_program()
        self.assertEqual(self.coverage("--json", "counts.json")[0], 0)
        counts = json.loads((self.root / "counts.json").read_text(encoding="utf-8"))
        self.assertEqual(sorted(counts), ["reports/print.cpp", "src/deep/never.cpp", "src/sign.cpp",
                                          "src/sign.h"])
        self.assertEqual(counts["src/sign.cpp"], {"lines": 4, "run": 3, "branches": 4, "taken": 2,
                                                  "uncovered": [5]})
        self.assertEqual(counts["src/deep/never.cpp"]["uncovered"], [1, 2])

    def test_least(self):
        self.run_program()
        self.assertEqual(self.coverage("--least", "55.5"), (0, TABLE, ""))
        self.assertEqual(self.coverage("--least", "56"), (
            1, TABLE, "tools/coverage: fewer than 56 % of the lines of src were run\n"))

    def test_nothing_counted(self):
        code, output, errors = self.coverage()
        self.assertEqual((code, output), (5, ""))
        self.assertIn("nothing was counted", errors)

    def test_usage(self):
        code, _, errors = self.coverage("--uncovered", "src/none.cpp")
        self.assertEqual(code, 2)
        self.assertIn("there is no src/none.cpp", errors)


if __name__ == "__main__":
    unittest.main()
