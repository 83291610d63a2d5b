# SPDX-License-Identifier: MIT
"""Help of every subcommand, the manual page and the completions, held against one another."""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import unittest

ROOT = pathlib.Path(os.environ["EDGECASE_ROOT"])
sys.path.insert(0, str(ROOT / "tests" / "tools"))

from support import EDGECASE, CommandTest  # noqa: E402

SHARED = {"--help", "-h"}


class HelpTest(CommandTest):
    def setUp(self):
        super().setUp()
        listed = self.command("--help").stdout.split("Subcommands:\n")[1]
        self.subcommands = re.findall(r"^  (\w+) ", listed, re.MULTILINE)
        self.assertGreater(len(self.subcommands), 15)

    def options(self, subcommand):
        """Names of its options as its help lists them, the help's own left out."""
        told = self.command(subcommand, "--help").stdout
        heads = re.findall(r"^  (-\S+)", told, re.MULTILINE)
        return {name for head in heads for name in head.split(",")} - SHARED


class Help(HelpTest):
    def test_each_says_purpose_exit_codes_and_examples(self):
        for subcommand in self.subcommands:
            with self.subTest(subcommand):
                told = self.command(subcommand, "--help").stdout
                self.assertIn(f"Usage: edgecase {subcommand} ", told)
                self.assertRegex(told, r"\n\n[A-Z][^\n]{40,}\.\n\nExit codes: 0 as expected, ")
                self.assertIn(f"\n\nExamples:\n  edgecase {subcommand}", told)

    def test_examples_are_well_formed(self):
        """Options are those of the subcommand, and files of the suite are there."""
        for subcommand in self.subcommands:
            told = self.command(subcommand, "--help").stdout.split("Examples:\n")[1]
            for line in told.splitlines():
                with self.subTest(line):
                    words = shlex.split(re.split(r" [|>] ", line)[0])
                    self.assertEqual(words[:2], ["edgecase", subcommand])
                    given = {word for word in words[2:] if re.match(r"--?[a-z]", word)}
                    self.assertLessEqual(given, self.options(subcommand))
                    for word in words[2:]:
                        if word.startswith("cases/") and word != "cases/lines/mine.json":
                            self.assertTrue((ROOT / word).exists(), word)


class Manual(HelpTest):
    def text(self):
        page = self.write("edgecase.1", self.command("manual").stdout)
        shown = subprocess.run(["man", "--warnings", "-l", page], capture_output=True, text=True,
                               env={**os.environ, "MANWIDTH": "100", "LC_ALL": "C.UTF-8"},
                               check=True)
        self.assertEqual(shown.stderr, "")
        return shown.stdout

    def test_every_option_stands_in_it(self):
        sections = re.split(r"^   edgecase (\w+)$", self.text(), flags=re.MULTILINE)
        pages = dict(zip(sections[1::2], sections[2::2]))
        self.assertEqual(list(pages), self.subcommands)
        for subcommand, page in pages.items():
            named = set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", re.sub(r"-\n\s+", "-", page)))
            self.assertLessEqual(self.options(subcommand), named, subcommand)
            self.assertIn("Exit codes:", page)
            self.assertIn(f"edgecase {subcommand}", page.split("Examples:")[1])

    def test_every_argument_is_described(self):
        entries = re.findall(r"^\.TP\n\\fB(.*)\n(.*)$", self.command("manual").stdout,
                             re.MULTILINE)
        self.assertGreater(len(entries), 150)
        for name, description in entries:
            self.assertRegex(description, r"^[A-Z]\S* \S+|^I/N: |^fbo or ", name)

    def test_values_and_defaults_stand_in_it(self):
        text = re.sub(r"\s+", " ", self.text())
        for words in ("--timeout TIMEOUT Seconds per case; 0.01 - 3600",
                      "--progress PROGRESS Progress on standard error [auto, never]",
                      "--seed SEED Of the scenes (default: 1)",
                      "edgecase explain [options] CASE ",
                      "edgecase run [options] [PATHS ...]",
                      "edgecase run --shard 2/4 --json 2.json"):
            self.assertIn(words, text)


class Bash(HelpTest):
    def complete(self, line):
        """What bash offers where the cursor stands behind the line."""
        script = self.write("completion.bash",
                            self.command("manual", "--completion", "bash").stdout)
        program = (f"set -u; source {shlex.quote(str(script))}; COMP_LINE={shlex.quote(line)}; "
                   "COMP_POINT=${#COMP_LINE}; _edgecase; "
                   '[[ ${#COMPREPLY[@]} == 0 ]] || printf "%s\\n" "${COMPREPLY[@]}"')
        run = subprocess.run(["bash", "--norc", "-c", program], cwd=self.folder, text=True,
                             capture_output=True, check=True)
        self.assertEqual(run.stderr, "")
        return set(run.stdout.splitlines())

    def test_subcommands(self):
        self.assertEqual(self.complete("edgecase "),
                         {*self.subcommands, "--help", "--version"})
        self.assertEqual(self.complete("edgecase re"), {"render", "record", "report"})

    def test_options(self):
        for subcommand in self.subcommands:
            self.assertEqual(self.complete(f"edgecase {subcommand} -") - SHARED,
                             self.options(subcommand), subcommand)
        self.assertEqual(self.complete("edgecase run cases --ju"), {"--junit"})

    def test_values(self):
        self.assertEqual(self.complete("edgecase run --color "), {"auto", "always", "never"})
        self.assertEqual(self.complete("edgecase run --color=al"), {"always"})
        self.assertEqual(self.complete("edgecase profile --surface w"), {"window"})
        self.assertIn("line.diamond-exit", self.complete("edgecase draw x.json --rule line."))
        # readline takes what stands behind a colon for a word of its own.
        self.assertEqual(self.complete("edgecase render --with osmesa:"), {"llvmpipe", "softpipe"})
        self.assertIn("osmesa:llvmpipe", self.complete("edgecase run --against osm"))
        self.assertIn("egl:zink", self.complete("edgecase backends eg"))

    def test_files(self):
        self.write("one case.json", "{}")
        self.write("two.json", "{}")
        self.assertEqual(self.complete("edgecase run --json t"), {"two.json"})
        self.assertEqual(self.complete("edgecase validate o"), {"one case.json"})
        # An option is no value of another.
        self.assertEqual(self.complete("edgecase run --json --"), set())


class Fish(HelpTest):
    def complete(self, line):
        script = self.write("completion.fish",
                            self.command("manual", "--completion", "fish").stdout)
        run = subprocess.run(["fish", "--no-config", "-c",
                              f"source {script}; complete -C {shlex.quote(line)}"],
                             cwd=self.folder, text=True, capture_output=True, check=True,
                             env={**os.environ, "PATH": f"{pathlib.Path(EDGECASE).parent}:"
                                                        f"{os.environ['PATH']}",
                                  "HOME": str(self.folder)})
        self.assertEqual(run.stderr, "")
        return {row.split("\t")[0] for row in run.stdout.splitlines()}

    def test_it_offers_the_same(self):
        self.assertLessEqual(set(self.subcommands), self.complete("edgecase "))
        for subcommand in self.subcommands:
            self.assertEqual({name for name in self.complete(f"edgecase {subcommand} -")} - SHARED,
                             self.options(subcommand), subcommand)
        self.assertEqual(self.complete("edgecase run --color "), {"auto", "always", "never"})
        self.assertIn("osmesa:llvmpipe", self.complete("edgecase run --against osm"))


if __name__ == "__main__":
    unittest.main()
