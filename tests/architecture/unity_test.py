# SPDX-License-Identifier: MIT
"""tools/unity.py puts into one file only what may share one, and leaves nothing out."""
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import unity  # noqa: E402  the path comes first

HIDDEN = "namespace edgecase {{\nnamespace {{\n\n{}\n\n}}  // namespace\n}}  // namespace edgecase\n"


class Batches(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def together(self, *texts):
        """Whether the sources with these texts share a file."""
        paths = [self.write(f"{i}.cpp", text) for i, text in enumerate(texts)]
        found = unity.batches(paths)
        self.assertEqual(sorted(sum(found, [])), sorted(paths))
        return len(found) == 1

    def hidden(self, one, other):
        return self.together(HIDDEN.format(one), HIDDEN.format(other))

    def test_each_names_what_no_other_does(self):
        self.assertTrue(self.hidden("constexpr int kOne = 1;", "constexpr int kTwo = 2;"))
        self.assertTrue(self.hidden("int one() {\n  int two = 2;\n  return two;\n}",
                                    "int two() {\n  return 2;\n}"))

    def test_one_name_for_two_things(self):
        for one, other in (("constexpr int kOne = 1;", "constexpr double kOne = 1;"),
                           ("constexpr int kOne = 1;", "const std::array<int, 2> kOne = {1, 1};"),
                           ("constexpr int kOne = 1, kTwo = 2;", "constexpr int kTwo = 2;"),
                           ("constexpr int kOnes[] = {1};", "constexpr int kOnes[][1] = {{1}};"),
                           ("int f(int n) {\n  return n;\n}", "double f(double x) {\n  return x;\n}"),
                           ("::testing::Result f(int n) {\n}", "void f() {\n}"),
                           ("struct Pair {\n  int a;\n};", "class Pair final : public Two {\n};"),
                           ("enum Part : int { kFirst, kLast };", "constexpr int kLast = 7;"),
                           ("constexpr int kOne = 1;", "int f() {\n  constexpr int kOne = 1;\n}"),
                           ("using Pair = std::pair<int, int>;", "using Pair = Two<int>;")):
            with self.subTest(one=one, other=other):
                self.assertFalse(self.hidden(one, other))
                self.assertFalse(self.hidden(other, one))

    def test_one_name_for_one_thing(self):
        for same in ("using Pair = std::pair<int, int>;", "using ::testing::HasSubstr;"):
            self.assertTrue(self.hidden(same, same))

    def test_what_a_header_declares_another_source_does_not_hide(self):
        self.write("axis.h", '#include "place.h"\n\nenum class Axis { x, y };\n')
        self.write("place.h", "struct Place {\n  int x;\n};\n\nPlace place_of(Axis axis);\n")
        user = '#include "axis.h"\n'
        for name in ("struct Axis {\n  int n;\n};", "int place_of(int n) {\n  return n;\n}"):
            self.assertFalse(self.together(user, HIDDEN.format(name)))
            self.assertFalse(self.together(HIDDEN.format(name), user))
        self.assertTrue(self.together(user, HIDDEN.format("constexpr int kOne = 1;")))

    def test_macros_stay_alone(self):
        self.assertFalse(self.together("#define MAX 2\n", ""))
        self.assertFalse(self.together("", "#define MAX 2\n"))

    def test_a_file_holds_so_many(self):
        self.assertTrue(self.together(*[""] * unity.MOST))
        self.assertFalse(self.together(*[""] * (unity.MOST + 1)))

    def test_what_has_not_changed_is_not_written_again(self):
        source = self.write("a.cpp", "")
        unity.main(self.folder / "out", source)
        file = self.folder / "out/unity_0.cpp"
        self.assertEqual(file.read_text(encoding="utf-8"), f'#include "{source}"\n')
        before = file.stat().st_mtime_ns
        unity.main(self.folder / "out", source)
        self.assertEqual(file.stat().st_mtime_ns, before)


if __name__ == "__main__":
    unittest.main()
