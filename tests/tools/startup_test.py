# SPDX-License-Identifier: MIT
"""What the command loads: no image library and no OpenGL before they are needed."""
import re
import unittest

from suite_data import COUNT, files_of_share, shard
from support import PROBES, SUITE, CommandTest

HEAVY = ("OpenImageIO", "edgecase_image_io", "libOSMesa", "libEGL", "libGL", "libLLVM")


class StartUp(CommandTest):
    def heavy_libraries(self, *arguments):
        """The heavy ones among the libraries that the dynamic linker opens."""
        run = self.command(*arguments, LD_DEBUG="files")
        opened = set(re.findall(r"calling init: (\S+)", run.stderr))
        self.assertTrue(any("libstdc++" in path for path in opened), run.stderr[:2000])
        return {name for name in HEAVY if any(name in path for path in opened)}

    def test_nothing_heavy_is_loaded(self):
        case = f"{SUITE}/triangles/ties/flat-top.json"
        for arguments in (["--version"], ["rules"], ["validate", case],
                          ["validate", *([SUITE] if COUNT == 1 else files_of_share())],
                          ["render", case], ["run", *PROBES, *shard(), "--against", "exact"],
                          ["run", *PROBES, "--list"], ["explain", case, "--pixel", "3,3"]):
            with self.subTest(" ".join(map(str, arguments[:4]))):
                self.assertEqual(self.heavy_libraries(*arguments), set())

    def test_image_files_need_their_library(self):
        """The check above would see it."""
        loaded = self.heavy_libraries("render", f"{SUITE}/triangles/ties/flat-top.json", "--png",
                                      "pictures")
        self.assertIn("OpenImageIO", loaded)


if __name__ == "__main__":
    unittest.main()
