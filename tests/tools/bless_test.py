# SPDX-License-Identifier: MIT
"""Expectations: known faults are green, new, changed and vanished ones are red; `bless` shows what
it would change and writes only when asked."""
import json
import unittest

from support import AS_EXPECTED, INTERNAL, UNEXPECTED, USAGE, CommandTest, only_result

RENDERER = "osmesa:softpipe"
AGAINST = ["--against", RENDERER]
FILE = "cases/expectations/osmesa-softpipe.json"


class Bless(CommandTest):
    def setUp(self):
        super().setUp()
        self.copy_suite("points", "surfaces")

    def expectations(self):
        return json.loads((self.folder / FILE).read_text(encoding="utf-8"))

    def standings(self, expect, *options):
        results = self.results("cases", *AGAINST, *options, expect=expect)
        return {case["id"]: only_result(case)["standing"] for case in results["cases"]}

    def run_and_bless(self, *options, expect):
        self.results("cases", *AGAINST, expect=expect)
        return self.command("bless", "results.json", *options).stdout

    def test_nothing_to_bless(self):
        before = (self.folder / FILE).read_bytes()
        out = self.run_and_bless("--apply", expect=AS_EXPECTED)
        self.assertIn(f"{FILE}: 0 changes", out)
        self.assertEqual((self.folder / FILE).read_bytes(), before)

    def test_shows_then_writes_then_as_expected(self):
        (self.folder / FILE).unlink()
        standings = self.standings(UNEXPECTED)
        new = sorted(name for name, standing in standings.items() if standing == "unexpected")
        self.assertGreater(len(new), 10)
        out = self.command("bless", "results.json").stdout
        self.assertIn(f"{FILE}: {len(new)} changes", out)
        for name in new:
            self.assertIn(f"\n+ {name}: ", out)
        self.assertIn("Nothing is written. Run again with --apply", out)
        self.assertFalse((self.folder / FILE).exists())

        self.command("bless", "results.json", "--apply", "--reason", "known since the first day")
        written = self.expectations()
        self.assertEqual([entry["case"] for entry in written["expectations"]], new)
        self.assertEqual({e["reason"] for e in written["expectations"]},
                         {"known since the first day"})
        self.assertEqual(written["renderer"], RENDERER)
        self.assertIn("softpipe", written["measured"])
        self.assertEqual(set(self.standings(AS_EXPECTED).values()), {"expected"})

    def test_an_entry_that_now_agrees_is_red(self):
        content = self.expectations()
        agreeing = next(name for name, _ in self.standings(AS_EXPECTED).items()
                        if name not in {e["case"] for e in content["expectations"]})
        content["expectations"].append({"case": agreeing, "verdict": "violation",
                                        "fingerprint": "0123456789abcdef", "reason": "was so"})
        self.write(FILE, content)
        red = {name: standing for name, standing in self.standings(UNEXPECTED).items()
               if standing != "expected"}
        self.assertEqual(red, {agreeing: "unexpected-agreement"})
        out = self.command("bless", "results.json", "--apply").stdout
        self.assertIn(f"- {agreeing}: ", out)
        self.assertNotIn(agreeing, (self.folder / FILE).read_text(encoding="utf-8"))
        self.standings(AS_EXPECTED)

    def test_a_changed_fingerprint_or_verdict_is_red(self):
        for key, value in (("fingerprint", "0123456789abcdef"), ("verdict", "not-run")):
            content = self.expectations()
            entry = content["expectations"][0]
            original = dict(entry)
            entry[key] = value
            self.write(FILE, content)
            red = {name: standing for name, standing in self.standings(UNEXPECTED).items()
                   if standing != "expected"}
            self.assertEqual(red, {entry["case"]: "changed"}, key)
            out = self.command("bless", "results.json", "--apply").stdout
            self.assertIn(f"\n- {entry['case']}: ", out)
            self.assertIn(f"\n+ {entry['case']}: ", out)
            now = self.expectations()["expectations"][0]
            self.assertEqual({k: now[k] for k in ("verdict", "fingerprint")},
                             {k: original[k] for k in ("verdict", "fingerprint")})

    def test_reasons_and_links_of_others_stay(self):
        content = self.expectations()
        content["expectations"][0].update(reason="mine", link="https://example.org/1")
        content["expectations"][-1]["fingerprint"] = "0123456789abcdef"
        self.write(FILE, content)
        self.run_and_bless("--apply", expect=UNEXPECTED)
        first = self.expectations()["expectations"][0]
        self.assertEqual((first["reason"], first["link"]), ("mine", "https://example.org/1"))

    def test_only_what_the_filter_names(self):
        (self.folder / FILE).unlink()
        self.run_and_bless("--apply", "--filter", "points/*", expect=UNEXPECTED)
        names = [entry["case"] for entry in self.expectations()["expectations"]]
        self.assertTrue(names)
        self.assertTrue(all(name.startswith("points/") for name in names))
        out = self.command("bless", "results.json", "--against", "exact").stdout
        self.assertNotIn("changes", out)

    def test_entries_of_cases_that_are_gone(self):
        content = self.expectations()
        content["expectations"].append({"case": "points/gone", "verdict": "violation",
                                        "fingerprint": "0123456789abcdef", "reason": "was so"})
        self.write(FILE, content)
        self.standings(AS_EXPECTED, "--filter", "*")
        out = self.command("bless", "results.json", "--apply").stdout
        self.assertIn(f"{FILE}: 0 changes", out, "a filter may have left the case out")
        results = self.results("cases", *AGAINST, "--junit", "junit.xml", expect=UNEXPECTED)
        self.assertTrue(results["whole_suite"])
        self.assertEqual(results["missing"],
                         [{"renderer": RENDERER, "case": "points/gone", "verdict": "violation",
                           "fingerprint": "0123456789abcdef", "reason": "was so"}])
        self.assertIn("points/gone", (self.folder / "junit.xml").read_text("utf-8"))
        out = self.command("run", "cases", *AGAINST, "--json", "results.json",
                           expect=UNEXPECTED).stdout
        self.assertIn("`edgecase bless --apply` removes them", out)
        self.assertIn("points/gone", out)
        for i in (1, 2):
            self.command("run", "cases", *AGAINST, "--shard", f"{i}/2", "--json", f"{i}.json")
        self.command("merge", "1.json", "2.json", "--json", "merged.json", expect=UNEXPECTED)
        self.assertEqual(json.loads((self.folder / "merged.json").read_text("utf-8")), results)

        out = self.command("bless", "results.json", "--apply").stdout
        self.assertIn("\n- points/gone: ", out)
        self.assertNotIn("points/gone", (self.folder / FILE).read_text("utf-8"))
        self.standings(AS_EXPECTED)

    def decide(self, *decisions, expect=AS_EXPECTED):
        self.write("decisions.json", {"edgecase_decisions": 1, "renderer": RENDERER,
                                      "decisions": decisions})
        return self.command("bless", "results.json", "--from", "decisions.json", "--apply",
                            expect=expect)

    def test_decisions(self):
        (self.folder / FILE).unlink()
        results = self.results("cases", *AGAINST, expect=UNEXPECTED)
        one, other, third = [
            {"case": case["id"], "verdict": result["verdict"], "reason": "seen",
             "fingerprint": result["fingerprint"], "decision": "accept"}
            for case in results["cases"] for result in [only_result(case)]
            if result["verdict"] != "agree"][:3]
        late = {**other, "fingerprint": "0123456789abcdef"}
        elsewhere = {**third, "renderer": "egl:softpipe"}
        run = self.decide({**one, "link": "https://example.org/3"}, late,
                          {**third, "decision": "reject"}, elsewhere, expect=UNEXPECTED)
        self.assertIn(f"! {other['case']} {RENDERER}: refused: it was made on", run.stdout)
        self.assertIn(f"! {third['case']} egl:softpipe: refused", run.stdout)
        self.assertIn(f"{third['case']} {RENDERER}: rejected, and stays unexpected", run.stdout)
        self.assertEqual(self.expectations()["expectations"],
                         [{"case": one["case"], "verdict": one["verdict"],
                           "fingerprint": one["fingerprint"], "reason": "seen",
                           "link": "https://example.org/3"}])
        # The same again changes nothing; made on no entry, a rejection comes too late.
        self.assertIn(": 0 changes", self.decide({**one, "link": "https://example.org/3"}).stdout)
        self.assertIn("refused: it was made when nothing was expected",
                      self.decide({**one, "decision": "reject"}, expect=UNEXPECTED).stdout)
        seen = {"verdict": one["verdict"], "fingerprint": one["fingerprint"]}
        self.decide({**one, "decision": "reject", "expected": seen})
        self.assertEqual(self.expectations()["expectations"], [])

    def test_results_say_what_was_expected(self):
        content = self.expectations()
        content["expectations"][0]["fingerprint"] = "0123456789abcdef"
        self.write(FILE, content)
        results = self.results("cases", *AGAINST, expect=UNEXPECTED)
        entry = content["expectations"][0]
        (case,) = [case for case in results["cases"] if case["id"] == entry["case"]]
        self.assertEqual(only_result(case)["expected"],
                         {"verdict": entry["verdict"], "fingerprint": "0123456789abcdef"})

    def test_broken_decisions(self):
        self.results("cases", *AGAINST)
        good = {"case": "a", "verdict": "agree", "fingerprint": "", "decision": "accept",
                "reason": "why"}
        for bad, said in (({**good, "more": 1}, "/decisions/0 (case a): unknown key \"more\""),
                          ({**good, "reason": ""}, "\"reason\" is empty"),
                          ({**good, "decision": "maybe"}, "\"maybe\" is no decision")):
            self.assertIn(said, self.decide(bad, expect=USAGE).stderr)
        self.assertIn("/decisions/1 (case a): /decisions/0 is on",
                      self.decide(good, good, expect=USAGE).stderr)
        self.command("bless", "results.json", "--from", "gone.json", expect=INTERNAL)
        self.command("bless", "gone.json", expect=INTERNAL)
        self.command("bless", "results.json", "--from", "decisions.json", "--filter", "*",
                     expect=USAGE)

    def test_a_failure_can_be_expected(self):
        self.write("small/a.json", (self.folder / "cases/points/centres.json").read_text("utf-8"))
        refuser = self.odd_renderer("refuse", "", "small")
        self.results("small", "--against", refuser, expect=UNEXPECTED)
        self.command("bless", "results.json", "--folder", "expected", "--apply")
        (path,) = (self.folder / "expected").iterdir()
        results = self.results("small", "--against", refuser, "--expectations", path)
        self.assertEqual(only_result(results["cases"][0])["verdict"], "not-run")


if __name__ == "__main__":
    unittest.main()
