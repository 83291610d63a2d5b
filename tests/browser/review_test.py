# SPDX-License-Identifier: MIT
"""A red run is settled in the HTML report: its causes are the first thing seen, what is decided on a
cause or on one answer comes back as known faults, and no reason sticks to another decision."""
import json
import pathlib
import re
import time
import unittest

from report_pages import ReportTest
import results_file
import synthetic_results as synthetic

CAUSE = "triangle.fill-rule=left-bottom"
SWAPPED = synthetic.RENDERERS[2]


def swapped_ties(cases):
    """What a rasterizer with swapped ties comes to: one cause, in a few cases against the rules."""
    made = []
    for number in range(cases):
        one = synthetic.case_of(number, [0, 0, 1], number, rules=["triangle.fill-rule"],
                                title=f"An edge through centres, {number}")
        result = one["results"][SWAPPED]
        illegal = number % 8 == 0
        result["disagreements"][0].update(
            kind="duplicate" if illegal else "extra", rule="triangle.fill-rule", cause=CAUSE,
            exact=[1], rendered=[2], legality="illegal" if illegal else "legal")
        result.update(verdict="violation" if illegal else "convention", standing_reason="",
                      standing="unexpected" if illegal else "expected")
        made.append(one)
    return synthetic.results_with(made)


