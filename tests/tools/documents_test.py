# SPDX-License-Identifier: MIT
"""The documents: every command that one shows is run, in a copy of what it speaks of; links lead
somewhere; README stays short.

Commands stand in blocks of the language `sh`; a block without a language right below one is what
its last command prints, in part or wholly. In blocks of the language `console` a command follows
`$ `, and what it prints follows the command: lines in their order, where `…` stands for anything.
Each block has a folder of its own: a suite of the cases that commands name, the examples, and the
files that a reader would have by then. Files that are shown are the files that there are, are saved
for the commands below them ("Save this as `PATH`:"), or, of cases, load.
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

from shown_output import FIRST_LINE, is_in_order, of_few_cases, shown_pieces, without_seconds
from suite_data import in_share
from support import BIN, EDGECASE, PATIENCE, ROOT, CommandTest, environment

PAGES = sorted(str(path.relative_to(ROOT)) for path in (ROOT / "reports/pages").glob("*.md"))
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "cases/README.md", "reference/PROTOCOL.md",
             "tools/ci/README.md", *PAGES)
# Documents whose links are followed, too.
OTHERS = ("CHANGELOG.md", "reference/README.md", "src/rules/RULINGS.md", "tests/fuzz/README.md",
          "tests/proofs/README.md")
README_MOST_BYTES = 9216

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
    "build/release/bin/edgecase run cases/lines --watch": "stays until it is ended; watch_test",
    "build/release/bin/edgecase run --suite core --against recording:":
        "needs what a browser saved; web_test reads such a file",
    "build/release/bin/edgecase profile --suite core --against recording:":
        "needs what a browser saved; web_test measures such a file",
    "cmake --install": "tests/package installs",
    "man edgecase": "needs what is installed; tests/package asks man for the page",
    "tools/ci/slurm": "needs root and Slurm; ci_test runs both",
    "EDGECASE_OUT=$PWD/finds sbatch": "needs a cluster for eight hours; ci_test runs the script",
    "git clone https://github.com/KhronosGroup/VK-GL-CTS": "fetches and builds Khronos's tests",
    "cd cts/modules/gles3": "needs Khronos's tests",
    "LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=softpipe piglit": "needs Piglit, and minutes",
    "build/release/bin/edgecase fuzz --against egl:llvmpipe --policy profile --rules grid-lines":
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

# What reads a few cases of the whole suite, by their names, or a folder of it.
OF_WHOLE_SUITE = ("edgecase gallery", "edgecase web", "edgecase rules --book",
                  "edgecase run cases/triangles ")

# Commands that do not end with 0, by how they begin.
EXITS = {
    # A rasterizer with a fault.
    "edgecase run cases/triangles --against \"exec:python3 reference/examples/triangles.py": {1},
    # All was as expected before.
    "build/release/bin/edgecase run --last-failed": {5},
    # It finds something, or nothing in so short a time.
    "build/release/bin/edgecase fuzz": {0, 1},
}

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SHOWN = re.compile(r"This is all of `([^`]*)`:\s*\Z")
SAVED = re.compile(r"Save this as `([^`]*)`:\s*\Z")
CONSOLE_COMMAND = re.compile(r"^\$ ((?:.*\\\n)*.*)\n", re.MULTILINE)

LINK = re.compile(r"\]\(([^()\s]+)\)|<img src=\"([^\"]+)\"")
HEADING = re.compile(r"^#+ +(.*?) *$", re.MULTILINE)


def text_of(document):
    return (ROOT / document).read_text(encoding="utf-8")


def blocks_of(document):
    """(line, commands, outputs) of each block of commands, as many outputs as commands; an output
    is None where none is shown."""
    text = text_of(document)
    found = list(BLOCK.finditer(text))
    for block, following in zip(found, found[1:] + [None]):
        line = text.count("\n", 0, block.start()) + 1
        if block[1] == "console":
            parts = CONSOLE_COMMAND.split(block[2])
            yield line, parts[1::2], parts[2::2]
        if block[1] == "sh":
            commands = list(commands_of(block[2]))
            outputs = [None] * len(commands)
            if following and not following[1] and not text[block.end():following.start()].strip():
                outputs[-1] = following[2]
            yield line, commands, outputs


def saved_files(document):
    """(path, content) of each file that a reader is asked to save."""
    text = text_of(document)
    return [(SAVED.search(text, 0, block.start())[1], block[2]) for block in BLOCK.finditer(text)
            if SAVED.search(text, 0, block.start())]


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


# (document, block) of all documents, and which of them this share asks.
BLOCKS = [(document, block) for document in DOCUMENTS for block in blocks_of(document)]
IN_SHARE = in_share(BLOCKS)


def anchors_of(document):
    """The names of a document's headings, as GitHub makes them."""
    text = BLOCK.sub("", text_of(document))
    names = [re.sub(r"[^\w\- ]", "", re.sub(r"\]\([^)]*\)", "", heading).lower()).replace(" ", "-")
             for heading in HEADING.findall(text)]
    return set(names)


