# SPDX-License-Identifier: MIT
"""architecture.py and paths.py must be able to fail: each fault is planted in a small tree and must
be found."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))
import architecture  # noqa: E402
import paths  # noqa: E402

LICENCE = "// SPDX-License-Identifier: MIT\n"

CLEAN = {
    "src/exact/fixed.h": 'double to_double() const { return 0; }\n',
    "src/exact/interval.h": "struct Interval { double low = 0.5; };\n",
    "src/model/scene.h": '#include <vector>\n#include "exact/fixed.h"\n',
    "src/rules/coverage/triangle_fill.cpp":
        '#include "model/scene.h"\n// In pixels; for people only.\n'
        "double distance_inside(int a) {\n  return .5 * a;\n}\n"
        'int decide() {\n  return 1;  // not 0.5, a double\n}\nconst char* kText = "double 0.5";\n',
    "src/rules/textures/a.h": "auto x = std::ldexp(std::floor(y), std::ilogb(z));  // std::log2(y)\n",
    "src/results/results_json.cpp": '#include <nlohmann/json.hpp>\n#include "model/scene.h"\n',
    "reference/gl.cpp": '#include <EGL/egl.h>\n#include <glad/gl.h>\n#include "wire/a.h"\n',
    "reports/html.cpp": '#include "results/results.h"\n#include "reports/html.h"\n',
    "tools/edgecase/main.cpp": '#include <CLI/CLI.hpp>\n#include "reports/html.h"\n',
    "tests/model/a_test.cpp": '#include <gtest/gtest.h>\n#include "run/run.h"\n',
}

# Not the same: what is declared only, or lies in another namespace.
CLEAN |= {
    "src/wire/answer.h": "namespace edgecase {\nstruct Answer {\n  int a;\n};\n}\n",
    "src/wire/later.h": "namespace edgecase {\nstruct Answer;\n}\n",
    "src/wire/other.h": "namespace edgecase::wire {\nclass Answer final : Base {\n};\n}\n",
}

# Rooms of one module: downwards, within one, and from the top.
CLEAN |= {
    "src/casefile/json/a.h": '#include "casefile/json/b.h"\n',
    "src/casefile/sweep/a.cpp": '#include "casefile/scene/a.h"\n#include "casefile/json/a.h"\n',
    "src/casefile/a.cpp": '#include "casefile/a.h"\n#include "casefile/sweep/a.h"\n',
    "src/diff/output/a.cpp": '#include "diff/coverage/a.h"\n#include "diff/values/a.h"\n',
    "src/diff/a.cpp": '#include "diff/textures/a.h"\n#include "diff/samples/a.h"\n',
}

# A file, what stands in it, and what must be said of it.
FAULTS = [
    ("src/exact/a.h", '#include "model/scene.h"', "exact may not use model"),
    ("src/model/a.h", '#include "rules/rule.h"', "model may not use rules"),
    ("src/rules/a.cpp", '#include "raster/rasterizer.h"', "rules may not use raster"),
    ("src/raster/a.cpp", '#include "diff/judge.h"', "raster may not use diff"),
    ("src/rules/a.cpp", '#include "kernels/span_walk.h"', "rules may not use kernels"),
    ("src/kernels/a.h", '#include "raster/rasterizer.h"', "kernels may not use raster"),
    ("src/results/a.cpp", '#include "raster/rasterizer.h"', "results may not use raster"),
    ("src/results/a.cpp", '#  include   "diff/judge.h"', "results may not use diff"),
    ("src/wire/a.cpp", '#include "casefile/loader.h"', "wire may not use casefile"),
    ("src/casefile/a.cpp", '#include "wire/json_values.h"', "casefile may not use wire"),
    ("src/casefile/json/z.h", '#include "casefile/mesh/a.h"', "lies above json"),
    ("src/casefile/mesh/z.cpp", '#include "casefile/scene/a.h"', "lies above mesh"),
    ("src/casefile/scene/z.cpp", '#include "casefile/sweep/a.h"', "lies above scene"),
    ("src/casefile/sweep/z.cpp", '#include "casefile/loader.h"', "lies above sweep"),
    ("src/casefile/z.cpp", '#include "casefile/other/a.h"', "no such folder"),
    ("src/diff/coverage/z.cpp", '#include "diff/values/a.h"', "lies above coverage"),
    ("src/diff/values/z.h", '#include "diff/samples/a.h"', "lies above values"),
    ("src/diff/samples/z.cpp", '#include "diff/textures/a.h"', "lies above samples"),
    ("src/diff/textures/z.h", '#include "diff/compare.h"', "lies above textures"),
    ("src/diff/a.cpp", '#include "results/results.h"', "diff may not use results"),
    ("src/run/a.cpp", '#include "reports/html.h"', "run may not use reports"),
    ("reports/a.cpp", '#include "raster/rasterizer.h"', "reports may not use raster"),
    ("reports/a.cpp", '#include "diff/judge.h"', "reports may not use diff"),
    ("reference/a.cpp", '#include "raster/rasterizer.h"', "reference may not use raster"),
    ("src/run/a.cpp", '#include "tests/raster/random_scenes.h"', "module's folder"),
    ("src/run/a.cpp", '#include "run.h"', "module's folder"),
    ("src/diff/a.cpp", "#include <nlohmann/json.hpp>", "diff may not use <nlohmann"),
    ("src/diff/a.cpp", "#include <nlohmann/json_fwd.hpp>", "diff may not use <nlohmann"),
    ("src/wire/a.h", "#include <nlohmann/json.hpp>", "in a header"),
    ("src/casefile/a.cpp", "#include <OpenImageIO/imageio.h>", "casefile may not use <OpenImage"),
    ("tools/edgecase/a.cpp", "#include <EGL/egl.h>", "tools may not use <EGL"),
    ("src/run/a.cpp", "#include <glad/gl.h>", "run may not use <glad"),
    ("src/raster/a.cpp", "#include <glm/vec2.hpp>", "raster may not use <glm"),
    ("src/raster/a.cpp", "#include <hwy/highway.h>", "raster may not use <hwy"),
    ("src/kernels/a.h", "float x;", "float: coverage"),
    ("reference/a.cpp", "#include <tiny_obj_loader.h>", "reference may not use <tiny_obj"),
    ("src/run/a.cpp", "#include <gtest/gtest.h>", "run may not use <gtest"),
    ("src/exact/a.h", "float x;", "float: coverage"),
    ("src/exact/fixed.h", "double to_double();\ndouble y;", "double: coverage"),
    ("src/rules/coverage/a.cpp", "auto x = y.to_double();", "to_double: coverage"),
    ("src/rules/coverage/a.cpp", "const auto half = .5;", ".5: coverage"),
    ("src/rules/coverage/a.cpp", "const auto half = 1e3 + 5.0f;", "5.0f: coverage"),
    ("src/rules/coverage/triangle_fill.cpp", "double distance_inside() {\n  return 1;\n}\n",
     "for people only"),
    ("src/rules/coverage/triangle_fill.cpp",
     "// for people only\ndouble distance_inside() {\n  return 1;\n}\nint f() { return 0.5; }\n",
     "0.5: coverage"),
    ("src/rules/coverage/triangle_fill.cpp", "int f();", "not here"),
    ("src/rules/values/a.cpp", "auto x = std::log2(y);", "std::log2: exact/elementary.h"),
    ("src/diff/a.cpp", "// close within EPSI" "LON", "the word"),
    ("tests/diff/a.cpp", "// TO" "DO: later", "the word"),
    ("src/wire/z.h", "namespace edgecase {\nstruct Answer {\n};\n}", "is in src/wire/answer.h, too"),
    ("src/wire/z.h", "namespace edgecase {\nenum class Answer { yes };\n}", "edgecase::Answer is in"),
    ("reports/viewer/a.js", "// FIX" "ME", "the word"),
    ("reports/viewer/a.js", "\n" * 601, "lines; a file has 600"),
]


def plant(root, files):
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(LICENCE + text, encoding="utf-8")


class Architecture(unittest.TestCase):
    def faults_of(self, files):
        with tempfile.TemporaryDirectory() as folder:
            plant(Path(folder), files)
            found, _ = architecture.check(Path(folder))
        return [f"{path}:{line}: {what}" for path, line, what in found]

    def test_a_clean_tree_has_no_faults(self):
        self.assertEqual(self.faults_of(CLEAN), [])

    def test_each_planted_fault_is_found_where_it_is(self):
        for name, text, said in FAULTS:
            with self.subTest(name=name, text=text[:60]):
                found = self.faults_of({**CLEAN, name: text + "\n"})
                self.assertTrue(any(name in one and said in one for one in found), found)

    def test_a_missing_licence_line_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "src/run").mkdir(parents=True)
            (Path(folder) / "src/run/a.cpp").write_text("int a;\n")
            found, _ = architecture.check(Path(folder))
        self.assertEqual([what for _, _, what in found], ["no licence line"])

    def run_on(self, files):
        with tempfile.TemporaryDirectory() as folder:
            plant(Path(folder), files)
            return subprocess.run([sys.executable, "-B", architecture.__file__, folder],
                                  capture_output=True, text=True, check=False)

    def test_the_program_fails_on_a_fault_and_on_nothing_read(self):
        faulty = self.run_on({**CLEAN, "src/exact/a.h": '#include "run/run.h"\n'})
        self.assertEqual(faulty.returncode, 1)
        self.assertIn("src/exact/a.h:2: exact may not use run", faulty.stdout)
        self.assertEqual(self.run_on({}).returncode, 1)


# Paths that lead somewhere, or claim nothing.
NAMING = {
    "README.md": "`tests/run/a_test.py`, `run/a`; a place/of/others.h, src/gallium/drivers/b.c\n"
                 "Save this as `cases/mine.json`:\n```sh\ncat cases/mine.json\n```\n"
                 "`cases/FOLDER/NAME.json`\n",
    "src/run/a.cpp": "// run/a.h, src/run/a.cpp:3 and run/inner/b; 5 cases/s\n"
                     'const char* const kText = "run/gone.h";\n',
    "src/run/a.h": "// As inner/b.h has it, or https://example.org/src/run/gone.h.\n",
    "src/run/inner/b.h": "",
    "tests/run/a_test.py": '# See run/a.cpp.\nTEXT = """\n# src/run/gone.h\n"""\nMORE = "run/gone.h"\n',
    "tools/CMakeLists.txt": "# tests/run\nadd(src/run/gone.cpp)\n",
}
# A file, what it has on its second line, and the path that leads nowhere.
LOST = [
    ("README.md", "[this](src/run/gone.h)", "src/run/gone.h"),
    ("src/run/z.h", "// As far as run/gone.h says.", "run/gone.h"),
    ("src/run/z.h", "/* tests/run/gone_test.cpp */", "tests/run/gone_test.cpp"),
    ("src/run/z.cpp", "// (run/inner/gone)", "run/inner/gone"),
    ("reports/z.js", "f();  // cases/gone.json", "cases/gone.json"),
    ("tests/z.py", '"""As tests/gone.py."""', "tests/gone.py"),
    ("tests/z.py", "a = 1  " "# tools/gone.md", "tools/gone.md"),
    ("src/CMakeLists.txt", "# src/gone.cmake", "src/gone.cmake"),
]


class Paths(unittest.TestCase):
    def lost(self, files):
        with tempfile.TemporaryDirectory() as folder:
            plant(Path(folder), files)
            found, count = paths.check(Path(folder))
        self.assertGreater(count, 4)
        return [(str(file), line, path) for file, line, path in found]

    def test_what_is_there_is_found(self):
        self.assertEqual(self.lost(NAMING), [])

    def test_each_path_that_leads_nowhere_is_told_where_it_stands(self):
        for name, text, path in LOST:
            with self.subTest(name=name, text=text):
                self.assertEqual(self.lost({**NAMING, name: text + "\n"}), [(name, 2, path)])

    def test_the_program_fails_on_a_lost_path_and_on_nothing_read(self):
        for files, code in ((NAMING, 0), ({**NAMING, "README.md": "src/run/gone.h"}, 1),
                            ({"src/run/a.h": ""}, 1)):
            with tempfile.TemporaryDirectory() as folder:
                plant(Path(folder), files)
                done = subprocess.run([sys.executable, "-B", paths.__file__, folder],
                                      capture_output=True, check=False)
            self.assertEqual(done.returncode, code, files)


if __name__ == "__main__":
    unittest.main()
