# SPDX-License-Identifier: MIT
"""What is contested: told in every output, after the violation beside it, and red with --strict.

The finding is planted: in the results of a run, what differs in one case is said to break a ruling
whose basis is contested. `merge` and `run --resume` judge it as any other."""
import csv
import io
import json
import unittest
import xml.etree.ElementTree as ET

import results_file
from support import AS_EXPECTED, UNEXPECTED, CommandTest

CONTESTED, VIOLATION = "b-contested", "a-violation"


class Contested(CommandTest):
    def setUp(self):
        super().setUp()
        rules = json.loads(self.command("rules", "--json").stdout)
        self.ruling = next(ruling for rule in rules for ruling in rule["rulings"]
                           if ruling["basis"] == "contested")

    def plant(self, *names):
        """Results of cases with these names, in which CONTESTED is contested."""
        self.write_cases(*names)
        self.renderer = self.odd_renderer("black", "", "cases")
        results = self.results("cases", "--against", self.renderer, expect=UNEXPECTED)
        for case in results["cases"]:
            for d in case["results"][self.renderer]["disagreements"]:
                self.assertEqual(d["legality"], "illegal")
                if case["id"] == CONTESTED:
                    d["ruling"] = self.ruling["number"]
        self.write_results("planted.json", results)

    def merged(self, *options, expect):
        self.command("merge", "planted.json", "-o", "merged.json", *options, expect=expect)
        cases = results_file.read(self.folder / "merged.json")["cases"]
        return {case["id"]: case["results"][self.renderer] for case in cases}

    def test_it_is_red_only_with_strict(self):
        self.plant(CONTESTED)
        for options, standing, code in (([], "tolerated", AS_EXPECTED),
                                        (["--strict"], "unexpected", UNEXPECTED)):
            found = self.merged(*options, expect=code)[CONTESTED]
            self.assertEqual((found["verdict"], found["standing"]), ("contested", standing))
            self.assertEqual({d["legality"] for d in found["disagreements"]}, {"contested"})
            self.assertGreater(found["pixel_counts"]["contested"], 0)
            self.assertEqual(found["pixel_counts"]["violation"], 0)
        for options, code in (([], AS_EXPECTED), (["--strict"], UNEXPECTED)):
            self.write("results.json", (self.folder / "planted.json").read_text("utf-8"))
            self.command("run", "cases", "--against", self.renderer, "--json", "results.json",
                         "--resume", *options, expect=code)

    def test_report_shows_it_red_with_strict(self):
        self.plant(CONTESTED)
        self.merged(expect=AS_EXPECTED)
        for options, failures in ([], "0"), (["--strict"], "1"):
            self.command("report", "merged.json", "--junit", "junit.xml", *options)
            suites = ET.parse(self.folder / "junit.xml").getroot()
            self.assertEqual(suites.get("failures"), failures)

    def test_it_may_be_known(self):
        self.plant(CONTESTED)
        self.merged(expect=AS_EXPECTED)
        shown = self.command("bless", "merged.json", "--strict", "--apply", "--reason",
                             "it is open").stdout
        self.assertIn(f'"cases": ["{CONTESTED}"]', shown)
        found = self.merged("--strict", expect=AS_EXPECTED)[CONTESTED]
        self.assertEqual(found["standing"], "known")
        self.assertIn("it is open (triangle.fill-rule)", found["standing_reason"])

    def test_each_output_tells_the_violation_first(self):
        self.plant(CONTESTED, VIOLATION)
        found = self.merged(
            "--junit", "junit.xml", "--ctrf", "ctrf.json", "--markdown", "summary.md",
            "--annotations", "annotations.txt", "--csv", "differences.csv", "--html", "report.html",
            expect=UNEXPECTED)
        self.assertEqual({name: result["verdict"] for name, result in found.items()},
                         {CONTESTED: "contested", VIOLATION: "violation"})
        texts = {name: (self.folder / name).read_text("utf-8")
                 for name in ("junit.xml", "ctrf.json", "summary.md", "annotations.txt")}
        for name, text in texts.items():
            with self.subTest(output=name):
                self.assertLess(text.index(VIOLATION), text.index(CONTESTED))
                self.assertIn("contested", text.replace(CONTESTED, ""))
        suites = ET.fromstring(texts["junit.xml"])
        self.assertEqual(suites.get("failures"), "1")
        self.assertEqual([case.get("name") for case in suites.iter("testcase")
                          if case.find("system-out") is not None], [CONTESTED])
        self.assertRegex(texts["annotations.txt"], rf"\A::error .*{VIOLATION}")
        self.assertRegex(texts["annotations.txt"], rf"\n::warning .*{CONTESTED}")
        rows = list(csv.DictReader(io.StringIO((self.folder / "differences.csv").read_text("utf-8"))))
        self.assertEqual({(row["case"], row["verdict"], row["legality"]) for row in rows},
                         {(CONTESTED, "contested", "contested"),
                          (VIOLATION, "violation", "illegal")})

    def test_the_summary_tells_it_apart(self):
        self.plant(CONTESTED, VIOLATION)
        summary = self.command("merge", "planted.json", "-o", "merged.json",
                               expect=UNEXPECTED).stdout
        for row in (r"violation +1", r"contested +1", r"unexpected +1"):
            self.assertRegex(summary, rf"(?m)^{row}$")
        self.assertLess(summary.index("  not allowed  "), summary.index("  contested    "))

    def test_clusters_never_mix_it(self):
        self.plant(CONTESTED, VIOLATION)
        self.merged(expect=UNEXPECTED)
        results = results_file.read(self.folder / "merged.json")
        clusters = results["clusters"][self.renderer]
        self.assertEqual({c["legality"] for c in clusters}, {"illegal", "contested"})
        order = [c["legality"] for c in clusters]
        self.assertEqual(order, sorted(order, reverse=True), "illegal before contested")
        self.assertEqual(results["summary"][self.renderer], {"contested": 1, "violation": 1})


if __name__ == "__main__":
    unittest.main()
