# SPDX-License-Identifier: MIT
"""The Debian packages that CPack makes: their fields, their files, and the command unpacked."""
import pathlib
import tempfile
import unittest

from installed import BUILD, run


def field(package, name):
    return run("dpkg-deb", "-f", package, name, cwd="/").stdout.strip()


class Debian(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="edgecase-debian-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", cls.folder, cwd=cls.folder)
        cls.packages = {field(path, "Package"): path for path in cls.folder.glob("*.deb")}

    def test_there_are_two(self):
        self.assertEqual(set(self.packages), {"edgecase", "libedgecase-dev"})

    def test_dependencies(self):
        depends = field(self.packages["edgecase"], "Depends")
        for name in ("libc6", "libfmt", "libopenimageio", "libegl1"):
            self.assertIn(name, depends)
        for name in ("libedgecase", "libgtest", "-dev"):
            self.assertNotIn(name, depends)
        version = field(self.packages["edgecase"], "Version")
        self.assertIn(f"edgecase (= {version})", field(self.packages["libedgecase-dev"], "Depends"))

    def test_files(self):
        names = run("dpkg-deb", "-c", self.packages["edgecase"], cwd="/").stdout
        for name in ("/usr/bin/edgecase", "/edgecase-gl", "/usr/share/man/man1/edgecase.1",
                     "/usr/share/edgecase/cases/case.schema.json",
                     "/usr/share/edgecase/cases/profiles/osmesa-llvmpipe.json",
                     "/usr/share/edgecase/viewer/main.js",
                     "/usr/share/doc/edgecase/README.md",
                     "/usr/share/doc/edgecase/changelog.gz",
                     "/usr/share/doc/edgecase/reference/PROTOCOL.md",
                     "/usr/share/doc/edgecase/reference/examples/triangles.py",
                     "/usr/share/doc/edgecase/reports/pages/reviewing.md",
                     "/usr/share/bash-completion/completions/edgecase"):
            self.assertIn(f"{name}\n", names)
        self.assertNotIn(".a\n", names)
        names = run("dpkg-deb", "-c", self.packages["libedgecase-dev"], cwd="/").stdout
        for name in ("/edgecaseConfig.cmake", "/libedgecase_raster.a",
                     "/usr/include/edgecase/raster/rasterizer.h"):
            self.assertIn(f"{name}\n", names)

    def test_the_unpacked_command_works(self):
        root = self.folder / "root"
        run("dpkg-deb", "-x", self.packages["edgecase"], root, cwd=self.folder)
        told = run(root / "usr/bin/edgecase", "run", "--filter", "lines/short/*", "--against",
                   "egl:softpipe", cwd=self.folder)
        self.assertIn("egl:softpipe", told.stdout)


if __name__ == "__main__":
    unittest.main()
