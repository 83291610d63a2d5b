# SPDX-License-Identifier: MIT
"""The scripts of our pages hold what their types say: TypeScript finds nothing in them, and does find
a fault where there is one."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
TSC = HERE / "node_modules" / "typescript" / "bin" / "tsc"
VIEWER = HERE.parent.parent / "reports" / "viewer"
DRAWING = HERE.parent.parent / "reference" / "web"


def faults(folder):
    run = subprocess.run(["node", str(TSC), "-p", str(folder / "tsconfig.json")],
                         capture_output=True, text=True, timeout=300)
    return run.stdout + run.stderr


class Types(unittest.TestCase):
    def test_the_viewer_has_no_fault(self):
        self.assertEqual(faults(VIEWER), "")

    def test_the_page_that_draws_has_no_fault(self):
        self.assertEqual(faults(DRAWING), "")

    def test_a_fault_is_found(self):
        with tempfile.TemporaryDirectory(prefix="edgecase-types-") as name:
            copy = pathlib.Path(name) / "viewer"
            shutil.copytree(VIEWER, copy)
            with open(copy / "main.js", "a", encoding="utf-8") as script:
                script.write("new View(8, 8).zoomm(3);\n")
            self.assertIn("zoomm", faults(copy))


if __name__ == "__main__":
    unittest.main()
