# SPDX-License-Identifier: MIT
"""Outputs for CI beside the HTML report, as parsers of other people's read them: JUnit XML, CTRF,
CSV, Markdown, GitHub's annotations and PNG triptychs; the same from `run` and from `report`."""
import csv
import io
import json
import os
import re
import signal
import time
import unittest
import xml.etree.ElementTree

from commands_test import png_pixels
import results_file
from support import (AS_EXPECTED, INTERNAL, UNEXPECTED, USAGE, CommandTest, only_result,
                     triangle_case)

KINDS = {"junit": "xml", "ctrf": "json", "markdown": "md", "annotations": "txt", "csv": "csv"}
HOSTILE = 'a,b "c" ]]> %0A%25 ::error::x <i>&amp; |`tick`` \\ \x01\x1b\u202e'
LONG = HOSTILE + "\r\n::warning file=x::\n" + "n" * 10000

# What CTRF 0.0.0 asks of its objects: required members, then those that may be there.
CTRF = {
    "report": ({"reportFormat": str, "specVersion": str, "results": dict}, {"generatedBy": str}),
    "results": ({"tool": dict, "summary": dict, "tests": list}, {"extra": dict}),
    "tool": ({"name": str}, {"version": str}),
    "summary": ({key: int for key in ("tests", "passed", "failed", "skipped", "pending", "other",
                                      "start", "stop")}, {"suites": int}),
    "test": ({"name": str, "status": str, "duration": int},
             {"suite": list, "message": str, "trace": str, "line": int, "rawStatus": str,
              "tags": list, "filePath": str, "extra": dict}),
}


def visible(text, keep_breaks=False):
    """A text as reports show it: control characters as their pictures."""
    def shown(c):
        if keep_breaks and c in "\n\t":
            return c
        if ord(c) < 32:
            return chr(0x2400 + ord(c))
        return "\ufffd" if c == "\u202e" and not keep_breaks else c
    return "".join(map(shown, text))


def unescaped(text):
    """A property or message of a workflow command, as GitHub reads it."""
    for code, character in (("%0D", "\r"), ("%0A", "\n"), ("%3A", ":"), ("%2C", ","), ("%25", "%")):
        text = text.replace(code, character)
    return text


def commands(text):
    """(name, properties, message) of each line."""
    for line in text.split("\n")[:-1]:
        name, properties, message = re.fullmatch(r"::(\w+) (.*?)::(.*)", line).groups()
        pairs = dict(pair.split("=", 1) for pair in properties.split(","))
        yield name, {key: unescaped(value) for key, value in pairs.items()}, unescaped(message)


