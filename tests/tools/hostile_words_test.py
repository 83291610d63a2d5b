# SPDX-License-Identifier: MIT
"""What a renderer, a file or its name says that is no line of text: bytes that are no UTF-8,
control characters, too much. None of it reaches a terminal as it is, and none keeps a file from
being written that can be read again."""
import csv
import io
import json
import re
import shlex
import subprocess
import sys
import unittest

import results_file
from support import (EDGECASE, INTERNAL, PATIENCE, RENDERER, UNEXPECTED, USAGE, CommandTest,
                     triangle_case)

# Clears a terminal in two ways, and rings; JSON carries it.
HOSTILE = "clear \x1b[2J \x9b2J\n\x07 end"
# More than is quoted of it, with the cut inside a character.
DYING = "\u00e4".encode() * 400 + b"\xff\x1b[2J!!"
# Answers one pixel, dies where a target is 8 pixels wide, and refuses everything else.
PROGRAM = f"""
import json, os, sys
for line in sys.stdin:
    request = json.loads(line)
    target = request["scene"]["target"]
    if target["width"] == 8:
        os.write(2, {DYING!r})
        os._exit(1)
    claims = {{key: {HOSTILE!r} for key in ("device", "version", "vendor")}}
    claims["traits"] = {{"line_widths": {HOSTILE!r}}}
    answer = {{"digest": request["digest"], "renderer": claims}}
    if target["width"] * target["height"] == 1:
        answer.update(pixels=[0, 0, 0, 255], fragments=[])
    else:
        answer["not_run"] = {HOSTILE!r}
    print(json.dumps(answer), flush=True)
"""
CONTROLS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")
SMALL = triangle_case(target={"width": 4, "height": 4},
                      draws=[{"primitive": "triangles", "vertices": [[1, 1], [3.25, 1], [1, 3]]}])


class HostileWords(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases("dies")
        self.write("cases/refused.json", SMALL)
        program = self.write("hostile.py", PROGRAM)
        self.renderer = "exec:" + " ".join(map(shlex.quote, (sys.executable, str(program))))

    def told(self, *arguments, expect=None):
        """What the command prints, on both streams. Where no exit code is expected, it must not be
        that of a fault of its own."""
        run = self.command(*arguments, expect=expect)
        self.assertNotEqual(run.returncode, INTERNAL, run.stderr)
        text = run.stdout + run.stderr
        found = CONTROLS.search(text)
        self.assertIsNone(found, found and repr(text[max(0, found.start() - 200):found.end()]))
        return text

    def test_nothing_reaches_the_terminal_as_it_is(self):
        against = ("--against", self.renderer)
        self.assertIn("end", self.told("render", "cases", "--with", self.renderer, expect=RENDERER))
        self.assertIn("end", self.told("explain", "cases/refused.json", *against))
        self.assertIn("end", self.told("record", "cases", *against, "-o", "all.rec"))
        self.assertIn("end", self.told("backends", self.renderer))
        self.assertIn("end", self.told("run", "cases", *against, "--no-rerun", "--json",
                                       "results.json"))
        self.assertIn("end", self.told("bless", "results.json", "--reason", HOSTILE))

    def test_a_search_writes_what_it_found(self):
        text = self.told("fuzz", "--against", self.renderer, "--rules", "points", "--count", 300,
                         "--max-asks", 30, "--json", "finds.json", "--save", "cases/found")
        self.assertIn("crashed", text)
        finds = json.loads((self.folder / "finds.json").read_text("utf-8"))["finds"]
        self.assertTrue(finds)
        for find in finds:
            self.assertEqual(find["case"]["target"]["width"], 8)
            self.assertIn("\u00e4? [2J!!", find["case"]["why"])
            self.assertTrue((self.folder / find["file"]).exists())
        self.told("validate", "cases/found", expect=0)

    def test_a_long_command_line(self):
        """Longer than the title of a case and than the name of a file may be."""
        told = self.command("minimize", "cases/dies.json", "--against",
                            self.renderer + " " + 300 * "x", "--json", "--max-asks", 20)
        case = json.loads(told.stdout)["minimized"]
        self.assertEqual(len(case["title"]), 200)
        self.assertEqual(case["target"]["width"], 8)
        self.write("cases/small.json", case)
        self.told("validate", "cases/small.json", expect=0)

    def test_names_of_files(self):
        name = "a\x1b[2Jb.json"
        self.write(f"odd/{name}", SMALL)
        self.assertIn("a\u241b[2Jb", self.told("run", "odd", "--list", expect=0))
        self.told("explain", f"odd/{name}", expect=0)
        self.told("validate", "odd", expect=0)

    def test_a_key_of_ten_megabytes_is_cut(self):
        self.write("cases/long.json", '{"title": "t", "' + "k" * 10_000_000 + '": 1}')
        told = self.told("validate", "cases/long.json", expect=USAGE)
        self.assertLess(len(told), 2000)
        self.assertIn("kkk...", told)

    def test_nothing_hides_behind_a_nul(self):
        text = json.dumps(SMALL)
        self.write("cases/nul.json", text + "\0" + text)
        self.assertIn("byte", self.told("validate", "cases/nul.json", expect=USAGE))
        self.command("run", "cases/refused.json", "--against", "exact", "--json", "r.json")
        results = results_file.unpacked((self.folder / "r.json").read_bytes())
        self.write("r.json", results.rstrip() + "\0 more")
        self.assertIn("NUL", self.told("report", "r.json", expect=USAGE))
        self.write("known.json", '{"driver": "exact", "faults": []}\0')
        self.assertIn("NUL", self.told("run", "cases/refused.json", "--against", "exact", "--known",
                                       "known.json", expect=USAGE))

    def test_what_begins_like_a_formula_is_a_text(self):
        for name in ("=1+1", "+a", "-a", "@a"):
            self.write(f"formulas/{name}.json", SMALL)
        self.command("run", "formulas", "--against", self.odd_renderer("black", "", "formulas"),
                     "--csv", "found.csv", "--json", "r.json", expect=UNEXPECTED)
        rows = list(csv.reader(io.StringIO((self.folder / "found.csv").read_text("utf-8"))))
        self.assertEqual({row[0] for row in rows[1:]}, {"'=1+1", "'+a", "'-a", "'@a"})

    def test_standard_error_that_cannot_be_written(self):
        for arguments in (["run", "--against", "nonsense"], ["bless", "gone.json"],
                          ["fuzz", "--against", "nonsense"], ["nonsense"]):
            with open("/dev/full", "wb") as full:
                run = subprocess.run([EDGECASE, *arguments], cwd=self.folder, stderr=full,
                                     stdout=subprocess.DEVNULL, timeout=PATIENCE)
            self.assertEqual(run.returncode, INTERNAL, arguments)

    def test_files_that_speak_to_a_terminal(self):
        self.write("cases/key.json", {**SMALL, "\x1b[31m\n": 1, "title": HOSTILE})
        self.write("cases/name\x1b[2J.json", SMALL)
        text = self.told("validate", "cases", expect=USAGE)
        faults = [line for line in text.splitlines() if line.startswith("cases/")]
        self.assertEqual(len(faults), 2, text)
        for words in ("is no key", "title holds a control character"):
            self.assertIn(words, text)
        told = self.told("run", "cases", "--against", self.renderer, "--no-rerun")
        self.assertIn("drew none of", told)
        told = self.told("run", "cases/name\x1b[2J.json", "--against",
                         self.odd_renderer("die", "", "cases"), "--no-rerun")
        self.assertIn("name\u241b[2J: ", told)


if __name__ == "__main__":
    unittest.main()
