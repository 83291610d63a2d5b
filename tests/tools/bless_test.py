# SPDX-License-Identifier: MIT
"""Expectations: known faults are green, new, changed and vanished ones are red; `bless` shows what
it would change and writes only when asked."""
import json
import unittest

from support import AS_EXPECTED, UNEXPECTED, CommandTest, only_result

RENDERER = "osmesa:softpipe"
AGAINST = ["--against", RENDERER]
FILE = "cases/expectations/osmesa-softpipe.json"


class Bless(CommandTest):
    def setUp(self):
        super().setUp()
        self.copy_suite("points", "surfaces")

    def expectations(self):
        return json.loads((self.folder / FILE).read_text(encoding="utf-8"))

    def standings(self, expect):
        results = self.results("cases", *AGAINST, expect=expect)
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
