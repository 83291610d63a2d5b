# SPDX-License-Identifier: MIT
"""Parts of the HTML report in a browser: fragments in numbers, the clip volume, cards of levels, and
what paper shows."""
import struct
import unittest

from report_pages import ReportTest
from share import IS_QUICK
import synthetic_results as synthetic


class Parts(ReportTest):
    def test_fragments_of_both_sides_in_numbers(self):
        one = synthetic.case_of(0, [4, 0, 0], 0)
        found = one["results"][synthetic.RENDERERS[0]]["disagreements"]
        page = self.report(synthetic.results_with([one]))
        order = ["illegal", "contested", "legal"]
        for at, d in enumerate(sorted(found, key=lambda d: order.index(d["legality"])), 1):
            self.open_case(page, one, at=at)
            self.browser.wait("document.querySelector('.of-pair')")
            self.assertIn(f"({d['pixel'][0]}, {d['pixel'][1]})", self.browser.ask(
                "document.querySelector('.of-pair').closest('section').textContent"))
            pairs = self.browser.ask(
                "[...document.querySelectorAll('.of-pair')].map((cell) => cell.textContent.trim())")
            kind = "" if d["kind"] == "value" else d["kind"]
            self.assertEqual(pairs[-1], f"primitive {d['primitive']} {kind}".strip())
            self.assertEqual(len(pairs), 2 if kind == "duplicate" else 1)
            if not kind:
                self.assert_steps(d)
        free = next([x, y] for y in range(16) for x in range(16)
                    if [x, y] not in [d["pixel"] for d in found])
        self.browser.ask("CaseView.pick(...arguments)", *free)
        self.browser.wait("!document.querySelector('.of-pair')")
        self.assertIn("nothing is disputed here", self.browser.ask(
            "CaseView.parts.fragments.textContent"))

    def assert_steps(self, d):
        """Both depths, with their bits, and how far apart they are."""
        rows = self.browser.ask(
            "[...document.querySelectorAll('.of-pair')].at(-1).closest('tbody').innerText")
        depth = next(row for row in rows.splitlines() if row.startswith("depth")).split("\t")
        bits = struct.unpack(">I", struct.pack(">f", 0.5 + d["pixel"][0] / 4096))[0]
        self.assertEqual([depth[2], depth[5], depth[-1]],
                         [f"0x{bits:08X}", f"0x{bits + 1:08X}", "+1 ULP"])
        self.assertEqual(depth[3].replace(" ", ""), f"{bits:032b}")

    def test_the_clip_volume_is_drawn_over_cases_about_it(self):
        cases = [synthetic.case_of(number, [1, 0, 0], 0, rules=[rule], viewport=[-2, 0, 20, 16])
                 for number, rule in ((0, "line.diamond-exit"), (1, "clip.volume"))]
        page = self.report(synthetic.results_with(cases))
        drawn = "CaseView.pictures.boxes.clip.checked"
        seen = "CaseView.pictures.panes[0].canvas.toDataURL()"
        self.open_case(page, cases[0])
        self.assertFalse(self.browser.ask(drawn))
        self.assertEqual(self.browser.ask("CaseView.one.viewport"), [-2, 0, 20, 16])
        without = self.browser.ask(seen)
        self.browser.press("v")
        self.assertTrue(self.browser.ask(drawn))
        self.assertNotEqual(self.browser.ask(seen), without)
        self.open_case(page, cases[1])
        self.assertTrue(self.browser.ask(drawn))

    def test_cards_of_levels_lead_to_their_case(self):
        cases = [synthetic.case_of(number, [0, 1, 0], 0) for number in range(3)]
        for case in cases[:2]:
            for step, name in enumerate(synthetic.RENDERERS[:2], 1):
                ramp = [[x, 0, x / 8, x / 8 - 0.1, x / 8 + 0.1, x / 8 + step * x / 100]
                        for x in range(synthetic.SIZE)]
                case["results"][name] = {**case["results"][name], "ramp": ramp}
        page = self.report(synthetic.results_with(cases))
        self.browser.open(page, "#view=statistics")
        self.browser.ask("document.querySelectorAll('details').forEach((d) => { d.open = true; })")
        self.browser.wait("document.querySelectorAll('.ramp-card svg').length === 4")
        words = self.browser.ask("document.querySelector('.ramp-card').innerText")
        for name in synthetic.RENDERERS[:2]:
            self.assertIn(name + ": ", words)
        self.assertNotIn(synthetic.RENDERERS[2], words)
        self.assertIn("outside the permitted band", words)
        if not IS_QUICK:
            # axe comes by npm, which the quick tier does without.
            self.assertEqual(self.browser.violations(), [])
        self.browser.driver.find_element("css selector", ".ramp-card").click()
        self.browser.wait("document.querySelector('main.case .ramps svg[role=slider]')")
        self.assertIn(self.browser.ask("CaseView.one.id"), [case["id"] for case in cases[:2]])
        self.assert_quiet(page)

    def test_paper_holds_the_list_and_not_its_empty_room(self):
        page = self.report(synthetic.make(400, 800))
        self.browser.open(page, "#view=cases")
        self.browser.ask("Cases.forEach((one) => CaseList.open.add(one.head))")
        self.browser.ask("CaseList.show(Route.read())")
        self.browser.cdp("Emulation.setEmulatedMedia", media="print")
        self.browser.ask("dispatchEvent(new Event('beforeprint'))")
        self.assertEqual(self.browser.ask("document.querySelectorAll('#list .row').length"), 200)
        self.assertIn("The first 200 of 408 rows", self.browser.ask(
            "document.querySelector('#list .rows').textContent"))
        last, foot = self.browser.ask(
            "[...document.querySelectorAll('#list .rows > :nth-last-child(2), #list .empty')]"
            ".map((part) => part.getBoundingClientRect().bottom)")
        end = self.browser.ask("document.querySelector('#list .rows').getBoundingClientRect().bottom")
        self.assertTrue(last < foot <= end < foot + 10, (last, foot, end))
        self.browser.cdp("Emulation.setEmulatedMedia", media="")
        self.browser.ask("dispatchEvent(new Event('afterprint'))")
        self.browser.ask("scrollTo(0, document.documentElement.scrollHeight)")
        self.browser.ask("CaseList.paint()")
        self.assertTrue(self.browser.ask("CaseList.last === 408 && CaseList.first > 300"))


if __name__ == "__main__":
    unittest.main()
