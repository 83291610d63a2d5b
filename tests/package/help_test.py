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
from terminal import run_on_a_terminal  # noqa: E402

SHARED = {"--help", "-h"}


class HelpTest(CommandTest):
    def setUp(self):
        super().setUp()
        listed = self.command("help").stdout
        self.groups = {heading: re.findall(r"^  (\w+) ", rows, re.MULTILINE) for heading, rows in
                       re.findall(r"^(Run|Understand|Write cases|Search|Maintain):\n"
                                  r"((?:  .*\n)+)", listed, re.MULTILINE)}
        self.subcommands = [name for names in self.groups.values() for name in names]
        self.assertGreater(len(self.subcommands), 15)

    def options(self, subcommand):
        """Names of its options as its help lists them, the help's own left out."""
        told = self.command(subcommand, "--help").stdout
        heads = re.findall(r"^  (-\S+)", told, re.MULTILINE)
        return {name for head in heads for name in head.split(",")} - SHARED


def columns_on_a_terminal(*arguments, columns):
    """The lines of what the command prints on a terminal of this width."""
    code, text = run_on_a_terminal([EDGECASE, *arguments], "stdout", columns,
                                   stdin=subprocess.DEVNULL)
    assert code == 0
    return text.replace("\r\n", "\n").splitlines()


def words_of(lines):
    return [word for line in lines for word in line.split()]


class Help(HelpTest):
    def test_subcommands_stand_in_groups(self):
        self.assertEqual(list(self.groups),
                         ["Run", "Understand", "Write cases", "Search", "Maintain"])
        for group, name in (("Run", "run"), ("Understand", "explain"), ("Write cases", "new"),
                            ("Search", "fuzz"), ("Maintain", "bless")):
            self.assertIn(name, self.groups[group])
        self.assertNotIn("Subcommands:", self.command("--help").stdout)

    def test_help_is_the_option_help(self):
        self.assertEqual(self.command("help").stdout, self.command("--help").stdout)
        for subcommand in self.subcommands:
            self.assertEqual(self.command("help", subcommand).stdout,
                             self.command(subcommand, "--help").stdout)
        told = self.command("help", "minimise", expect=2).stderr
        self.assertEqual(told, 'edgecase: there is no subcommand "minimise"; did you mean minimize? '
                               "`edgecase help` lists them\n")

    def test_each_says_purpose_exit_codes_and_examples(self):
        for subcommand in self.subcommands:
            with self.subTest(subcommand):
                told = self.command(subcommand, "--help").stdout
                self.assertIn(f"Usage: edgecase {subcommand} ", told)
                self.assertRegex(told, r"\n\n[A-Z](?:[^\n]|\n(?!\n)){40,}\.\n\n"
                                       r"Exit codes: 0 as expected, ")
                self.assertIn(f"\n\nExamples:\n  edgecase {subcommand}", told)

    def test_lines_end_where_the_terminal_does(self):
        """All but those of examples and of a word that is longer by itself."""
        for arguments in (["--help"], *(["help", name] for name in self.subcommands)):
            told = [columns_on_a_terminal(*arguments, columns=width) for width in (60, 100, 300)]
            for lines, width in zip(told, (60, 100, 100)):
                text = [line for line in lines if not line.startswith("  edgecase ")]
                for line in text:
                    longest = max(map(len, line.split()), default=0)
                    self.assertLessEqual(len(line), max(width, 26 + longest), line)
            self.assertEqual(words_of(told[0]), words_of(told[1]))
            self.assertEqual(told[1], told[2], "longer lines are hard to read")
            piped = self.command(*arguments, COLUMNS="60").stdout.splitlines()
            self.assertEqual(piped, told[0])
            self.assertEqual(self.command(*arguments, COLUMNS="80").stdout,
                             self.command(*arguments, COLUMNS="").stdout)

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
                        if re.match(r"(lines|triangles|scenes)\b(?!.*(\.|\*))", word):
                            self.assertTrue((ROOT / "cases" / word).is_dir() or
                                            (ROOT / f"cases/{word}.json").is_file(), word)


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
                      "--seed SEED Number that fixes the scenes (default: 1)",
                      "edgecase explain [options] CASE ",
                      "edgecase run [options] [PATHS ...]",
                      "edgecase run --shard 2/4 --json 2.zst"):
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
        self.assertEqual(self.complete("edgecase fuzz --surface w"), {"window"})
        self.assertIn("line.diamond-exit", self.complete("edgecase draw x.json --rule line."))
        # readline takes what stands behind a colon for a word of its own.
        self.assertEqual(self.complete("edgecase render --with osmesa:"), {"llvmpipe", "softpipe"})
        self.assertIn("osmesa:llvmpipe", self.complete("edgecase run --against osm"))
        self.assertIn("egl:zink", self.complete("edgecase backends eg"))
        self.assertEqual(self.complete("edgecase help mi"), {"minimize"})
        self.assertIn("line.snap", self.complete("edgecase rules line."))

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
