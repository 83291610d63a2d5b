# SPDX-License-Identifier: MIT
"""Every command that a document shows is run, in a copy of what it speaks of.

Commands stand in blocks of the language `sh`; a block without a language right below one is what
its last command prints, in part or wholly. Each block has a folder of its own: a suite of the cases
that commands name, the examples, and the files that a reader would have by then. Case files that are
shown are the files that there are, or load.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

from suite_data import in_share
from support import BIN, EDGECASE, PATIENCE, ROOT, CommandTest, environment

DOCUMENTS = ("README.md", "CONTRIBUTING.md", "cases/README.md", "reference/PROTOCOL.md",
             "tools/ci/README.md")

# Commands that are not run, by how they begin, and why.
NOT_RUN = {
    "tools/run": "installs packages and builds",
    "tools/test": "installs packages, builds, and runs this test",
    "tools/build": "builds; CI does",
    "ctest": "runs this test",
    "tools/lint": "asks all files for many minutes; tests/lint asks a sample",
    "tools/determinism": "builds four times; determinism_test asks one program about a sample",
    "tools/coverage": "builds and runs all tests; coverage_test asks it of a small program",
    "tools/sanitize": "builds all that is ours with a sanitizer, and runs all tests with it",
    "tools/fuzz": "builds with clang; the test `fuzz` runs it for a while",
    "tools/mutate": "builds hundreds of times; mutation_sample plants a few",
    "cmake --install": "tests/package installs",
    "man edgecase": "needs what is installed; tests/package asks man for the page",
    "tools/ci/slurm": "needs root and Slurm; ci_test runs both",
    "EDGECASE_OUT=$PWD/finds sbatch": "needs a cluster for eight hours; ci_test runs the script",
    "build/release/bin/edgecase profile --against osmesa:softpipe":
        "takes minutes; profile_test asks for fewer scenes",
    "build/release/bin/edgecase fuzz --against osmesa:llvmpipe --policy profile --rules grid-lines":
        "asks for 62 million scenes; fuzz_test ends such a search on part of them",
}

# What is put in place of a part of a command, so that it ends soon or finds what it needs.
STANDS_IN = {
    "egl:device0": "egl:softpipe",  # no graphics card here
    "--seconds 120": "--seconds 1",
    "--save cases/fuzz": "--save cases/fuzz --count 200",  # else until Ctrl-C
    "bench --against egl:llvmpipe":
        "bench --rounds 1 --seconds 0 --side 64 --cases 64 --against egl:llvmpipe",
    "bench cases/lines": "bench --rounds 1 --seconds 0 cases/lines/short",
    "FOLDER/NAME": "lines/short/between-diamonds",
}

# What reads a few cases of the whole suite, by their names.
OF_WHOLE_SUITE = ("edgecase gallery", "edgecase rules --book")

# Commands that do not end with 0, by how they begin.
EXITS = {
    # A few cases tell few alternatives apart.
    "build/release/bin/edgecase separation --least": {1},
    # All was as expected before.
    "build/release/bin/edgecase run --last-failed": {5},
    # It finds something, or nothing in so short a time.
    "build/release/bin/edgecase fuzz": {0, 1},
}

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SHOWN_CASE = re.compile(r"This is all of `([^`]*)`:\s*\Z")


def text_of(document):
    return (ROOT / document).read_text(encoding="utf-8")


def blocks_of(document):
    """(line, commands, output) of each block of commands; output is None where none is shown."""
    text = text_of(document)
    found = list(BLOCK.finditer(text))
    for block, following in zip(found, found[1:] + [None]):
        if block[1] != "sh":
            continue
        output = None
        if following and not following[1] and not text[block.end():following.start()].strip():
            output = following[2]
        yield text.count("\n", 0, block.start()) + 1, list(commands_of(block[2])), output


def commands_of(block):
    """The block's commands, those over several lines as one, without comments."""
    command = ""
    for line in block.splitlines():
        command += line
        try:
            words = shlex.split(command, comments=True)
        except ValueError:  # a quotation is still open
            command += "\n"
            continue
        if command.endswith("\\"):
            command += "\n"
            continue
        if words:
            yield re.sub(r"\s+# .*\Z", "", command).strip()
        command = ""


def reason_not_to_run(command):
    return next((why for start, why in NOT_RUN.items() if command.startswith(start)), None)


def in_short(command):
    for part, instead in STANDS_IN.items():
        command = command.replace(part, instead)
    return command


def named_cases():
    """The case files of the suite that commands name, below `cases`."""
    named = {case for document in DOCUMENTS for _, commands, _ in blocks_of(document)
             for case in re.findall(r"cases/([\w/.-]+)\.json", in_short("\n".join(commands)))}
    return sorted(name for name in named if (ROOT / f"cases/{name}.json").is_file())


