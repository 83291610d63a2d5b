# SPDX-License-Identifier: MIT
"""The HTML report in a browser: what it weighs, how much of it the browser holds, that it asks for
nothing, shows every text as text, can be read and worked by everyone, and that what reviewers decide
comes back as known faults. How long it takes is not a matter of these tests: tools/bench."""
import json
import re
import unittest
from urllib.parse import quote

from report_pages import ReportTest
from share import in_full_tier
import results_file
import synthetic_results as synthetic

HOSTILE = ("</script><script>document.title='owned'</script><img src=x onerror=\"document.title="
           "'owned'\"> \"quoted\" 'single' \u202eturned\u202c \u200f<!-- " + "long " * 2000)
ROWS = "document.querySelectorAll('#list *').length"


class Report(ReportTest):
    def test_two_thousand_cases(self):
        results = synthetic.make(2000, 30_000)
        page = self.report(results)
        self.assertLessEqual(page.stat().st_size, 7_000_000)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()),
                         ["report.html", "results.json"])
        self.assert_few_nodes(page)
        self.browser.go("case=" + quote(results["cases"][0]["id"], safe=""),
                        "document.querySelector('.finding .sentence')")
        self.assert_quiet(page)

    def assert_few_nodes(self, page):
        self.browser.open(page, "#view=cases")
        self.browser.ask("document.querySelector('.sweep').click()")
        height = self.browser.ask("document.documentElement.scrollHeight")
        seen = set()
        for tenth in range(11):
            self.browser.ask("scrollTo(0, arguments[0])", height * tenth // 10)
            self.browser.ask("CaseList.paint()")
            self.assertLessEqual(self.browser.ask(ROWS), 300)
            seen.add(self.browser.ask(
                "document.querySelector('#list [data-row]')?.dataset.row ?? ''"))
        self.assertGreater(len(seen), 5, "the list does not move")

    @in_full_tier
    def test_twenty_thousand_cases(self):
        page = self.report(synthetic.make(20_000, 60_000))
        self.assert_few_nodes(page)
        self.assertEqual(self.browser.ask("Cases.length"), 20_000)
        self.assert_quiet(page)

    def test_the_first_cases_are_rehearsed_unseen(self):
        page = self.report(synthetic.make(100, 500))
        self.browser.open(page)
        self.browser.wait("CaseView.rehearsed === 4")
        self.assertEqual(self.browser.ask("document.querySelectorAll('.rehearsal, main.case').length"), 0)
        self.assertTrue(self.browser.ask("CaseView.one === null && Route.read().case === ''"))
        self.assert_quiet(page)

    def test_what_is_beyond_the_budget_comes_from_scripts_beside_the_page(self):
        results = synthetic.make(400, 2000)
        noise = 1
        for case in results["cases"]:  # of the size of a scene, and not to be deflated
            case["width"] = case["height"] = 90
            words = []
            for _ in range(90 * 90):
                noise = (noise * 1103515245 + 12345) % 2**31
                words.append(f"{noise >> 7:x}00")
            case["pixels"] = " ".join(words)
            for result in case["results"].values():
                result.pop("pixels", None)
        page = self.report(results)
        self.assertEqual(list(self.folder.glob("report.*.js")), [])
        self.browser.open(page)
        left_out = self.browser.ask("Cases.find((one) => one.line && !Blocks.isHere(one.line)).id")
        self.open_case(page, {"id": left_out})
        self.browser.wait("document.querySelector('main.case .result-line')")
        told = self.browser.ask("document.getElementById('app').innerText")
        for words in ("write it with --all-details", left_out, "edgecase run "):
            self.assertIn(words, told)
        self.browser.press("a")  # nothing to decide on
        self.browser.press("j")
        self.browser.wait(f"CaseView.one.id !== {json.dumps(left_out)}")
        page = self.report(results, "--all-details")
        scripts = sorted(p.name for p in self.folder.glob("report.*.js"))
        self.assertTrue(scripts)
        self.assertLessEqual(page.stat().st_size, 7_000_000)
        self.browser.open(page)
        line = self.browser.ask("Math.max(...Cases.map((one) => one.line ?? -1))")
        far = self.browser.ask("Cases.find((one) => one.line === arguments[0]).id", line)
        self.browser.go("case=" + quote(far, safe=""), "document.querySelector('.finding .sentence')")
        self.assertTrue(self.browser.ask("CaseView.one.pixels.length > 1000"))
        self.assert_quiet(page)
        for script in scripts:
            (self.folder / script).unlink()
        self.open_case(page, {"id": far})
        self.browser.wait("document.querySelector('main.case .result-line')")
        self.assertIn("not beside this page", self.browser.ask("document.getElementById('app').textContent"))
        self.browser.complaints()
        self.report(synthetic.make(10, 10))
        self.assertEqual(list(self.folder.glob("report.*.js")), [])

    def test_hostile_texts_are_text(self):
        one = synthetic.case_of(0, [3, 0, 0], 0, title=HOSTILE, why=HOSTILE, spec=HOSTILE,
                                tags=[HOSTILE], id="lines/" + HOSTILE)
        for found in one["results"][synthetic.RENDERERS[0]]["disagreements"]:
            found["explanation"] = found["situation"] = HOSTILE
        one["results"][synthetic.RENDERERS[0]].update(standing_reason=HOSTILE, standing="unexpected")
        page = self.report(synthetic.results_with([one]))
        self.browser.open(page)
        self.assertEqual(self.browser.ask("document.title"), "Edgecase report")
        self.browser.wait("document.querySelector('.cause .sentence')")
        self.browser.press("j", "ENTER")
        self.browser.wait("document.querySelector('.finding .sentence')")
        shown = self.browser.ask("document.querySelector('.finding .sentence').textContent")
        self.assertTrue(shown.startswith("</script><script>"))
        self.assertGreater(len(shown), 10_000)
        self.assertFalse(self.browser.ask("document.getElementById('app').textContent.includes('\\u202e')"))
        self.assertIn("U+202E", shown)
        self.assertEqual(self.browser.ask("document.querySelectorAll('img').length"), 0)
        self.assertFalse(self.browser.ask("document.title.startsWith('owned')"))
        self.assertLessEqual(self.browser.ask("document.documentElement.scrollWidth"), 1280)
        self.assert_quiet(page)

    @in_full_tier
    def test_axe_finds_nothing(self):
        page = self.report(synthetic.make(60, 300))
        case = next(c for c in synthetic.make(60, 300)["cases"] if c["id"].startswith("lines"))
        for scheme in ("light", "dark"):
            self.browser.scheme(scheme)
            for place in "", "#view=cases", "#view=statistics", "#cause=1":
                self.browser.open(page, place)
                self.browser.ask(
                    "document.querySelectorAll('details').forEach((d) => { d.open = true; })")
                self.browser.wait("!location.hash.includes('statistics') || "
                                  "document.querySelectorAll('.matrix').length >= 2")
                self.assertEqual(self.browser.violations(), [], (scheme, place))
            for at in (1, 2, 3, 4):
                self.open_case(page, case, at=at)
                self.browser.wait("document.querySelector('.finding .sentence')")
                self.assertEqual(self.browser.violations(), [], f"{scheme}, case, at {at}")
        self.browser.press("?")
        self.assertEqual(self.browser.violations(), [], "keys")
        self.browser.scheme("light")

    def test_first_screen_of_a_case(self):
        results = synthetic.make(60, 300)
        page = self.report(results)
        for at in range(1, 5):  # each kind of disagreement
            self.assert_first_screen(page, results["cases"][0], at)

    def assert_first_screen(self, page, one, at):
        self.open_case(page, one, at=at)
        self.browser.wait("document.querySelector('.finding .sentence')")
        for part in (".answer .badge", ".finding .chip", ".finding .number-line, .finding .sentence",
                     ".finding b.mono", "form.review", ".beside canvas"):
            self.assert_on_screen(part, part)
        for number in range(1, 4):
            top, _, height = self.assert_on_screen(
                f".panes figure:nth-of-type({number}) canvas", "a picture")
            self.assertLess(top, 200)
            self.assertGreaterEqual(height, 400)
        drawn = self.browser.ask("""(() => {
            const {pictures: {panes, pixel}} = CaseView;
            const plot = CaseView.pictures.plot(panes[1]);
            return [plot.x(pixel.x), plot.y(pixel.y + 1), panes[1].canvas.width,
                    panes[1].canvas.height];
        })()""")
        self.assertTrue(0 <= drawn[0] < drawn[2] and 0 <= drawn[1] < drawn[3], drawn)

    def assert_on_screen(self, selector, what):
        box = self.browser.ask(
            "(({top, bottom, height}) => [top, bottom, height])"
            "(document.querySelector(arguments[0]).getBoundingClientRect())", selector)
        self.assertTrue(box[0] >= 0 and box[1] <= 800 and box[2] > 0, f"{what}: {box}")
        return box

    def test_links_lead_to_case_renderer_pixel_and_zoom(self):
        results = synthetic.make(60, 600)
        page = self.report(results)
        both = next(case for case in results["cases"] if all(
            case["results"][name]["disagreements"] for name in synthetic.RENDERERS[1:]))
        self.open_case(page, both, on=synthetic.RENDERERS[2], px="3,5", zoom=17)
        self.browser.wait("CaseView.pictures")
        self.assertEqual(self.browser.ask("CaseView.result.renderer"), synthetic.RENDERERS[2])
        self.assertEqual(self.browser.ask("[CaseView.pixel.x, CaseView.pixel.y]"), [3, 5])
        self.assertEqual(self.browser.ask("CaseView.pictures.view.scale"), 17)
        self.browser.press("+")
        self.assertIn("zoom=22", self.browser.ask("location.hash"))
        self.browser.open(page, "#verdict=violation&q=lines")
        shown = self.browser.ask("CaseList.cases.map((one) => one.id)")
        expected = [case["id"] for case in results["cases"] if "lines" in case["id"] and any(
            r["verdict"] == "violation" for r in case["results"].values())]
        self.assertEqual(sorted(shown), sorted(expected))
        self.assertTrue(expected)

    def test_what_is_contested_is_filtered_named_and_not_red(self):
        results = synthetic.make(60, 60)
        page = self.report(results)
        answers = [r for case in results["cases"] for r in case["results"].values()]
        self.browser.open(page, "#verdict=contested")
        shown = self.browser.ask("CaseList.cases.map((one) => one.id)")
        expected = [case["id"] for case in results["cases"] if any(
            r["verdict"] == "contested" for r in case["results"].values())]
        self.assertEqual(sorted(shown), sorted(expected))
        self.assertTrue(expected)
        self.assertEqual(
            self.browser.ask("Cases.flatMap((one) => one.results).filter(isSurprise).length"),
            sum(r["standing"] == "unexpected" for r in answers))
        self.browser.open(page, "#standing=tolerated")
        tolerated = self.browser.ask("CaseList.cases.map((one) => one.id)")
        self.assertEqual(sorted(tolerated), sorted(case["id"] for case in results["cases"] if any(
            r["standing"] == "tolerated" for r in case["results"].values())))
        one = next(case for case in results["cases"] if case["id"] == tolerated[0])
        self.open_case(page, one)
        self.assertEqual(self.browser.ask("document.querySelector('.finding .legal').textContent"),
                         "contested")

    @in_full_tier
    def test_everyone_can_read_what_is_contested(self):
        page = self.report(synthetic.make(60, 60))
        for scheme in "light", "dark":
            for place in "#verdict=contested", "#standing=tolerated":
                self.browser.open(page, place)
                self.browser.scheme(scheme)
                self.assertEqual(self.browser.violations(), [], (scheme, place))

    def test_the_list_and_each_case_begin_with_the_violations(self):
        results = synthetic.make(200, 2000)
        page = self.report(results)
        self.browser.open(page, "#view=cases")
        ranks = self.browser.ask("CaseList.rows.map((row) => row.worst)"
                                 ".filter((one) => one.surprises).map((one) => one.worst)")
        self.assertEqual(ranks, sorted(ranks, reverse=True))
        self.browser.open(page)
        words = ["not allowed", "contested", "allowed"]
        orders = self.browser.ask("[...document.querySelectorAll('.cause')].map((card) => "
                                  "[...card.querySelectorAll('.counts .legal')].map((e) => e.textContent))")
        self.assertTrue(orders)
        for order in [*orders, [order[0] for order in orders]]:
            self.assertEqual(order, sorted(order, key=words.index))

    def test_every_count_of_the_matrix_is_the_length_of_its_list(self):
        page = self.report(synthetic.make(200, 2000))
        self.browser.open(page, "#view=statistics")
        links = self.browser.ask(
            "[...document.querySelectorAll('.matrix .count-of')].map((a) => "
            "[a.getAttribute('href'), a.lastChild.textContent])")
        self.assertGreater(len(links), 10)
        for href, count in links[:12]:
            self.browser.go(href[1:], "location.hash.length > 1")
            self.browser.wait(f"CaseList.cases.length === {count.replace(',', '')}")

    def test_the_keyboard_does_it_all(self):
        page = self.report(synthetic.make(60, 600))
        self.browser.open(page)
        self.browser.press("l")
        self.browser.wait("document.querySelector('.sweep')")
        self.browser.press("j", "ENTER")
        self.assertEqual(self.browser.ask("document.activeElement.getAttribute('aria-expanded')"), "true")
        self.browser.press("j", "j", "j", "ENTER")
        self.browser.wait("CaseView.result")
        self.assertEqual(self.browser.ask("CaseList.cases.indexOf(CaseView.one)"), 2)
        self.assertEqual(self.browser.ask("CaseView.index"), 0)
        self.browser.press("n")
        self.assertEqual(self.browser.ask("CaseView.index"), 1)
        self.browser.press("p", "p")
        last = self.browser.ask("CaseView.result.answer.disagreements.length") - 1
        self.assertEqual(self.browser.ask("CaseView.index"), last)
        before = self.browser.ask("CaseView.result.renderer")
        self.browser.press("]")
        self.assertNotEqual(self.browser.ask("CaseView.result.renderer"), before)
        self.browser.press("[")
        for key, mode in (("w", "slider"), ("w", ""), ("b", "blink"), ("b", "")):
            self.browser.press(key)
            self.assertEqual(self.browser.ask("CaseView.pictures.overlay.mode"), mode)
        self.browser.press("k")
        self.browser.wait("CaseList.cases.indexOf(CaseView.one) === 1")
        self.browser.press("?")
        self.assertTrue(self.browser.ask("document.getElementById('help').open"))
        keys = self.browser.ask("document.getElementById('help').textContent")
        for key in ("next case", "slider", "blink", "accept", "search"):
            self.assertIn(key, keys)
        self.browser.press("ESCAPE")
        self.browser.press("ESCAPE")
        self.browser.wait("document.querySelector('main.cases-view')")
        self.browser.press("ESCAPE")
        self.browser.wait("document.querySelector('.cause')")
        self.browser.press("i")
        self.browser.wait("document.querySelector('.statistics-view')")
        self.browser.press("/")
        self.browser.wait("document.activeElement.id === 'search'")

    def test_what_changed_since_earlier_results(self):
        before, after = synthetic.make(60, 300), synthetic.make(60, 300)
        name = synthetic.RENDERERS[1]
        fixed, broken = before["cases"][0], before["cases"][1]
        after["cases"][0]["results"][name] = synthetic.result_of(1, 0, 0)
        after["cases"][1]["results"][name] = synthetic.result_of(1, 2, 0)
        old = self.write("old.json", results_file.text_of(before))
        page = self.report(after, "--since", old)
        self.browser.open(page)
        shown = self.browser.ask(
            "[...document.querySelectorAll('.changes tbody tr')].map((row) => row.textContent)")
        self.assertEqual(len(shown), 2, shown)
        self.assertRegex(shown[0], "agreed before.*" + re.escape(broken["id"]))
        self.assertRegex(shown[1], "agrees now.*" + re.escape(fixed["id"]))

    def test_without_motion_blinking_takes_a_step_at_a_time(self):
        self.browser.cdp("Emulation.setEmulatedMedia",
                         features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
        results = synthetic.make(60, 600)
        self.open_case(self.report(results), results["cases"][0])
        self.browser.wait("CaseView.pictures")
        self.browser.press("b")
        self.assertTrue(self.browser.ask("CaseView.pictures.overlay.exactNow"))
        self.assertEqual(self.browser.ask("CaseView.pictures.overlay.timer"), 0)
        self.browser.cdp("Emulation.setEmulatedMedia", features=[])


if __name__ == "__main__":
    unittest.main()