class Review(ReportTest):
    def exported(self):
        file = pathlib.Path(self.downloads.name) / "decisions.json"
        until = time.monotonic() + 10
        while not file.exists() and time.monotonic() < until:
            time.sleep(0.05)
        decisions = json.loads(file.read_text(encoding="utf-8"))["decisions"]
        return file, decisions

    def blessed(self, decisions):
        """The faults that `bless --from` writes."""
        run = self.command("bless", self.folder / "results.json", "--from", decisions, "--folder",
                           "known", "--apply")
        decisions.unlink()
        (file,) = (self.folder / "known").glob("*.json")
        return run.stdout, json.loads(file.read_text(encoding="utf-8"))["faults"]

    def test_a_red_run_is_settled_in_six_presses(self):
        results = swapped_ties(80)
        page = self.report(results)
        self.browser.open(page)
        headline = self.browser.ask("document.querySelector('.headline').textContent")
        self.assertIn("10 answers are not as expected: the triangle fill rule is left-bottom, "
                      "not left-top", headline)
        card = self.browser.ask("document.querySelector('.cause').innerText")
        for words in ("not allowed: 10 differences in 10 cases", "allowed: 70 differences in 70 cases",
                      "14.6.1", SWAPPED + ": 10 answers"):
            self.assertIn(words, card)
        self.browser.wait("Glance.shown.length === 1")
        colors = self.browser.ask(
            "[...document.querySelectorAll('.glance canvas')].map((canvas) => new Set(new Uint32Array("
            "canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size)")
        self.assertTrue(len(colors) == 3 and min(colors) > 5, colors)
        bottom = self.browser.ask("document.querySelector('.cause').getBoundingClientRect().bottom")
        self.assertLess(bottom, 800)
        self.browser.press("ENTER")  # one press: its pixel, and no legal one
        self.browser.wait("CaseView.result")
        self.assertEqual(self.browser.ask("CaseView.result.answer.disagreements[CaseView.index].legality"),
                         "illegal")
        self.browser.open(page)
        presses = 0
        for key in ("a", *"Known", "ENTER", "e"):
            self.browser.press(key)
            presses += key not in "Known"  # letters of the reason are no commands
        self.assertLessEqual(presses, 6)
        file, decisions = self.exported()
        self.assertEqual({(d["decision"], d["reason"], d["renderer"]) for d in decisions},
                         {("accept", "Known", SWAPPED)})
        self.assertEqual(len(decisions), 10)
        _, faults = self.blessed(file)
        self.assertEqual([(f["cause"], f["reason"]) for f in faults], [(CAUSE, "Known")])
        self.assertEqual({name.split(":")[0] for name in faults[0]["cases"]},
                         {d["case"].split(":")[0] for d in decisions})

    def test_decisions_on_single_answers_overrule_that_on_their_cause(self):
        page = self.report(swapped_ties(32))
        self.browser.open(page)
        self.browser.press("x", *"All", "ENTER")
        self.browser.open(page)  # they are kept
        self.assertEqual(self.browser.ask("Review.answers().filter((a) => a.decided).length"), 4)
        self.browser.press("ENTER")
        self.browser.wait("CaseView.result")
        one, renderer = self.browser.ask("[CaseView.one.id, CaseView.result.renderer]")
        self.browser.press("a")
        self.assertTrue(self.browser.ask("document.activeElement.matches('input.reason')"))
        self.assertEqual(self.browser.ask("document.activeElement.value"), "")
        self.browser.press(*"One", "ENTER")
        self.assertEqual(self.browser.ask("document.activeElement.tagName"), "H1")
        self.browser.press("j")
        self.browser.wait(f"CaseView.one.id !== {json.dumps(one)}")
        self.browser.press("a")
        self.assertEqual(self.browser.ask("document.activeElement.value"), "")
        self.browser.press("T", "ESCAPE", "x")
        self.assertEqual(self.browser.ask("document.activeElement.value"), "All")
        self.browser.press("ESCAPE", "e")
        file, decisions = self.exported()
        self.assertEqual(sorted((d["decision"], d["reason"]) for d in decisions),
                         [("accept", "One")] + 3 * [("reject", "All")])
        text, faults = self.blessed(file)
        self.assertEqual(text.count("rejected, and stays unexpected: All"), 3)
        self.assertEqual([(f["cases"], f["reason"]) for f in faults], [([one], "One")])
        self.assertEqual(renderer, SWAPPED)

    def test_enter_confirms_the_decision_that_was_begun(self):
        page = self.report(swapped_ties(8))
        self.browser.open(page)
        self.browser.press("x", "ENTER")  # without a reason nothing is decided
        self.assertEqual(self.browser.ask("Review.causes.size"), 0)
        self.assertTrue(self.browser.ask("document.activeElement.matches('input.reason')"))
        self.browser.press(*"No", "ENTER")
        self.assertEqual(self.browser.ask("[...Review.causes.values()]"),
                         [{"decision": "reject", "reason": "No"}])

    def test_a_green_run_shows_what_is_known_by_fault(self):
        one = synthetic.case_of(1, [0, 0, 1], 3)
        one["results"][SWAPPED].update(standing="known", faults=["ties"])
        results = synthetic.results_with([one])
        results["faults"] = [{"renderer": SWAPPED, "id": "ties", "reason": "Ties go left-bottom.",
                              "link": "", "cases": 1, "state": "known"}]
        page = self.report(results)
        self.browser.open(page)
        self.assertIn("Every answer is as expected, or a known fault: 1",
                      self.browser.ask("document.querySelector('.headline').textContent"))
        (row,) = self.browser.ask("[...document.querySelectorAll('.known tbody tr')]"
                                  ".map((row) => row.innerText)")
        lines = self.browser.ask("[...document.querySelectorAll('.of-renderer')].map((e) => e.clientHeight)")
        self.assertEqual(len(lines), 3)
        self.assertLess(max(lines), 32)  # one line of text
        self.assertEqual(re.split(r"\s*\t\s*", row.strip()), ["ties", "Ties go left-bottom.", "1"])
        self.browser.driver.find_element("css selector", ".known td a").click()
        self.browser.wait(f"CaseView.one?.id === {json.dumps(one['id'])}")
        self.assert_quiet(page)

    def test_generations_lead_from_each_fault_to_a_case(self):
        driver, pages = synthetic.RENDERERS[0], []
        for release, begun in (("22.3.6", 0), ("25.0.7", 1)):
            one = synthetic.case_of(1, [1, 0, 0], 3)
            if begun:
                one["results"][driver].update(standing="known", faults=["ties"])
            results = synthetic.results_with([one])
            results["whole_suite"] = True
            for info in results["renderers"]:
                info.update(version=f"4.5 (Core Profile) Mesa {release}", device="llvmpipe (LLVM 15)")
            results["faults"] = begun * [{
                "renderer": driver, "id": "ties", "reason": "Ties go left-bottom.", "link": "",
                "cases": 1, "state": "known"}]
            pages.append(self.write(f"{release}.json", results_file.text_of(results)))
        page = self.folder / "report.html"
        self.command("report", *pages, "--html", page)
        self.browser.open(page)
        self.browser.press("m")
        self.browser.wait("document.querySelector('.generations')")
        rows = self.browser.ask("[...document.querySelector('[aria-label*=llvmpipe] table').rows]"
                                ".map((row) => [...row.cells].map((cell) => cell.innerText.trim()))")
        self.assertEqual(rows[0][1:3], ["Mesa 22.3.6", "Mesa 25.0.7"])
        self.assertEqual(rows[1], ["ties", "0", "1", "since Mesa 25.0.7", "Ties go left-bottom."])
        self.assertEqual(rows[2][0], "not known")
        self.browser.cdp("Emulation.setDeviceMetricsOverride", width=390, height=844,
                         deviceScaleFactor=1, mobile=False)
        boxes = "[...document.querySelectorAll('.generations')].map((table) => table.parentElement)"
        self.assertTrue(self.browser.ask(f"{boxes}.every((box) => box.scrollWidth <= box.clientWidth)"))
        self.browser.cdp("Emulation.setDeviceMetricsOverride", width=1280, height=800,
                         deviceScaleFactor=1, mobile=False)
        self.browser.driver.find_element("css selector", ".generations td a").click()
        self.browser.wait("CaseView.one")
        self.browser.press("ESCAPE")
        self.browser.wait("document.querySelector('h1')")
        part = synthetic.results_with([synthetic.case_of(1, [1, 0, 0], 3)])
        refused = self.command("report", pages[0], self.write("part.json", results_file.text_of(part)),
                               "--html", page, expect=2)
        self.assertIn("they are not of the whole suite", refused.stderr)


if __name__ == "__main__":
    unittest.main()
