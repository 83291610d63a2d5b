# SPDX-License-Identifier: MIT
"""Renderers with names of their own, and edgecase.toml, which gives a project's commands what their
own options do not say."""
import json
import pathlib
import re
import shutil
import sys
import unittest

import results_file
from support import (AS_EXPECTED, ROOT, SUITE, UNEXPECTED, USAGE, CommandTest, contents, triangle_case,
                     verdicts)

SHARED = [[1, 1], [6, 1], [1, 6], [6, 1], [6, 6], [1, 6]]
EXAMPLE = "triangles.py"
PROJECT = """cases = "raster/cases"
policy = "opengl"
known = "raster/known"

[renderers]
mine = "exec:python3 triangles.py"
ours = "exact"

[outputs]
json = "out/told.json"
markdown = "out/told.md"
"""


class ProjectTest(CommandTest):
    def setUp(self):
        super().setUp()
        shutil.copy(ROOT / "reference/examples" / EXAMPLE, self.folder)
        self.write("raster/cases/shared.json", triangle_case(
            draws=[{"primitive": "triangles", "vertices": SHARED}]))
        self.write("raster/cases/plain.json", triangle_case())
        self.exec = f"exec:{sys.executable} {self.folder / EXAMPLE}"

    def told(self, name="out/told.json"):
        return results_file.read(self.folder / name)

    def read(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def in_folder(self, folder, *arguments, **more):
        """Runs the command in a folder of the project."""
        before, self.folder = self.folder, self.folder / folder
        self.folder.mkdir(parents=True, exist_ok=True)
        try:
            return self.command(*arguments, **more)
        finally:
            self.folder = before


class Names(ProjectTest):
    def test_results_and_reports_use_the_name(self):
        results = self.results("raster/cases", "--against", f"mine={self.exec}", "--junit", "j.xml",
                               "--markdown", "m.md", "--html", "h.html", expect=UNEXPECTED)
        self.assertEqual([one["name"] for one in results["renderers"]], ["mine"])
        self.assertEqual(set(results["cases"][0]["results"]), {"mine"})
        self.assertIn("mine", self.summary)
        self.assertIn('<testsuite name="mine"', (self.folder / "j.xml").read_text("utf-8"))
        self.assertIn("| `mine` |", (self.folder / "m.md").read_text("utf-8"))
        # The command that explains it asks the same renderer under the same name.
        (command,) = {line.strip() for line in self.summary.splitlines()
                      if line.strip().startswith("edgecase explain raster/cases/shared.json")}
        self.assertIn(f"--against 'mine={self.exec}'", command)
        told = self.command("explain", "raster/cases/shared.json", "--against", f"mine={self.exec}",
                            expect=None).stdout
        self.assertIn("mine (", told)

    def test_known_faults_and_profile_are_of_the_name(self):
        self.results("raster/cases", "--against", f"mine={self.exec}", expect=UNEXPECTED)
        self.command("bless", "results.json", "--folder", "raster/cases/known", "--apply")
        known = self.read("raster/cases/known/mine.json")
        self.assertEqual(known["driver"], "mine")
        # Any command line under this name is this driver.
        shutil.move(self.folder / EXAMPLE, self.folder / "moved.py")
        results = self.results("raster/cases", "--against",
                               f"mine=exec:{sys.executable} moved.py")
        self.assertEqual([fault["id"] for fault in results["faults"]],
                         [fault["id"] for fault in known["faults"]])
        self.results("raster/cases", "--against", f"other=exec:{sys.executable} moved.py",
                     expect=UNEXPECTED)
        shutil.copytree(f"{SUITE}/profiles", self.folder / "raster/cases/profiles")
        profile = self.read("raster/cases/profiles/egl-llvmpipe.json")
        self.write("raster/cases/profiles/mine.json", {**profile, "name": "profile of mine"})
        self.command("run", "raster/cases", "--policy", "profile", "--json", "p.json", "--against",
                     f"mine=exec:{sys.executable} moved.py", expect=None)
        self.assertEqual(self.told("p.json")["policy"], "profile of mine")

    def test_a_release_has_its_own_profile(self):
        self.copy_cases([f"{SUITE}/lines/short/zero-length.json"])
        against = ("cases", "--against", "egl:softpipe")
        before = self.results(*against)
        version = re.search(r"Mesa ([0-9.]*[0-9])", before["renderers"][0]["version"])[1]
        profile = json.loads(pathlib.Path(f"{SUITE}/profiles/egl-softpipe.json").read_text("utf-8"))
        for release, same in ((f"{version}1", True), (version, False)):
            self.write(f"cases/profiles/Mesa-{release}/egl-softpipe.json",
                       {**profile, "name": "of a release"})
            after = self.results(*against)
            self.assertEqual(after["policy_digest"] == before["policy_digest"], same, release)

    def test_a_driver_has_its_faults_under_any_name(self):
        self.copy_cases([f"{SUITE}/lines/short/zero-length.json"])
        known = {"driver": "softpipe", "faults": [
            {"id": "planted", "rule": "line.diamond-exit", "cases": ["*"], "reason": "Planted."}]}
        for name in ("egl:softpipe", "mine=egl:softpipe"):
            results = self.results("cases", "--against", name)
            self.assertEqual(results["renderers"][0]["name"], name.split("=")[0])
        self.assertEqual(results["renderers"][0]["traits"]["address"], "egl:softpipe")
        self.write("cases/known/softpipe.json", known)
        self.command("record", "cases", "--against", "mine=egl:softpipe", "-o", "mine.rec")
        self.command("run", "cases", "--against", "played=recording:mine.rec", "--json", "r.json")
        (info,) = self.told("r.json")["renderers"]
        self.assertEqual((info["name"], info["traits"]["recorded"]), ("played", "egl:softpipe"))

    def test_recordings_of_a_named_program_have_its_name(self):
        self.command("record", "raster/cases", "--against", f"mine={self.exec}", "-o", "mine.rec")
        self.results("raster/cases", "--against", "recording:mine.rec", expect=UNEXPECTED)
        shown = self.command("bless", "results.json", "--folder", "known").stdout
        self.assertIn("known/mine.json", shown)

    def test_names_that_are_none(self):
        for name in ("my own", "exact", "", "-x", "n" * 65):
            told = self.command("run", "--against", f"{name}=exact", expect=USAGE).stderr
            self.assertIn("is no name for a renderer of yours", told)
        told = self.command("run", "--against", "a=exact", "--against", "a=egl:softpipe",
                            expect=USAGE).stderr
        self.assertIn("the renderer a is named twice", told)
        told = self.command("run", "--against", "a=egl:softpip", expect=USAGE).stderr
        self.assertIn("did you mean egl:softpipe?", told)


class File(ProjectTest):
    def setUp(self):
        super().setUp()
        self.caches = str(self.folder / "caches")
        self.write("edgecase.toml", PROJECT)
        # Its program may be started; trust_test.py is about that.
        self.command("draw", "raster/cases/plain.json", "--against", "mine", "--trust")

    def command(self, *arguments, **more):
        return super().command(*arguments, **{"XDG_CACHE_HOME": self.caches, **more})

    def test_it_says_what_options_do_not(self):
        self.command("run", expect=UNEXPECTED)
        results = self.told()
        self.assertEqual([one["name"] for one in results["renderers"]], ["mine", "ours"])
        self.assertEqual([one["file"] for one in results["cases"]],
                         ["raster/cases/plain.json", "raster/cases/shared.json"])
        self.assertIn("mine", (self.folder / "out/told.md").read_text("utf-8"))
        self.assertEqual(sorted(contents(self.folder / "out")), ["told.json", "told.md"])

    def test_it_holds_in_every_folder_of_the_project(self):
        """Programs are started in its folder, and paths count from there."""
        self.in_folder("raster/cases/deep", "run", expect=UNEXPECTED)
        results = self.told()
        self.assertEqual(results["cases"][0]["file"], "../plain.json")
        self.assertEqual(results["cases"][1]["results"]["mine"]["verdict"], "violation")
        self.in_folder("raster/cases/deep", "bless", "--apply")
        self.assertEqual(self.read("raster/known/mine.json")["driver"], "mine")
        self.in_folder("raster", "run", expect=AS_EXPECTED)
        told = self.in_folder("raster", "explain", "cases/shared.json", "--against", "mine",
                              expect=None)
        self.assertIn("mine (", told.stdout)

    def test_options_win(self):
        self.write("other/mine.json", triangle_case())
        (self.folder / "nothing").mkdir()
        self.command("run", "other", "--against", "ours", "--json", "own.json", "--known",
                     "nothing", "--policy", "opengl")
        results = self.told("own.json")
        self.assertEqual([one["id"] for one in results["cases"]], ["mine"])
        self.assertEqual([one["name"] for one in results["renderers"]], ["ours"])
        self.assertFalse((self.folder / "out/told.json").exists())
        self.assertTrue((self.folder / "out/told.md").exists())

    def test_every_command_that_draws_knows_its_renderers(self):
        """From any folder, and without its outputs, which are those of `run`."""
        case = "../raster/cases/shared.json"
        self.write("none.toml", 'policy = "opengl"')
        self.in_folder("deep", "record", "--against", "mine", "-o", "mine.rec")
        replayed = self.results("raster/cases", "--against", "recording:deep/mine.rec",
                                "--config", "none.toml", expect=None)
        self.assertEqual(verdicts(replayed), {"plain": "agree", "shared": "violation"})
        drawn = self.in_folder("deep", "render", "--with", "mine").stdout.splitlines()
        self.assertEqual(len(drawn), 2)
        smallest = self.in_folder("deep", "minimize", case, "--against", "mine").stdout
        self.assertIn('"triangles"', smallest)
        self.assertIn("mine\n", self.in_folder("deep", "draw", case, "--against", "mine").stdout)
        found = self.in_folder("deep", "fuzz", "--count", "3", "--rules", "shared-edges",
                               expect=None).stdout
        self.assertRegex(found, r"(?m)^ours: 3 drawn, 0 not drawn")
        self.assertFalse((self.folder / "out").exists())

    def test_another_file_is_named_by_an_option_or_a_variable(self):
        self.write("elsewhere/settings.toml", 'cases = "../raster/cases/plain.json"\n'
                                              '[renderers]\nours = "exact"\n')
        for arguments, variables in ((["--config", "elsewhere/settings.toml"], {}),
                                     ([], {"EDGECASE_CONFIG": "elsewhere/settings.toml"})):
            self.command("run", "--json", "r.json", *arguments, **variables)
            self.assertEqual(verdicts(self.told("r.json")), {"plain": "agree"})
        told = self.command("run", "--config", "no.toml", expect=USAGE).stderr
        self.assertTrue(told.startswith("no.toml: it cannot be read"), told)

    def test_a_misspelt_renderer_is_told_with_those_of_the_project(self):
        told = self.command("run", "--against", "mien", expect=USAGE).stderr
        self.assertEqual(told, f"edgecase: the project is {self.folder}/edgecase.toml\n"
                               'there is no renderer "mien"; did you mean "mine"? The project has '
                               "mine, ours\n")
        told = self.command("run", "--against", "llvmpipe", expect=USAGE).stderr
        self.assertIn("did you mean egl:llvmpipe?", told)

    def test_every_key_is_an_option(self):
        listed = self.command("run", "--help").stdout
        text = (ROOT / "tools/edgecase/project.cpp").read_text(encoding="utf-8")
        (outputs,) = re.findall(r"kOutputs = \{(.*?)\}", text, re.DOTALL)
        keys = re.findall(r'"(\w+)"', outputs)
        self.assertEqual(len(keys), 8)
        for option in ["against", "policy", "known", *keys]:
            self.assertRegex(listed, rf"(?m)^  (-\w,)?--{option}\b")

    def test_mistakes_are_told_with_their_line(self):
        for text, line, words in (
                ('cases = "raster"\ncase = "x"\n', 2, 'did you mean "cases"?'),
                ("policy = 3\n", 1, '"policy" is a number; write a text'),
                ('\nknown = ["a", 1]\n', 2, '"known" is a number'),
                ("cases = []\n", 1, '"cases" is an empty list'),
                ('renderers = "exact"\n', 1, "write a table: [renderers]"),
                ('[renderers]\n"my own" = "exact"\n', 2, "is no name for a renderer of yours"),
                ("[renderers]\nmine = true\n", 2, '"mine" is true or false'),
                ('[outputs]\njsno = "x"\n', 2, '[outputs] has no key "jsno"; did you mean "json"?'),
                ("cases = \n", 1, "https://toml.io explains the format")):
            with self.subTest(text):
                self.write("edgecase.toml", text)
                for command in ("run", "bless"):
                    told = self.command(command, expect=USAGE)
                    self.assertEqual(told.stdout, "")
                    self.assertTrue(told.stderr.startswith(f"edgecase.toml:{line}: "), told.stderr)
                    self.assertIn(words, told.stderr)


if __name__ == "__main__":
    unittest.main()
