# SPDX-License-Identifier: MIT
"""edgecase gallery: pages of policies in pictures, and what is told where one cannot be drawn."""
import json
import re
import unittest

from support import NOTHING_SELECTED, RENDERER, ROOT, SUITE, USAGE, CommandTest, triangle_case

NAMES = sorted(path.stem for path in (ROOT / "cases/galleries").glob("*.json"))
NEVER = ("--progress", "never")
MINE = {"title": "Mine", "policy": "mine", "pictures": [{"case": "one", "heading": "First"}]}
CLOSED = {"name": "mine", "latitude": "none", "rules": {"triangle.fill-rule": "closed"}}
# Six centres of its lowest row lie on an edge that OpenGL does not draw.
EDGE = triangle_case(draws=[
    {"primitive": "triangles", "vertices": [[1, 2.5], [7, 2.5], [1, 7]]}])


class Pages(CommandTest):
    def test_every_policy_has_a_page_that_loads_nothing(self):
        out = self.command("gallery", "--suite", SUITE, *NEVER).stdout
        self.assertEqual(out.splitlines(), [f"Gallery: out/gallery/{name}.html" for name in NAMES])
        for name in NAMES:
            with self.subTest(name=name):
                page = (self.folder / f"out/gallery/{name}.html").read_text(encoding="utf-8")
                gallery = json.loads((ROOT / f"cases/galleries/{name}.json").read_text("utf-8"))
                self.assertEqual(page.count("<article"), len(gallery["pictures"]))
                self.assertEqual(page.count('<svg class="picture"') +
                                 page.count('class="shown missing"'),
                                 3 * len(gallery["pictures"]))
                self.assertIn("default-src 'none'", page)
                self.assertNotRegex(page, r"<(script|link|img|iframe|object|form)|\bsrc=|url\(")
                for other in NAMES:
                    self.assertEqual(f'href="{other}.html"' in page, other != name)

    def test_the_same_bytes_again(self):
        pages = []
        for folder in ("a", "b"):
            self.command("gallery", "scotty3d", "--suite", SUITE, "--html", folder, *NEVER)
            pages.append((self.folder / folder / "scotty3d.html").read_bytes())
        self.assertEqual(*pages)


class Own(CommandTest):
    """A small suite: one case, one policy, one gallery."""

    def setUp(self):
        super().setUp()
        self.write("cases/one.json", EDGE)
        self.write("cases/policies/mine.json", CLOSED)
        self.write("cases/galleries/mine.json", MINE)

    def page(self, *arguments, **options):
        run = self.command("gallery", *arguments, *NEVER, **options)
        page = (self.folder / "out/gallery/mine.html").read_text(encoding="utf-8")
        return run, page

    def sentences(self, page):
        return re.findall(r'class="sentence">([^<]*)<', page)

    def test_the_rule_that_makes_the_difference_is_named(self):
        _, page = self.page("--against", "exact")
        (sentence,) = self.sentences(page)
        self.assertRegex(sentence, r"^6 pixels have another colour, by up to \d+ of 255: by "
                                   r"triangle\.fill-rule alone\. With it as OpenGL has it, the two "
                                   r"pictures are the same\.$")
        self.assertIn("the same pixels as exact", page)

    def test_a_picture_may_have_a_choice_of_its_own(self):
        picture = MINE["pictures"][0] | {"rules": {"triangle.fill-rule": "left-top"}}
        self.write("cases/galleries/mine.json", MINE | {"pictures": [picture]})
        _, page = self.page("mine", "--against", "exact")
        self.assertEqual(self.sentences(page), ["The policy and OpenGL draw the same here."])
        self.assertIn("triangle.fill-rule=left-top", page)

    def test_it_needs_no_place_in_the_suite(self):
        path = self.write("elsewhere/mine.json", MINE)
        _, page = self.page(path, "--against", "exact")
        self.assertIn("First", page)

    def test_markup_in_words_is_shown(self):
        hostile = "<script>alert(1)</script>"
        self.write("cases/one.json", EDGE | {"title": hostile})
        self.write("cases/galleries/mine.json", MINE | {
            "title": hostile, "about": hostile, "sources": ["https://x.org/\"" + hostile],
            "choices": {"triangle.fill-rule": hostile},
            "pictures": [{"case": "one", "heading": hostile, "text": hostile}]})
        _, page = self.page("--against", "exact")
        self.assertNotIn("<script", page)
        self.assertGreaterEqual(page.count("&lt;script"), 7)

    def test_a_renderer_that_is_not_there_costs_its_pictures(self):
        run, page = self.page("--against", "exec:/no/such/program", expect=RENDERER)
        self.assertIn("Gallery: ", run.stdout)
        self.assertIn("not-run", page)
        self.assertEqual(page.count('<svg class="picture"'), 2)

    def test_what_a_renderer_does_not_support_is_no_failure(self):
        self.write("cases/one.json", EDGE | {
            "target": {"width": 8, "height": 8, "samples": 4}})
        _, page = self.page("--against", "egl:softpipe")
        self.assertIn("this driver has no multisampled targets", page)

    def test_mistakes_are_told(self):
        def told(expect=USAGE, arguments=(), **files):
            for name, content in files.items():
                self.write(f"cases/galleries/{name}.json", content)
            return self.command("gallery", *arguments, "--against", "exact", *NEVER,
                                expect=expect).stderr
        self.assertIn("there is no gallery \"other\"", told(arguments=["other"]))
        self.assertIn("one of mine", told(arguments=["other"]))
        self.assertIn("cases/galleries/mine.json:1: /pictures",
                      told(mine=json.dumps(MINE | {"pictures": []})))
        self.assertIn("there is no policy \"none\"", told(mine=MINE | {"policy": "none"}))
        self.assertIn("there is no case two",
                      told(mine=MINE | {"pictures": [{"case": "two", "heading": "x"}]}))
        self.assertIn("its file has others, such as one",
                      told(mine=MINE | {"pictures": [{"case": "one:dx=1", "heading": "x"}]}))
        self.assertIn("policy mine chooses no alternative of line.snap",
                      told(mine=MINE | {"choices": {"line.snap": "x"}}))
        self.assertIn("nosuch", self.command("gallery", "--against", "nosuch", *NEVER,
                                             expect=USAGE).stderr)

    def test_one_that_is_wrong_costs_no_other(self):
        self.write("cases/galleries/wrong.json", MINE | {"policy": "none"})
        run, page = self.page("--against", "exact", expect=USAGE)
        self.assertIn("First", page)
        self.assertFalse((self.folder / "out/gallery/wrong.html").exists())

    def test_without_galleries_nothing_is_selected(self):
        (self.folder / "cases/galleries/mine.json").unlink()
        self.command("gallery", *NEVER, expect=NOTHING_SELECTED)

    def test_galleries_are_no_cases(self):
        out = self.command("run", "--list").stdout
        self.assertEqual(out, "one\n")


if __name__ == "__main__":
    unittest.main()
