# SPDX-License-Identifier: MIT
"""Two results files, case by case: what is new, what is fixed, what differs beside them."""
import json
import unittest

import results_file
from support import (AS_EXPECTED, INTERNAL, UNEXPECTED, USAGE, CommandTest)

NAMES = ["a", "b", "c"]


class Compare(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)
        self.run_to("good.json", "exact")
        self.run_to("bad.json", self.odd_renderer("mirror-of", "b", "cases"))

    def run_to(self, name, renderer, *options):
        self.command("run", "cases", "--against", renderer, "--json", name, *options, expect=None)

    def compared(self, old, new, expect):
        run = self.command("compare", old, new, "--json", "-", expect=expect)
        return json.loads(run.stdout)

    def test_nothing_differs(self):
        self.assertEqual(self.compared("good.json", "good.json", AS_EXPECTED)["renderers"][0]["same"], 3)
        out = self.command("compare", "good.json", "good.json").stdout
        self.assertIn("3 of 3 cases are as they were", out)

    def test_two_renderers_of_other_names(self):
        comparison = self.compared("good.json", "bad.json", UNEXPECTED)
        (renderer,) = comparison["renderers"]
        self.assertEqual(renderer["counts"], {"new-disagreement": 1})
        (case,) = renderer["cases"]
        self.assertEqual((case["id"], case["before"]["verdict"], case["after"]["verdict"]),
                         ("b", "agree", "violation"))
        self.assertEqual(renderer["clusters"][0]["first_case"], "b")
        self.assertIn("name", [fact["what"] for fact in renderer["facts"]])
        back = self.compared("bad.json", "good.json", UNEXPECTED)["renderers"][0]
        self.assertEqual(back["counts"], {"fixed": 1})

    def test_markdown(self):
        out = self.command("compare", "good.json", "bad.json", expect=UNEXPECTED).stdout
        for words in ("### 1: new disagreements", "- `b`: agree -> violation `", "| rule | cause |"):
            self.assertIn(words, out)
        run = self.command("compare", "good.json", "bad.json", "--markdown", "a/b.md", "--json",
                           "a/b.json", expect=UNEXPECTED)
        self.assertEqual((self.folder / "a/b.md").read_text("utf-8"), out)
        self.assertEqual(run.stdout, "")
        json.loads((self.folder / "a/b.json").read_text("utf-8"))

    def test_policies_and_cases_that_differ(self):
        (self.folder / "cases/a.json").unlink()
        self.write_cases("d")
        self.run_to("strict.json", "exact", "--no-latitude")
        comparison = self.compared("good.json", "strict.json", UNEXPECTED)
        self.assertEqual({fact["what"]: fact["after"] for fact in comparison["facts"]}["latitude"],
                         "none")
        self.assertEqual([(case["id"], case["change"]) for case in
                          comparison["renderers"][0]["cases"]],
                         [("a", "disappeared"), ("d", "appeared")])

    def test_a_run_tells_what_changed_since(self):
        bad = self.odd_renderer("mirror-of", "b", "cases")
        worse = self.odd_renderer("mirror", "", "cases")
        def since(renderer, *options, expect):
            return self.command("run", "cases", "--against", renderer, "--since", "bad.json",
                                "--json", "new.json", "--html", "new.html", *options,
                                expect=expect).stdout
        out = since(bad, expect=UNEXPECTED)
        self.assertIn(f"Changed since, {bad}: 0 of 3 cases", out)
        since(bad, "--fail-on", "changes", expect=AS_EXPECTED)
        since(bad, "--fail-on", "nothing", expect=AS_EXPECTED)
        out = since(worse, "--fail-on", "changes", expect=UNEXPECTED)
        self.assertIn("2 of 3 cases\n  new disagreements: ", out)
        self.assertIn('"since":{', (self.folder / "new.html").read_text("utf-8"))
        since(worse, "--fail-on", "nothing", expect=AS_EXPECTED)
        # Of a part of the suite, cases that were not asked have not disappeared.
        out = since(bad, "--filter", "a", "--fail-on", "changes", expect=AS_EXPECTED)
        self.assertIn("0 of 1 case\n", out)
        run = self.command("run", "cases", "--fail-on", "changes", expect=USAGE)
        self.assertIn("name them with --since", run.stderr)
        self.command("run", "cases", "--against", bad, "--since", "gone.json", expect=INTERNAL)

    def test_markdown_fits_a_comment(self):
        """However much changed and however long the words are."""
        for name in ("good.json", "bad.json"):
            results = results_file.read(self.folder / name)
            (case,) = [case for case in results["cases"] if case["id"] == "b"]
            (renderer,) = results["renderers"]
            results["cases"] = [{**case, "id": f"{i:03}" + "\u00e4" * 900} for i in range(300)]
            renderers = [{**renderer, "name": f"renderer {i}"} for i in range(9)]
            for one in results["cases"]:
                (answer,) = one["results"].values()
                one["results"] = {r["name"]: answer for r in renderers}
            self.write_results(name, {**results, "renderers": renderers})
        out = self.command("compare", "good.json", "bad.json", expect=UNEXPECTED).stdout
        self.assertLess(len(out.encode()), 64001)
        self.assertIn("The rest does not fit here", out)
        self.assertEqual(out.count("<details>"), out.count("</details>"))

    def test_bad_input(self):
        for files in (("good.json", "gone.json"), ("gone.json", "good.json")):
            told = self.command("compare", *files, expect=INTERNAL).stderr
            self.assertEqual(told, "edgecase: cannot read gone.json: No such file or directory\n")
        self.assertIn("no results file", self.command("compare", "cases/a.json", "good.json",
                                                      expect=USAGE).stderr)
        self.command("compare", "good.json", expect=USAGE)
        self.command("compare", "good.json", "bad.json", "--json", "/proc/none/x", expect=INTERNAL)
        self.command("run", "cases", "--against", "egl:llvmpipe", "--against", "exact",
                     "--json", "two.json", expect=None)
        self.run_to("other.json", self.odd_renderer("refuse", "", "cases"))
        self.assertIn("no renderer is in both", self.command("compare", "two.json", "other.json",
                                                             expect=USAGE).stderr)


if __name__ == "__main__":
    unittest.main()
