# SPDX-License-Identifier: MIT
"""Where things stand in the HTML report: pictures first and large, the list within the first screen
and its verdicts always on it, sweeps as one row, and nothing off a phone's screen."""
from urllib.parse import quote
import unittest

from report_pages import ReportTest
from share import in_full_tier
import synthetic_results as synthetic

WIDE = 128  # pixels of a whole scene
VIEWS = ["", "#view=cases", "#view=statistics", "#cause=1"]
FITTING = ".known, .generations, .summary"  # tables that fit a phone; others scroll in a box of their own
BEYOND = ("[...document.querySelectorAll('main *, nav.bar *')].filter((e) => "
          f"!e.closest('.scroll:not(:has({FITTING})), .panes') "
          "&& !e.matches('.unseen') && e.getBoundingClientRect().right > innerWidth + 1)"
          ".map((e) => e.tagName + '.' + e.className)")


def scene():
    """A case of a whole scene with a violation, a contested and an allowed pixel."""
    one = synthetic.case_of(0, [3, 0, 0], 0, width=WIDE, height=WIDE, id="scenes/one", file="scenes/one.json",
                            pixels=synthetic.packed_picture(b"\x40\x60\x80\xff" * WIDE * WIDE, WIDE))
    result = one["results"][synthetic.RENDERERS[0]]
    legalities = [("illegal", [100, 90]), ("contested", [20, 100]), ("legal", [64, 10])]
    for d, (legality, pixel) in zip(result["disagreements"], legalities):
        d.update(legality=legality, pixel=pixel, cause="line.snap=8-half-even" if legality == "legal" else "")
    at = {x + WIDE * y for _, (x, y) in legalities}
    result.update(verdict="violation", standing="unexpected", pixels=synthetic.packed(
        bytes([255 if i in at else 0, 0, 0, 0]) for i in range(WIDE * WIDE)))
    result.pop("exact_fragments", None)
    result.pop("rendered_fragments", None)
    return one


