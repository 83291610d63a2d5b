# SPDX-License-Identifier: MIT
"""What is mutated, and which test programs judge it."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

from mutation.tree import copy_tree, mutate_files, source_files

ROOT = Path(__file__).resolve().parents[2]


class BuildError(Exception):
    """The mutated copy cannot be built; the message says where to look."""


@dataclass
class Project:
    root: Path
    build: Path                # everything that is made goes here
    mutated: tuple             # folders
    copied: tuple              # files and folders that the build needs, the mutated ones included
    programs: tuple            # test programs, those that kill most for the least time first
    share: str = "1/16"        # of their scenes that tests ask: the quick tier's

    def mutate(self):
        """(mutants, {file: mutated text})"""
        return mutate_files(self.root, source_files(self.root, self.mutated))

    def make(self, texts, jobs):
        """Builds the mutated copy."""
        self.build.mkdir(parents=True, exist_ok=True)
        tree = self.build / "tree"
        copy_tree(self.root, tree, texts, self.copied)
        binary = self.build / "build"
        self.call("configure", ["cmake", "-S", tree, "-B", binary, "-G", "Ninja",
                                "-DCMAKE_BUILD_TYPE=", "-DEDGECASE_TESTS=ON",
                                f"-DCMAKE_PROJECT_INCLUDE={ROOT}/tests/mutation/mutated.cmake"])
        self.call("build", ["ninja", "-C", binary, f"-j{jobs}",
                            *[f"test_{name}" for name in self.programs]])

    def call(self, step, command):
        log = self.build / f"{step}.log"
        with log.open("w", encoding="utf-8") as output:
            done = subprocess.run([str(word) for word in command], stdout=output,
                                  stderr=subprocess.STDOUT, check=False)
        if done.returncode != 0:
            tail = "\n".join(log.read_text(encoding="utf-8").splitlines()[-15:])
            raise BuildError(f"the mutated copy does not {step}; {log} ends with\n{tail}")

    def environment(self, **more):
        """What a test program is run with."""
        return dict(os.environ, EDGECASE_SHARE=self.share, **more)

    def program(self, name):
        return self.build / "build" / "bin" / f"test_{name}"


def edgecase(build, share):
    """The exact side of this repository."""
    return Project(
        ROOT, build, ("src/exact", "src/rules", "src/raster"),
        ("CMakeLists.txt", "src", "tests", "reference", "reports", "tools", "cases"),
        ("exact", "rules", "sample_rules", "levels", "texels", "values", "raster", "multisample",
         "supersample", "texture_stage", "output_rules", "fragment_operations", "clipping",
         "clipped_lines", "diff_clipping", "framebuffer",
         "oracles"),
        share)


def processors():
    return len(os.sched_getaffinity(0))