class Documents(CommandTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory(prefix="edgecase-documents-")
        cls.addClassCleanup(folder.cleanup)
        cls.checkout = pathlib.Path(folder.name, "checkout")
        cls.make_checkout()
        cls.make_files_of_a_reader()

    @classmethod
    def make_checkout(cls):
        (cls.checkout / "build/release").mkdir(parents=True)
        (cls.checkout / "build/release/bin").symlink_to(BIN)
        (cls.checkout / "reports/images").mkdir(parents=True)
        (cls.checkout / "src/rules").mkdir(parents=True)
        shutil.copytree(ROOT / "reference/examples", cls.checkout / "reference/examples")
        for folder in ("policies", "profiles"):
            shutil.copytree(ROOT / "cases" / folder, cls.checkout / "cases" / folder)
        for schema in ("case.schema.json", "gallery.schema.json"):
            shutil.copy(ROOT / "cases" / schema, cls.checkout / "cases")
        for name in named_cases():
            path = cls.checkout / f"cases/{name}.json"
            path.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / f"cases/{name}.json", path)
        (cls.checkout / "cases/expectations").mkdir()
        for path in (ROOT / "cases/expectations").glob("*.json"):
            known = json.loads(path.read_text(encoding="utf-8"))
            known["expectations"] = [
                entry for entry in known["expectations"]
                if (cls.checkout / f"cases/{entry['case'].partition(':')[0]}.json").is_file()]
            (cls.checkout / f"cases/expectations/{path.name}").write_text(json.dumps(known),
                                                                          encoding="utf-8")

    @classmethod
    def make_files_of_a_reader(cls):
        """Results of earlier runs, a reviewer's decisions, and a rasterizer."""
        example = [sys.executable, "reference/examples/rasterizer.py"]
        program = f"import os\nos.execv({example[0]!r}, {example!r})\n"
        for name in ("my_rasterizer", "my_rasterizer.py"):
            path = cls.checkout / name
            path.write_text(f"#!{sys.executable}\n{program}", encoding="utf-8")
            path.chmod(0o755)
        earlier = [f"edgecase run --shard {part}/4 --json {part}.json" for part in range(1, 5)]
        for command in (*earlier, "edgecase run --against osmesa:softpipe"):
            run = cls.shell(command, cls.checkout)
            if run.returncode != 0:
                raise AssertionError(f"{command}: {run.stdout[-2000:]}{run.stderr[-2000:]}")
        for name in ("old.json", "new.json"):
            shutil.copy(cls.checkout / "out/results.json", cls.checkout / name)
        (cls.checkout / "decisions.json").write_text(json.dumps(
            {"edgecase_decisions": 1, "renderer": "osmesa:softpipe", "decisions": []}),
            encoding="utf-8")

    @staticmethod
    def shell(command, folder):
        variables = {"PATH": f"{BIN}:{os.environ['PATH']}", "HOME": str(folder)}
        return subprocess.run(["sh", "-c", command], cwd=folder, env=environment(**variables),
                              stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=PATIENCE)

    def run_block(self, place, commands, output, folder):
        said = ""
        for command in commands:
            if reason_not_to_run(command):
                self.assertIsNone(output, f"{place}: what it prints is not held against anything")
                continue
            run = self.shell(in_short(command), folder)
            allowed = next((codes for start, codes in EXITS.items() if command.startswith(start)),
                           {0})
            self.assertIn(run.returncode, allowed, f"{place}: {command}\n{run.stdout[-2000:]}\n"
                                                   f"{run.stderr[-2000:]}")
            said = run.stdout + run.stderr
        if output is not None:
            self.assertIn("\n" + output, "\n" + said, f"{place}: {commands[-1]}")

    def check(self, document):
        for number, (line, commands, output) in in_share(enumerate(blocks_of(document))):
            with self.subTest(line=line):
                folder = self.folder / f"block-{number}"
                shutil.copytree(self.checkout, folder, symlinks=True)
                if any(part in command for part in OF_WHOLE_SUITE for command in commands):
                    shutil.rmtree(folder / "cases")
                    (folder / "cases").symlink_to(ROOT / "cases")
                self.run_block(f"{document}:{line}", commands, output, folder)
                self.check_images(folder)

    def check_images(self, folder):
        """What a command drew where the repository has a picture is that picture."""
        for path in (folder / "reports/images").iterdir():
            self.assertEqual(path.read_bytes(), (ROOT / "reports/images" / path.name).read_bytes(),
                             f"reports/images/{path.name} is not what its command draws")

    def test_the_lists_name_nothing_that_is_gone(self):
        commands = [command for document in DOCUMENTS
                    for _, commands, _ in blocks_of(document) for command in commands]
        for start in [*NOT_RUN, *EXITS]:
            self.assertTrue(any(c.startswith(start) for c in commands), start)
        for part in STANDS_IN:
            self.assertTrue(any(part in c for c in commands), part)

    def test_outputs_stand_below_commands(self):
        """A block without a language is compared; anything else says what it is."""
        for document in DOCUMENTS:
            compared = sum(output is not None for _, _, output in blocks_of(document))
            plain = sum(not block[1] for block in BLOCK.finditer(text_of(document)))
            self.assertEqual(plain, compared, document)

    def test_case_files_that_are_shown_are_cases(self):
        for document in DOCUMENTS:
            text = text_of(document)
            for number, block in enumerate(BLOCK.finditer(text)):
                if '"$schema": "../../case.schema.json"' not in block[2]:
                    continue
                source = SHOWN_CASE.search(text, 0, block.start())
                with self.subTest(document=document, case=json.loads(block[2])["title"]):
                    if source:
                        self.assertEqual(block[2], text_of(source[1]))
                    path = self.write(f"cases/shown/{number}.json", block[2])
                    subprocess.run([EDGECASE, "validate", path], check=True,
                                   stdout=subprocess.DEVNULL)


def test_of(document):
    return lambda self: self.check(document)


for _document in DOCUMENTS:
    _name = re.sub(r"\W", "_", _document.removesuffix(".md")).lower()
    setattr(Documents, f"test_commands_of_{_name}", test_of(_document))


if __name__ == "__main__":
    unittest.main()
