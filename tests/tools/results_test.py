# SPDX-License-Identifier: MIT
"""What results of the suite say, those of the four Mesa renderers: clusters count what is told, what
is cited exists, reports can be made of them again, a sample is judged as the whole, and
--no-latitude."""
import json
import unittest

from results_file import cases_of, head_of, places_of
from suite_data import mesa, shard
from support import MESA, PROBES, UNEXPECTED, UNHURRIED, CommandTest, contents, report_options


class Results(CommandTest):
    def test_clusters_count_every_disagreement_once(self):
        keys = ("disagreements", "differing", "with a cause")
        counts = {renderer: dict.fromkeys(keys, 0) for renderer in MESA}
        for case in cases_of(mesa() / "reports.json"):
            for renderer, result in case["results"].items():
                count, told, values = counts[renderer], result["disagreements"], result["values"]
                count["disagreements"] += len(told)
                count["differing"] += sum(len(places_of(v)) for v in values)
                count["with a cause"] += (
                    sum(1 for d in told if d["cause"]) +
                    sum(len(places_of(v)) for v in values if "cause" in v))
        for renderer, clusters in head_of(mesa() / "reports.json")["clusters"].items():
            count = counts.pop(renderer)
            self.assertGreater(count["disagreements"], 0)
            self.assertEqual(sum(c["disagreements"] for c in clusters),
                             count["disagreements"] + count["differing"])
            as_if = sum(disagreements for c in clusters
                        for text, disagreements, _ in c.get("situations", [])
                        if text.startswith("as if "))
            self.assertGreaterEqual(
                sum(c["disagreements"] for c in clusters if "cause" in c) + as_if,
                count["with a cause"], "a cause of the run explains what has none of its own")
            order = [(["illegal", "contested", "legal"].index(c["legality"]), -c["cases"])
                     for c in clusters]
            self.assertEqual(order, sorted(order), "illegal ones first, then what most share")
        self.assertEqual(counts, {})

    def test_every_ruling_and_rule_that_results_cite_exists(self):
        rules = json.loads(self.command("rules", "--json").stdout)
        ids = {rule["id"] for rule in rules}
        numbers = {ruling["number"] for rule in rules for ruling in rule["rulings"]}
        for case in cases_of(mesa() / "reports.json"):
            self.assertLessEqual(set(case["rules"]), ids)
            for told in (d for result in case["results"].values() for d in result["disagreements"]):
                self.assertIn(told["rule"], ids)
                self.assertIn(told["ruling"], numbers)
                self.assertRegex(told["explanation"], r"\d")
                for cause in filter(None, told["cause"].split(" + ")):
                    rule, _, name = cause.partition("=")
                    self.assertIn(rule, ids)
                    self.assertTrue(name)

    def test_reports_from_a_results_file_are_those_of_the_run(self):
        self.command("report", mesa() / "reports.json", *report_options("."), expect=None)
        first = {path.name: path.read_bytes() for path in mesa().glob("reports.*")}
        again = contents(self.folder)
        self.assertEqual(first.keys(), again.keys())
        for name in first:
            self.assertTrue(first[name] == again[name], name)

    def test_a_sample_is_judged_as_the_whole_is(self):
        fingerprints = {case["id"]: case["results"]["egl:softpipe"]["fingerprint"]
                        for case in cases_of(mesa() / "reports.json")}
        for part in 1, 4:
            self.command("run", *PROBES, "--against", "egl:softpipe", *UNHURRIED,
                         *shard(part, 6), "--json", "part.json")
            found = {case["id"]: case["results"]["egl:softpipe"]["fingerprint"]
                     for case in cases_of(self.folder / "part.json")}
            self.assertLessEqual(found.items(), fingerprints.items())
            self.assertAlmostEqual(len(found), len(fingerprints) / 6, delta=1)

    def test_without_latitude_every_difference_is_a_violation(self):
        against = ["--against", "egl:llvmpipe", "--against", "egl:softpipe"]
        self.command("run", *PROBES, *against, *UNHURRIED, *shard(1, 5), "--no-latitude", "--json",
                     "strict.json", expect=UNEXPECTED)
        strict = {case["id"]: case["results"] for case in cases_of(self.folder / "strict.json")}
        for lenient in cases_of(mesa() / "reports.json"):
            for renderer, result in strict.pop(lenient["id"], {}).items():
                verdict = lenient["results"][renderer]["verdict"]
                kept = verdict in ("agree", "not-run")
                self.assertEqual(result["verdict"], verdict if kept else "violation",
                                 lenient["id"])
        self.assertEqual(strict, {})


if __name__ == "__main__":
    unittest.main()
