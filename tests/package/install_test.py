# SPDX-License-Identifier: MIT
"""The installed command, from an empty folder: it finds its suite, policies, profiles, workers and
image library from its own place."""
import unittest

from installed import ROOT, InstalledTest, run
import results_file  # from tests/tools


class Installed(InstalledTest):
    def test_the_suite_is_the_default(self):
        ids = self.command("run", "--list").stdout.split()
        self.assertGreater(len(ids), 20000)
        self.assertIn("triangles/ties/flat-top", ids)
        self.command("validate", "--filter", "lines/short/*")

    def test_a_suite_here_goes_first(self):
        here = self.folder / "cases"
        here.mkdir()
        source = self.prefix / "share/edgecase/cases/triangles/ties/flat-top.json"
        (here / "mine.json").write_text(source.read_text(encoding="utf-8"), encoding="utf-8")
        try:
            self.assertEqual({name.split(":")[0] for name in
                              self.command("run", "--list").stdout.split()}, {"mine"})
            # Policies and profiles that it has none of are those of the installed suite.
            self.command("run", "--policy", "scotty3d", "--against", "exact", "--json", "-")
            self.command("run", "--policy", "profile", "--against", "egl:llvmpipe", "--json",
                         "-", expect=None)
        finally:
            (here / "mine.json").unlink()
            here.rmdir()

    def test_renderers_and_known_faults_are_found(self):
        """A renderer whose every difference is known is as expected: exit code 0."""
        self.command("run", "--filter", "lines/short/*", "--against", "egl:softpipe",
                     "--against", "egl:llvmpipe", "--json", "results.json", "--html", "report.html")
        results = results_file.read(self.folder / "results.json")
        verdicts = {one["results"]["egl:softpipe"]["verdict"] for one in results["cases"]}
        self.assertIn("violation", verdicts)
        self.assertGreater((self.folder / "report.html").stat().st_size, 100000)

    def test_the_suite_as_googletest_is_installed(self):
        told = run(self.prefix / "bin/edgecase-gtest", "--against", "egl:softpipe",
                   "--gtest_filter=lines/short.zero_length", cwd=self.folder)
        self.assertIn("[       OK ] lines/short.zero_length", told.stdout)

    def test_blessing_writes_beside_the_work(self):
        """What is installed is not written to, and a folder known here counts beside it."""
        softpipe = ["--filter", "lines/short/*", "--against", "egl:softpipe", "--json", "r.json"]
        (self.folder / "nothing").mkdir()
        self.command("run", *softpipe, "--known", "nothing", expect=1)
        self.command("bless", "r.json", "--apply")
        self.assertTrue((self.folder / "known/softpipe.json").is_file())
        installed = self.prefix / "share/edgecase/cases/known/softpipe.json"
        away = installed.rename(installed.with_name("away"))
        try:
            self.command("run", *softpipe)
        finally:
            away.rename(installed)

    def test_nothing_is_written_below_the_prefix(self):
        def files():
            return {path: path.stat().st_mtime_ns for path in self.prefix.rglob("*")}
        before = files()
        short = ["--filter", "lines/short/*"]
        self.command("run", *short, "--against", "mine=egl:softpipe", "--against", "exact")
        self.command("bless", "--apply")
        self.command("record", *short, "--against", "egl:softpipe", "-o", "softpipe.rec")
        self.command("new", "mine.json", "--from", "lines/short/zero-length")
        self.command("gallery", "direct3d-11")
        self.command("validate", *short)
        self.assertEqual(files(), before)

    def test_pictures_need_the_image_library(self):
        self.command("render", "--filter", "triangles/ties/flat-top", "--png", "pictures")
        (picture,) = self.folder.glob("pictures/triangles/ties/*.png")
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
        library = next(self.prefix.glob("lib*/**/libedgecase_image_io.so"))
        away = library.rename(library.with_name("away"))
        try:
            told = self.command("render", "--filter", "triangles/ties/flat-top", "--png",
                                "pictures", expect=3).stderr
            self.assertIn("cannot open the image library", told)
        finally:
            away.rename(library)

    def test_by_id_and_by_rule(self):
        told = self.command("minimize", "lines/diagonals/two-in-a-column", "--against",
                            "egl:softpipe")
        self.assertIn('"lines"', told.stdout)
        self.assertIn('"line.snap"', self.command("new", "-", "--rule", "line.snap").stdout)

    def test_no_path_of_the_checkout_is_left(self):
        """But for what a build without stripping keeps of its sources' names in assertions."""
        told = [self.command("--help").stdout, self.command("new", "--help").stdout,
                (self.prefix / "share/man/man1/edgecase.1").read_text(encoding="utf-8"),
                *(path.read_text(encoding="utf-8")
                  for path in self.prefix.glob("lib*/**/*.cmake"))]
        for text in told:
            self.assertNotIn(str(ROOT), text)


if __name__ == "__main__":
    unittest.main()