class Layout(ReportTest):
    def size(self, width, height):
        self.browser.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height,
                         deviceScaleFactor=1, mobile=False)

    def tearDown(self):
        self.size(1280, 800)
        super().tearDown()

    def box(self, selector):
        return self.browser.ask("(({top, bottom, left, right}) => [top, bottom, left, right])"
                                "(document.querySelector(arguments[0]).getBoundingClientRect())", selector)

    def test_the_list_is_within_the_first_screen_and_keeps_its_heads_and_verdicts(self):
        page = self.report(synthetic.make(500, 800))
        self.browser.open(page, "#view=cases")
        self.assertLess(self.box("#list .row")[0], 400)
        self.browser.ask("document.querySelectorAll('.sweep')[0].click()")
        self.browser.wait("document.querySelectorAll('.row.part').length > 5")
        self.browser.ask("scrollTo(0, 700)")
        self.browser.ask("CaseList.paint()")
        top, bottom, *_ = self.box(".list-head")
        self.assertTrue(0 <= top < bottom < 120, (top, bottom))
        for selector in ".list-head > :last-child", ".row .cell:last-child":
            self.assertLessEqual(self.box(selector)[3], 1280)

    def test_a_sweep_is_one_row_with_counts_and_a_chart(self):
        page = self.report(synthetic.make(100, 300))
        self.browser.open(page, "#view=cases")
        self.assertEqual(self.browser.ask("CaseList.rows.length"), 2)
        title = self.browser.ask("document.querySelector('.sweep .cell:nth-last-child(2)').title")
        counts = [int(part.split()[0]) for part in title.split(", ")]
        self.assertEqual(sum(counts), synthetic.PER_FILE, title)
        colors = self.browser.ask(
            "(() => { const chart = document.querySelectorAll('.sweep .chart')[1]; return new Set(new "
            "Uint32Array(chart.getContext('2d').getImageData(0, chart.height - 1, chart.width, 1)"
            ".data.buffer)).size; })()")
        self.assertGreaterEqual(colors, len(counts))
        self.browser.wait("[...Thumbnails.values()].some((picture) => picture?.width > 0)")

    def test_pictures_are_first_and_large(self):
        one = synthetic.case_of(0, [4, 0, 0], 0)
        page = self.report(synthetic.results_with([one, scene()]))
        for width, height in (1280, 800), (1920, 1080):
            self.size(width, height)
            self.open_case(page, one)
            for which in "exact", "difference", "rendered":
                top, bottom, _, right = self.box(f".of-{which} canvas")
                self.assertTrue(top < 200 and bottom - top >= 400 and bottom <= height, (top, bottom))
                self.assertLess(right, self.box("#answer")[2])
            self.assertLess(self.box("#answer form.review")[1], height)

    def test_a_scene_is_large_with_the_verdict_of_each_pixel(self):
        page = self.report(synthetic.results_with([scene()]))
        self.open_case(page, {"id": "scenes/one"})
        self.browser.wait("CaseView.pictures?.width")
        top, bottom, left, right = self.box(".of-verdicts canvas")
        self.assertTrue(bottom - top >= 512 and right - left >= 512 and bottom <= 800)
        self.assertEqual(self.browser.ask("CaseView.pictures.view.scale") * WIDE, 512)
        told = self.browser.ask("Object.fromEntries(verdictsByPixel(CaseView.result.answer, 128, "
                                "CaseView.pictures.painter.exact, CaseView.pictures.painter.rendered))")
        self.assertEqual(told, {str(100 + WIDE * 90): "violation", str(20 + WIDE * 100): "contested",
                                str(64 + WIDE * 10): "convention"})
        self.assertEqual(self.browser.ask("[CaseView.pixel.x, CaseView.pixel.y]"), [100, 90])

    def test_numbers_stand_on_a_line(self):
        one = synthetic.case_of(0, [4, 0, 0], 0)
        page = self.report(synthetic.results_with([one]))
        self.browser.open(page)
        at = self.browser.ask("loadDetails(Cases[0]).then((one) => one.results[0].answer.disagreements"
                              ".findIndex((d) => d.kind === 'value') + 1)")
        self.open_case(page, one, at=at)
        label = self.browser.ask("document.querySelector('.number-line svg').getAttribute('aria-label')")
        self.assertRegex(label, r"^blue: exact 0\.0000\d+, rendered 0\.0000\d+, \+[\d,]+ ULP$")
        places = self.browser.ask("['.exact', '.rendered'].map((part) => "
                                  "document.querySelector('.number-line ' + part).getBoundingClientRect().left)")
        self.assertLess(places[0] + 100, places[1])

    def test_nothing_is_off_a_phones_screen(self):
        results = synthetic.make(60, 300)
        page = self.report(results)
        self.size(390, 844)
        for place in [*VIEWS, "#case=" + quote(results["cases"][0]["id"], safe="")]:
            self.browser.open(page, place)
            self.browser.wait("document.querySelector('main.overview, .finding .sentence')")
            self.assertEqual(self.browser.ask("document.documentElement.scrollWidth"), 390, place)
            self.assertEqual(self.browser.ask(BEYOND), [], place)
        self.assertGreater(self.browser.ask("document.querySelector('.panes').scrollWidth"), 900)
        self.assertLess(self.box(".answer .badge")[1], 844)
        self.browser.open(page, "#view=cases")
        self.assertLessEqual(self.box(".row .cell:last-child")[3], 390)

    @in_full_tier
    def test_axe_finds_nothing_on_a_phone(self):
        results = synthetic.make(60, 300)
        page = self.report(results)
        self.size(390, 844)
        for scheme in "light", "dark":
            self.browser.scheme(scheme)
            for place in [*VIEWS, "#case=" + quote(results["cases"][0]["id"], safe="")]:
                self.browser.open(page, place)
                self.browser.wait("document.querySelector('main.overview, .finding .sentence')")
                self.assertEqual(self.browser.violations(), [], (scheme, place))
        self.browser.scheme("light")


if __name__ == "__main__":
    unittest.main()