class Outputs(CommandTest):
    def setUp(self):
        super().setUp()
        # The name of a file may be anything but for a colon.
        self.names = ["plain", HOSTILE.replace(":", "")]
        for name in self.names:
            self.write(f"cases/{name}.json", triangle_case(title=f"Triangle {HOSTILE[:40]}"))
        self.write("cases/swept.json", triangle_case(sweep={
            "dx": {"add_to": ["/draws/0/vertices/0/x"], "values": [0, 0.5]}}))
        self.renderer = self.odd_renderer("mirror", "", "cases")
        self.options = [word for kind, suffix in KINDS.items()
                        for word in (f"--{kind}", f"run.{suffix}" if kind != "ctrf" else "ctrf.json")]
        self.command("run", "cases", "--against", self.renderer, "--json", "results.json",
                     *self.options, "--triptychs", "pictures", expect=UNEXPECTED)
        self.results = results_file.read(self.folder / "results.json")

    def text(self, name):
        return (self.folder / name).read_bytes().decode("utf-8")

    def renamed(self, name):
        """The files that `report` makes of the results with this id for every case but the first,
        numbered."""
        for number, case in enumerate(self.results["cases"][1:]):
            case["id"] = f"{name}{number}"
            case["title"] = LONG
            case["file"] = f"{name}.json"
        self.write_results("hostile.json", self.results)
        self.command("report", "hostile.json", *self.options, "--triptychs", "pictures")
        return f"{name}0"

    def ids(self):
        return [case["id"] for case in self.results["cases"]]

    def check_ctrf(self, report):
        def check(kind, value):
            required, optional = CTRF[kind]
            self.assertLessEqual(set(required), set(value))
            self.assertLessEqual(set(value), set(required) | set(optional))
            for key, member in value.items():
                self.assertIs(type(member), {**required, **optional}[key], key)

        check("report", report)
        self.assertEqual(report["reportFormat"], "CTRF")
        self.assertRegex(report["specVersion"], r"^\d+\.\d+\.\d+$")
        results = report["results"]
        check("results", results)
        check("tool", results["tool"])
        check("summary", results["summary"])
        statuses = [test["status"] for test in results["tests"]]
        for status in ("passed", "failed", "skipped", "pending", "other"):
            self.assertEqual(results["summary"][status], statuses.count(status))
        self.assertEqual(results["summary"]["tests"], len(statuses))
        for test in results["tests"]:
            check("test", test)
            self.assertTrue(test["name"])
            self.assertIn(test["status"], ("passed", "failed", "skipped", "pending", "other"))
            self.assertTrue(test["suite"] and all(type(name) is str for name in test["suite"]))
        return results["tests"]

    def test_report_makes_what_run_made(self):
        names = [name for name in self.options if not name.startswith("--")]
        made = {name: self.text(name) for name in names}
        pictures = {path: path.read_bytes() for path in self.folder.glob("pictures/**/*.png")}
        self.assertEqual(len(pictures), len(self.names) + 2)
        # What artifacts of GitHub and file systems take.
        for path in pictures:
            self.assertRegex(path.name, r'^[^\x00-\x1f\x7f-\U0010ffff"*/:<>?\\|]{1,255}$')
        self.assertEqual({path.name for path in pictures if path.name.startswith("swept")},
                         {"swept@dx=0.png", "swept@dx=0.5.png"})
        for path in [self.folder / name for name in names] + list(pictures):
            path.unlink()
        run = self.command("report", "results.json", *self.options, "--triptychs", "pictures")
        self.assertEqual(run.stdout, "")
        self.assertEqual({name: self.text(name) for name in names}, made)
        self.assertEqual({path: path.read_bytes() for path in pictures}, pictures)

    def test_times_of_cases_reach_what_ci_systems_read(self):
        run = ["run", "cases", "--against", self.renderer, "--no-rerun"]
        self.command(*run, "--json", "timed.zst", "--timings", "times.jsonl", "--junit", "timed.xml",
                     expect=UNEXPECTED)
        times = [json.loads(line) for line in self.text("times.jsonl").splitlines()]
        self.assertEqual([one["case"] for one in times], self.ids())
        for one in times:
            self.assertEqual(list(one["seconds"]), [self.renderer])
            self.assertGreater(one["seconds"][self.renderer], 0)
        self.assertEqual((self.folder / "timed.zst").read_bytes(),
                         (self.folder / "results.json").read_bytes(), "times are kept apart")
        self.assertNotEqual(self.text("timed.xml"), self.text("run.xml"))
        self.command("report", "timed.zst", "--timings", "times.jsonl", "--junit", "again.xml",
                     "--ctrf", "again.json")
        self.assertEqual(self.text("again.xml"), self.text("timed.xml"))
        self.check_ctrf(json.loads(self.text("again.json")))
        run = self.command("report", "timed.zst", "--timings", "cases/plain.json", "--junit",
                           "again.xml", expect=USAGE)
        self.assertIn("cases/plain.json: these are no durations: line 1: ", run.stderr)

    def test_hostile_names(self):
        for name in ("../../x", HOSTILE, LONG, "a/" * 3000):
            with self.subTest(name[:40]):
                self.check_hostile(self.renamed(name))

    def check_hostile(self, name):
        tests = [test.get("name") for test in
                 xml.etree.ElementTree.parse(self.folder / "run.xml").iter("testcase")]
        self.assertEqual(sorted(tests), sorted(map(visible, self.ids())))
        told = [test["name"] for test in self.check_ctrf(json.loads(self.text("ctrf.json")))]
        self.assertEqual(sorted(told), sorted(tests))
        rows = list(csv.DictReader(io.StringIO(self.text("run.csv"), newline="")))
        # No line begins with a command of GitHub's, should it be shown in a log.
        shown = visible(name, keep_breaks=True).replace("\r", "\u240d").replace("\n::", "\n: :")
        self.assertIn(shown, {row["case"] for row in rows})
        files = {properties["file"]: properties["title"]
                 for _, properties, _ in commands(self.text("run.txt"))}
        self.assertEqual(len(files), 2, "one for all cases of a file")
        file = visible(f"{name[:-1]}.json", keep_breaks=True).replace("\n::", "\n: :")
        self.assertIn(file, files)
        self.assertTrue(files[file].startswith(visible(name)[:100]))
        self.assertLess(len(self.text("run.md")), 20000)
        self.assertIn(visible(name).replace("|", "\\|")[:100], self.text("run.md"))
        outside = [path for path in self.folder.rglob("*.png")
                   if self.folder / "pictures" not in path.parents]
        self.assertEqual(outside, [])

    def test_a_row_of_csv_is_a_disagreement(self):
        text = self.text("run.csv")
        self.assertEqual(text.count("\r\n"), text.count("\r"))
        rows = list(csv.DictReader(io.StringIO(text, newline=""), strict=True))
        told = [(case["id"], d) for case in self.results["cases"]
                for d in only_result(case)["disagreements"]]
        self.assertEqual(len(rows), len(told))
        for row, (name, d) in zip(rows, told):
            self.assertIsNone(row.get(None))
            self.assertEqual((row["case"], row["renderer"]),
                             (visible(name, keep_breaks=True), self.renderer))
            self.assertEqual([int(row["x"]), int(row["y"])], d["pixel"])
            self.assertEqual((row["kind"], row["rule"], row["explanation"], row["cause"]),
                             (d["kind"], d["rule"], d["explanation"], d["cause"]))
            self.assertEqual(row["legality"], d["legality"])
            self.assertEqual([float(number) for number in row["rendered"].split()], d["rendered"])

    def test_annotations_of_a_checkout(self):
        self.command("run", "cases/plain.json", "--against", self.renderer, "--annotations", "a.txt",
                     expect=UNEXPECTED, GITHUB_WORKSPACE=str(self.folder.parent))
        ((name, properties, message),) = commands(self.text("a.txt"))
        self.assertEqual((name, properties["line"]), ("error", "1"))
        self.assertEqual(properties["file"], f"{self.folder.name}/cases/plain.json")
        self.assertTrue(message.startswith("violation, unexpected, "), message[:100])

    def test_annotations_on_standard_output_stand_alone(self):
        run = self.command("run", "cases", "--against", self.renderer, "--annotations", "-",
                           expect=UNEXPECTED)
        self.assertEqual(run.stdout, self.text("run.txt"))
        self.assertIn("violation", run.stderr)

    def test_failures_can_be_read(self):
        test = xml.etree.ElementTree.parse(self.folder / "run.xml").find(".//testcase")
        lines = test.find("failure").text.splitlines()
        self.assertTrue(lines[0].startswith("Triangle a,b"))
        self.assertTrue(any(line.startswith("pixel (") for line in lines))
        self.assertTrue(any(line.startswith("explained by: edgecase explain ") for line in lines))

    def test_a_triptych_shows_the_three(self):
        (path,) = self.folder.glob("pictures/*/plain.png")
        width, height, rows = png_pixels(path.read_bytes())
        case = next(c for c in self.results["cases"] if c["id"] == "plain")
        scale = height // case["height"]
        self.assertGreaterEqual(scale, 8)
        panel = case["width"] * scale
        exact, rendered = (b"".join(results_file.picture_of(case, picture))
                           for picture in ({}, only_result(case)))
        self.assertNotEqual(exact, rendered)
        listed = {tuple(d["pixel"]) for d in only_result(case)["disagreements"]}
        for y in range(case["height"]):
            for x in range(case["width"]):
                row = rows[(case["height"] - 1 - y) * scale + scale // 2]
                at = x * scale + scale // 2
                index = 4 * (y * case["width"] + x)
                self.assertEqual(row[at][:3], list(exact[index:index + 3]))
                self.assertEqual(row[width - panel + at][:3], list(rendered[index:index + 3]))
                red, green, blue, _ = row[(width - panel) // 2 + at]
                self.assertEqual((x, y) in listed, len({red, green, blue}) > 1)

    def test_nothing_to_tell(self):
        for triptychs in ("none", "none/"):
            self.command("run", "cases", "--against", "exact", *self.options,
                         "--triptychs", triptychs)
            self.assertEqual(self.text("run.txt"), "")
            self.assertEqual(len(self.text("run.csv").splitlines()), 1)
            self.assertFalse((self.folder / "none").exists())
            self.assertNotIn("<failure", self.text("run.xml"))

    def test_every_option_is_told(self):
        for subcommand in ("run", "report", "merge"):
            told = self.command(subcommand, "--help", expect=AS_EXPECTED).stdout
            for kind in (*KINDS, "triptychs"):
                self.assertIn(f"--{kind} ", told)

    def opener(self, script):
        """A PATH whose xdg-open is this script of a shell."""
        path = self.write("bin/xdg-open", f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)
        return f"{path.parent}:{os.environ['PATH']}"

    def test_the_report_is_opened(self):
        opened = self.folder / "opened"
        path = self.opener(f'echo "$@" > {opened}')
        for command in (["run", "cases/plain.json", "--against", "exact"],
                        ["report", "results.json"], ["merge", "results.json"]):
            with self.subTest(command[0]):
                run = self.command(*command, "--html", "page.html", "--open", PATH=path,
                                   expect=None)
                self.assertEqual(run.stderr, "")
                self.assertEqual(opened.read_text(), f"{self.folder}/page.html\n")
                opened.unlink()
        # By default it is written to out/.
        self.command("run", "cases/plain.json", "--against", "exact", "--open", PATH=path)
        self.assertEqual(opened.read_text(), f"{self.folder}/out/report.html\n")

    def test_a_browser_that_stays_is_not_waited_for(self):
        path = self.opener("sleep 600 & echo $! > asleep; wait")
        start = time.monotonic()
        run = self.command("report", "results.json", "--html", "page.html", "--open", PATH=path)
        self.assertLess(time.monotonic() - start, 300)
        self.assertEqual(run.stderr, "")
        os.kill(int(self.text("asleep")), signal.SIGKILL)

    def test_where_it_cannot_be_opened(self):
        report = ("report", "results.json", "--html", "page.html", "--open")
        self.assertEqual(self.command(*report, PATH="/nowhere").stderr,
                         "edgecase: --open: there is no xdg-open here; open page.html in a browser\n")
        self.assertEqual(self.command(*report, PATH=self.opener("exit 3")).stderr,
                         "edgecase: --open: xdg-open finds no browser; open page.html in a "
                         "browser\n")
        self.assertEqual(self.command("report", "results.json", "--csv", "a.csv", "--open").stderr,
                         "edgecase: --open opens the HTML report, and none is written; add "
                         "--html FILE\n")

    def test_unwritable_outputs(self):
        for option in (*KINDS, "triptychs"):
            for path in ("/proc/none/out", "results.json/out"):
                with self.subTest(f"{option} {path}"):
                    run = self.command("report", "results.json", f"--{option}", path,
                                       expect=INTERNAL)
                    self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
                    self.assertIn(f"cannot write {path}", run.stderr)


if __name__ == "__main__":
    unittest.main()