def named_cases():
    """The case files of the suite that commands name, below `cases`."""
    named = {case for _, (_, commands, _) in BLOCKS
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
        for schema in ("case.schema.json", "gallery.schema.json", "policy.schema.json"):
            shutil.copy(ROOT / "cases" / schema, cls.checkout / "cases")
        for name in named_cases():
            path = cls.checkout / f"cases/{name}.json"
            path.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / f"cases/{name}.json", path)
        shutil.copytree(ROOT / "cases/known", cls.checkout / "cases/known")

    @classmethod
    def make_files_of_a_reader(cls):
        """Results of earlier runs, a reviewer's decisions, and a rasterizer."""
        example = [sys.executable, "reference/examples/rasterizer.py"]
        program = f"import os\nos.execv({example[0]!r}, {example!r})\n"
        for name in ("my_rasterizer", "my_rasterizer.py"):
            path = cls.checkout / name
            path.write_text(f"#!{sys.executable}\n{program}", encoding="utf-8")
            path.chmod(0o755)
        earlier = [f"edgecase run --shard {part}/4 --json {part}.zst" for part in range(1, 5)]
        for command in (*earlier, "edgecase run --against egl:softpipe"):
            run = cls.shell(command, cls.checkout)
            if run.returncode != 0:
                raise AssertionError(f"{command}: {run.stdout[-2000:]}{run.stderr[-2000:]}")
        for name in ("old.zst", "new.zst", "22.3.zst", "25.0.zst", "26.2.zst"):
            shutil.copy(cls.checkout / "out/results.zst", cls.checkout / name)
        (cls.checkout / "decisions.json").write_text(json.dumps(
            {"edgecase_decisions": 2, "renderer": "egl:softpipe", "decisions": []}),
            encoding="utf-8")

    @staticmethod
    def shell(command, folder):
        variables = {"PATH": f"{BIN}:{os.environ['PATH']}", "HOME": str(folder)}
        return subprocess.run(["sh", "-c", command], cwd=folder, env=environment(**variables),
                              stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=PATIENCE)

    def run_block(self, place, commands, outputs, folder):
        for command, output in zip(commands, outputs):
            if reason_not_to_run(command):
                self.assertIsNone(output, f"{place}: what it prints is not held against anything")
                continue
            run = self.shell(in_short(command), folder)
            allowed = next((codes for start, codes in EXITS.items() if command.startswith(start)),
                           {0})
            self.assertIn(run.returncode, allowed, f"{place}: {command}\n{run.stdout[-2000:]}\n"
                                                   f"{run.stderr[-2000:]}")
            if output and FIRST_LINE.search(output):
                counts = [self.count_cases(command, suite) for suite in (folder, ROOT)]
                output = of_few_cases(output, *counts)
            self.check_output(f"{place}: {command}", output,
                              without_seconds(run.stdout + run.stderr))

    def count_cases(self, command, folder):
        """How many cases the command selects in a folder, as a summary prints it: "30,718"."""
        run = self.shell(f"{in_short(command)} --list", folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        return f"{len(run.stdout.splitlines()):,}"

    def check_output(self, place, output, said):
        if output is None:
            return
        if "…" in output:
            self.assertTrue(is_in_order(shown_pieces(output), said), f"{place}\n{said[-4000:]}")
        else:
            self.assertIn("\n" + output, "\n" + said, place)

    def check(self, document):
        for number, (name, (line, commands, outputs)) in enumerate(IN_SHARE):
            if name != document:
                continue
            with self.subTest(line=line):
                folder = self.folder / f"block-{number}"
                shutil.copytree(self.checkout, folder, symlinks=True)
                if any(part in command for part in OF_WHOLE_SUITE for command in commands):
                    shutil.rmtree(folder / "cases")
                    (folder / "cases").symlink_to(ROOT / "cases")
                else:
                    self.save_files(document, commands, folder)
                self.run_block(f"{document}:{line}", commands, outputs, folder)
                self.check_images(folder)

    @staticmethod
    def save_files(document, commands, folder):
        for path, content in saved_files(document):
            if not any(path in command for command in commands):
                continue
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(content, encoding="utf-8")

    def check_images(self, folder):
        """What a command drew where the repository has a picture is that picture."""
        for path in (folder / "reports/images").iterdir():
            self.assertEqual(path.read_bytes(), (ROOT / "reports/images" / path.name).read_bytes(),
                             f"reports/images/{path.name} is not what its command draws")

    def test_the_lists_name_nothing_that_is_gone(self):
        commands = [command for _, (_, commands, _) in BLOCKS for command in commands]
        for start in [*NOT_RUN, *EXITS]:
            self.assertTrue(any(c.startswith(start) for c in commands), start)
        for part in [*STANDS_IN, *OF_WHOLE_SUITE]:
            self.assertTrue(any(part in c for c in commands), part)

    def test_outputs_stand_below_commands(self):
        """A block without a language is compared; anything else says what it is."""
        for document in DOCUMENTS:
            found = [block[1] for block in BLOCK.finditer(text_of(document))]
            compared = sum(output is not None for name, (_, _, outputs) in BLOCKS
                           if name == document for output in outputs)
            consoles = sum(len(CONSOLE_COMMAND.findall(block[2]))
                           for block in BLOCK.finditer(text_of(document)) if block[1] == "console")
            self.assertEqual(found.count("") + consoles, compared, document)

    def test_files_that_are_shown_are_files(self):
        for document in DOCUMENTS:
            text = text_of(document)
            for number, block in enumerate(BLOCK.finditer(text)):
                source = SHOWN.search(text, 0, block.start())
                if source:
                    self.assertEqual(block[2], text_of(source[1]), document)
                if not re.search(r'"\$schema": "[./]*case.schema.json"', block[2]):
                    continue
                with self.subTest(document=document, case=json.loads(block[2])["title"]):
                    path = self.write(f"cases/shown/{number}.json", block[2])
                    subprocess.run([EDGECASE, "validate", path], check=True,
                                   stdout=subprocess.DEVNULL)

    def test_an_output_is_compared_in_its_order(self):
        self.assertTrue(is_in_order(shown_pieces("a\n…\nc, …\n"), "a\nb\nc, d\n"))
        self.assertFalse(is_in_order(shown_pieces("c\n…\na\n"), "a\nb\nc\n"))

    def test_the_first_line_of_a_summary_is_compared_but_for_its_seconds(self):
        said = without_seconds("3 cases, 2 renderers: 0 unexpected, 6 answers as before, 0.4 s\nmore\n")
        shown = "30,718 cases, 2 renderers: 0 unexpected, 41 s\n…\n"
        for right, wrong in (("41 s", "0.2 s"), ("30,718", "30,719"), ("30,718", "3"),
                             ("2 renderers", "3 renderers"), ("0 un", "1 un"), (", 41 s", "")):
            pieces = shown_pieces(of_few_cases(shown.replace(right, wrong), "3", "30,718"))
            self.assertEqual(is_in_order(pieces, said), right == "41 s", wrong)


class Pages(unittest.TestCase):
    """What needs no program."""

    def test_links_lead_somewhere(self):
        for document in (*DOCUMENTS, *OTHERS):
            for found in LINK.finditer(BLOCK.sub("", text_of(document))):
                link = found[1] or found[2]
                if re.match(r"https?://", link):
                    continue
                name, _, anchor = link.partition("#")
                path = ROOT / document
                if name:
                    path = pathlib.Path(os.path.normpath(path.parent / name))
                with self.subTest(document=document, link=link):
                    self.assertTrue(path.is_relative_to(ROOT), "leads out")
                    self.assertTrue(path.exists(), "leads nowhere")
                    if anchor:
                        self.assertIn(anchor, anchors_of(path.relative_to(ROOT)))

    def test_every_page_and_picture_is_reached_from_the_readme(self):
        reached, ahead = set(), ["README.md"]
        while ahead:
            document = ahead.pop()
            for found in LINK.finditer(text_of(document)):
                link = (found[1] or found[2]).partition("#")[0]
                path = os.path.normpath(os.path.join(os.path.dirname(document), link))
                if not (ROOT / path).is_file() or path in reached:
                    continue
                reached.add(path)
                ahead += [path] if path.endswith(".md") else []
        pictures = [f"reports/images/{path.name}" for path in (ROOT / "reports/images").iterdir()]
        self.assertEqual([name for name in [*PAGES, *pictures] if name not in reached], [])

    def test_the_readme_is_short(self):
        self.assertLessEqual(len(text_of("README.md").encode()), README_MOST_BYTES)

    def test_the_table_of_folders_is_current(self):
        check = subprocess.run([ROOT / "tools/folders", "--check"], stdout=subprocess.PIPE,
                               text=True, check=False)
        self.assertEqual(check.returncode, 0, check.stdout)


def test_of(document):
    return lambda self: self.check(document)


for _document in DOCUMENTS:
    _name = re.sub(r"\W", "_", _document.removesuffix(".md")).lower()
    setattr(Documents, f"test_commands_of_{_name}", test_of(_document))


if __name__ == "__main__":
    unittest.main()
