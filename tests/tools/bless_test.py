# SPDX-License-Identifier: MIT
"""Known faults: what is known is green, what is new or has grown is red; `bless` shows what it would
change and writes only when asked."""
import json
import unittest

from support import (AS_EXPECTED, INTERNAL, NOTHING_DRAWN, UNEXPECTED, USAGE, CommandTest,
                     only_result)

RENDERER = "egl:softpipe"
AGAINST = ["--against", RENDERER]
FILE = "cases/known/softpipe.json"


class Bless(CommandTest):
    def setUp(self):
        super().setUp()
        self.copy_suite("points", "surfaces")

    def faults(self):
        return {fault["id"]: fault for fault in
                json.loads((self.folder / FILE).read_text(encoding="utf-8"))["faults"]}

    def write_faults(self, *faults):
        self.write(FILE, {"driver": "softpipe", "faults": faults})

    def standings(self, expect, *options):
        results = self.results("cases", *AGAINST, *options, expect=expect)
        return {case["id"]: only_result(case)["standing"] for case in results["cases"]}

    def blessed(self):
        """The file that holds what these folders show, and nothing more."""
        (self.folder / FILE).unlink()
        self.results("cases", *AGAINST, expect=UNEXPECTED)
        return self.command("bless", "results.json", "--apply", "--reason", "since long").stdout

    def test_what_is_known_of_the_whole_suite_is_green(self):
        standings = self.standings(AS_EXPECTED)
        self.assertEqual(set(standings.values()), {"expected", "known"})

    def test_shows_then_writes_then_is_known(self):
        (self.folder / FILE).unlink()
        new = {name for name, standing in self.standings(UNEXPECTED).items()
               if standing == "unexpected"}
        self.assertGreater(len(new), 10)
        out = self.command("bless", "results.json").stdout
        self.assertIn('\n+     {"id": "', "\n" + out)
        self.assertIn("Nothing is written. Run again with --apply", out)
        self.assertFalse((self.folder / FILE).exists())

        self.command("bless", "results.json", "--apply", "--reason", "since the first day",
                     "--link", "https://example.org/1")
        faults = self.faults()
        self.assertLess(len(faults), len(new))
        self.assertEqual({(f["reason"], f["link"]) for f in faults.values()},
                         {("since the first day", "https://example.org/1")})
        standings = self.standings(AS_EXPECTED)
        self.assertEqual({name for name, standing in standings.items() if standing == "known"}, new)
        out = self.command("bless", "results.json").stdout
        self.assertIn(f"{FILE}: 0 changes", out)

    def test_a_fault_that_has_grown_is_red(self):
        self.blessed()
        faults = self.faults()
        name, fault = next(iter(faults.items()))
        ((release, count),) = fault["cases_on"].items()
        fault["cases_on"][release] = count - 1
        self.write_faults(*faults.values())
        run = self.command("run", "cases", *AGAINST, "--json", "results.json", "--junit",
                           "junit.xml", expect=UNEXPECTED)
        self.assertIn("0 unexpected, 1 known fault grown", run.stdout)
        self.assertIn(f"{name} {RENDERER}: it has grown: {count} cases", run.stdout)
        self.assertIn("it has grown", (self.folder / "junit.xml").read_text("utf-8"))
        self.standings(AS_EXPECTED, "--filter", "*")
        for i in (1, 2):
            self.command("run", "cases", *AGAINST, "--shard", f"{i}/2", "--json", f"{i}.json")
        self.command("merge", "1.json", "2.json", "--json", "merged.json", expect=UNEXPECTED)

        fault["cases_on"][release] = count + 1
        self.write_faults(*faults.values())
        run = self.command("run", "cases", *AGAINST, "--json", "results.json")
        self.assertIn("it has shrunk", run.stdout)
        self.command("bless", "results.json", "--apply")
        self.assertEqual(self.faults()[name]["cases_on"], {release: count})

    def test_a_fault_that_does_not_show_is_told_and_closed(self):
        self.blessed()
        (release,) = {name for fault in self.faults().values() for name in fault["cases_on"]}
        gone = {"id": "gone", "rule": "line.joint", "kind": "missing", "cases": ["points"],
                "versions": "Mesa >=1", "cases_on": {"Mesa 1.0": 3, release: 2},
                "reason": "was so"}
        self.write_faults(*self.faults().values(), gone)
        run = self.command("run", "cases", *AGAINST, "--json", "results.json")
        self.assertIn(f"gone {RENDERER}: it is fixed: none of 2 cases", run.stdout)
        self.command("bless", "results.json", "--apply")
        self.assertRegex(self.faults()["gone"]["versions"], r"^Mesa >=1 <\d+\.\d+")
        self.assertEqual(self.faults()["gone"]["cases_on"], {"Mesa 1.0": 3})

    def test_faults_of_other_releases_say_nothing(self):
        self.blessed()
        faults = self.faults()
        for fault in faults.values():
            fault["versions"] = "Mesa <1"
        self.write_faults(*faults.values())
        self.assertIn("unexpected", self.standings(UNEXPECTED).values())
        self.command("bless", "results.json", "--apply")
        self.assertEqual({f["versions"] for f in self.faults().values()}, {"Mesa"})
        self.standings(AS_EXPECTED)

    def test_only_what_the_filter_names(self):
        (self.folder / FILE).unlink()
        self.results("cases", *AGAINST, expect=UNEXPECTED)
        self.command("bless", "results.json", "--apply", "--filter", "points/*")
        names = [name for fault in self.faults().values() for name in fault["cases"]]
        self.assertTrue(names)
        self.assertTrue(all(name.startswith("points/") for name in names))

    def test_known_faults_elsewhere(self):
        self.blessed()
        (self.folder / FILE).rename(self.folder / "mine.json")
        self.standings(UNEXPECTED)
        for known in ("mine.json", self.folder):
            for path in self.folder.glob("results.json"):
                path.unlink()
            self.standings(AS_EXPECTED, "--known", known)
        run = self.command("run", "cases", *AGAINST, "--known", "mine.json", "--known", self.folder,
                           expect=USAGE)
        self.assertIn("stands in another file, too", run.stderr)

    def decide(self, *decisions, expect=AS_EXPECTED):
        self.write("decisions.json", {"edgecase_decisions": 2, "renderer": RENDERER,
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
            if result["verdict"] == "violation"][:3]
        late = {**other, "fingerprint": "0123456789abcdef"}
        elsewhere = {**third, "renderer": "egl:llvmpipe"}
        run = self.decide({**one, "link": "https://example.org/3"}, late,
                          {**third, "decision": "reject"}, elsewhere, expect=UNEXPECTED)
        self.assertIn(f"! {other['case']} {RENDERER}: refused: it was made on", run.stdout)
        self.assertIn(f"! {third['case']} egl:llvmpipe: refused", run.stdout)
        self.assertIn(f"{third['case']} {RENDERER}: rejected, and stays unexpected", run.stdout)
        for fault in self.faults().values():
            self.assertEqual((fault["cases"], fault["reason"], fault["link"]),
                             ([one["case"]], "seen", "https://example.org/3"))
        self.assertIn("refused: it is known by now", self.decide(one, expect=UNEXPECTED).stdout)
        self.assertEqual(self.standings(UNEXPECTED)[one["case"]], "known")

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

    def test_a_crash_can_be_known_and_a_refusal_needs_not_be(self):
        self.write("small/a.json", (self.folder / "cases/points/centres.json").read_text("utf-8"))
        refuser = self.odd_renderer("refuse", "", "small")
        results = self.results("small", "--against", refuser, expect=NOTHING_DRAWN)
        self.assertEqual(only_result(results["cases"][0])["standing"], "tolerated")
        dies = self.odd_renderer("die", "a", "small")
        self.results("small", "--against", dies, expect=None)
        self.command("bless", "results.json", "--folder", "known", "--apply")
        results = self.results("small", "--against", dies, "--known", "known")
        self.assertEqual(only_result(results["cases"][0])["standing"], "known")


if __name__ == "__main__":
    unittest.main()
