# SPDX-License-Identifier: MIT
"""tools/lint on sources with one fault each, and without: what it says, and its exit code."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CLEAN = """#include <string>

std::string doubled(const std::string& text) {
  return text + text;
}
"""
NOT_RUN = 77
UNFORMATTED = CLEAN.replace("  return", "return")
NARROWING = "int whole(double number);\nint whole(double number) { return number; }\n"
COPYING = CLEAN.replace("const std::string& text", "const std::string text")
# The precompiled header has this name too, so that only the file alone tells.
SHADOWING_ELSEWHERE = """namespace edgecase {
int next(int kMaxSamples);
int next(int kMaxSamples) { return kMaxSamples + 1; }
}  // namespace edgecase
"""


class Lint(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def lint(self, step, text, asked="file.cpp"):
        """(exit code, what it says) of a file with this text, or of another name."""
        path = self.folder / "file.cpp"
        path.write_text(text, encoding="utf-8")
        entry = {"directory": str(self.folder), "file": "file.cpp",
                 "command": f"c++ -DFMT_SHARED -I{ROOT}/src -I{ROOT} -Wall -Wextra -Wconversion "
                            "-Wshadow -O3 -std=c++20 -o file.o -c file.cpp"}
        build = self.folder / "build"
        build.mkdir(exist_ok=True)
        (build / "compile_commands.json").write_text(json.dumps([entry]), encoding="utf-8")
        done = subprocess.run([ROOT / "tools/lint", step, self.folder / asked],
                              env={**os.environ, "EDGECASE_BUILD": str(build)},
                              capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def check(self, step, faulty, named):
        if self.lint(step, CLEAN)[0] == NOT_RUN:
            self.skipTest("another clang-format")
        self.assertEqual(self.lint(step, CLEAN), (0, f"tools/lint: {step}: no fault\n"))
        code, text = self.lint(step, faulty)
        self.assertEqual(code, 1)
        self.assertIn(named, text)
        self.assertIn("faults, see above", text)

    def test_format(self):
        self.check("format", UNFORMATTED, "clang-format-violations")

    def test_tidy(self):
        self.check("tidy", COPYING, "performance-unnecessary-value-param")

    def test_warnings(self):
        self.check("warnings", NARROWING, "-Wfloat-conversion")
        self.assertEqual(self.lint("warnings", SHADOWING_ELSEWHERE)[0], 0)

    def test_a_folder_is_all_sources_below_it(self):
        code, text = self.lint("format", UNFORMATTED, ".")
        if code == NOT_RUN:
            self.skipTest("another clang-format")
        self.assertEqual(code, 1, text)
        self.assertIn("file.cpp:", text)
        self.assertEqual(self.lint("format", CLEAN, ".")[0], 0)

    def test_what_cannot_be_read_is_no_success(self):
        code, text = self.lint("tidy", CLEAN, "other.cpp")
        self.assertEqual(code, 1)
        self.assertIn("no such file", text)
        (self.folder / "other.cpp").write_text(CLEAN, encoding="utf-8")
        code, text = self.lint("tidy", CLEAN, "other.cpp")
        self.assertEqual(code, 1)
        self.assertIn("does not compile", text)


if __name__ == "__main__":
    unittest.main()
