# SPDX-License-Identifier: MIT
"""tests/consumer, a project of somebody else, is built from the installed tree and passes."""
import unittest

from installed import CMAKE, ROOT, InstalledTest, run


class Consumer(InstalledTest):
    def test_it_is_built_and_passes(self):
        build = self.folder / "build"
        run(CMAKE, "-S", ROOT / "tests/consumer", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}",
            "-DCMAKE_BUILD_TYPE=Release", "-G", "Ninja", cwd=self.folder)
        run(CMAKE, "--build", build, cwd=self.folder)
        cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
        self.assertIn(f"edgecase_DIR:PATH={self.prefix}", cache)
        told = run("ctest", "--output-on-failure", cwd=build).stdout
        self.assertIn("100% tests passed, 0 tests failed out of 2", told)
        # The reason that a failing test gives is the judge's.
        wrong = run(build / "closed_edges_test", cwd=build, expect=1).stdout
        self.assertRegex(wrong, r"the sample \([^)]*\) lies exactly on the \w+ edge")


if __name__ == "__main__":
    unittest.main()
