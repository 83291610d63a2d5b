# SPDX-License-Identifier: MIT
"""An installed tree for a test: what the build folder (EDGECASE_BUILD) installs, in a folder that
is then moved, so that nothing in it can rely on where it was installed."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["EDGECASE_ROOT"])
BUILD = pathlib.Path(os.environ["EDGECASE_BUILD"])
CMAKE = os.environ.get("CMAKE_COMMAND", "cmake")
sys.path.insert(0, str(ROOT / "tests" / "tools"))

PATIENCE = 600  # seconds


def run(*command, cwd, expect=0, env=None):
    """Runs a program; its output when it ends with the expected code (any, if that is None)."""
    done = subprocess.run([str(word) for word in command], cwd=cwd, env=env, text=True,
                          stdin=subprocess.DEVNULL, capture_output=True, timeout=PATIENCE)
    if expect is not None and done.returncode != expect:
        raise AssertionError(f"{command}: exit {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done


class InstalledTest(unittest.TestCase):
    """A test with an installed tree, `self.prefix`, and an empty folder to work in."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="edgecase-installed-")
        cls.addClassCleanup(folder.cleanup)
        here = pathlib.Path(folder.name)
        run(CMAKE, "--install", BUILD, "--prefix", here / "first", cwd=here)
        cls.prefix = (here / "first").rename(here / "moved prefix")
        cls.program = cls.prefix / "bin" / "edgecase"
        cls.folder = here / "work"
        cls.folder.mkdir()

    def command(self, *arguments, expect=0):
        return run(self.program, *arguments, cwd=self.folder, expect=expect)
