# SPDX-License-Identifier: MIT
"""edgecase rules --book: pages that teach the rules. Each worked scene says whether its pixel is
drawn as the case's author drew it by hand, and why in the words and the picture of `explain`."""
import html
import json
import pathlib
import re
import shlex
import unittest

from support import ROOT, SUITE, USAGE, CommandTest, triangle_case

# Each scene's pixel, and whether the drawing in its case file has it; of several samples, the mask.
ANSWERS = {
    "points/just-below-integer-by-1-256": ((3, 2), True),
    "clipping/near/row-of-centres:z=-16": ((2, 4), True),
    "clipping/eye/w-is-zero:x=0:y=1:z=0": ((2, 7), True),
    "points/horizontal-edge": ((2, 4), True),
    "points/corner": ((3, 3), False),
    "lines/diamonds/start-right-corner": ((3, 3), True),
    "lines/diamonds/end-left-corner-eastward": ((2, 3), False),
    "lines/diagonals/rising-on-edges": ((0, 1), True),
    "lines/slopes/one-half-rising": ((2, 2), True),
    "lines/ends/one-pixel-short": ((12, 1), False),
    "lines/short/between-diamonds": ((3, 3), False),
    "lines/joints/turn-tail-to-tail": ((5, 1), False),
    "triangles/ties/flat-top": ((3, 3), True),
    "triangles/ties/flat-bottom": ((3, 3), False),
    "triangles/single/degenerate-collinear": ((3, 3), False),
    "triangles/shared-edges/vertical": ((3, 4), True),
    "triangles/shared-edges/hole-where-x-is-a-third": ((6, 6), True),
    "output/culling/both-windings:cull=back:face=ccw": ((6, 4), False),
    "samples/patterns/left-edge:edge=0.375": ((1, 1), 0xb),
    "samples/enable/triangle-on-and-off:multisample=false:edge=0.5": ((1, 1), 0x1),
}
SCENE = re.compile(r'<article class="scene" id="scene-([^"]*)">(.*?)</article>', re.DOTALL)


def text_of(markup):
    return html.unescape(re.sub(r"<[^>]*>", "", markup))


def file_of(case):
    return pathlib.Path(SUITE, case.partition(":")[0] + ".json")


def number(text):
    """A value of a sweep as ids and files write it."""
    numerator, _, denominator = str(text).partition("/")
    return float(numerator) / float(denominator or 1)


def holds(drawing, case):
    """Is the drawing about the case? One without `when` is, where no other is."""
    parts = dict(part.split("=") for part in case.split(":")[1:])
    same = {True: "true", False: "false"}
    return all(parts[axis] == same.get(value, value) if isinstance(value, bool) or
               not re.match(r"-?\d", str(value)) else number(parts[axis]) == number(value)
               for axis, value in drawing.get("when", {}).items())


def drawn_by_hand(case, pixel):
    """What the case's author drew at the pixel: hits, or the mask of samples."""
    drawings = [d for d in json.loads(file_of(case).read_text(encoding="utf-8"))["expect"]
                if holds(d, case)]
    drawing = max(drawings, key=lambda d: len(d.get("when", {})))
    x, y = pixel
    if "masks" in drawing:
        return int(drawing["masks"][::-1][y].split()[x].replace(".", "0"), 16)
    return drawing["coverage"][::-1][y][x] != "."


class Book(CommandTest):
    def pages(self, folder="book"):
        out = self.command("rules", "--book", folder, "--suite", SUITE).stdout
        self.assertEqual(out, f"Rule book: {folder}/index.html\n")
        return {path.name: path.read_text(encoding="utf-8")
                for path in sorted((self.folder / folder).iterdir())}

    def scenes(self, pages):
        return {html.unescape(case): markup for page in pages.values()
                for case, markup in SCENE.findall(page)}

    def test_scenes_answer_as_their_authors_drew_and_as_explain_says(self):
        scenes = self.scenes(self.pages())
        self.assertEqual(set(scenes), set(ANSWERS))
        self.assertGreaterEqual(len(scenes), 20)
        (self.folder / "cases").symlink_to(SUITE)
        for case, ((x, y), drawn) in ANSWERS.items():
            with self.subTest(case=case):
                self.assertEqual(drawn_by_hand(case, (x, y)), drawn)
                scene = scenes[case]
                self.assertEqual(re.search(r'class="answer"><span[^>]*>([^<]*)<', scene)[1],
                                 "drawn" if drawn else "not drawn")
                self.assertIn(f"<h3>Is pixel ({x}, {y}) drawn?</h3>", scene)
                (command,) = re.findall(r"<code>edgecase ([^<]*)</code>", scene)
                words = shlex.split(html.unescape(command))
                self.assertEqual(words[words.index("--pixel") + 1], f"{x},{y}")
                told = self.command(*words, "--svg", "pixel.svg").stdout
                self.assertTrue(told.startswith(case + ": "))
                (text,) = re.findall(r'<pre class="lines words">(.*?)</pre>', scene, re.DOTALL)
                self.assertEqual(told[told.index(f"Pixel ({x}, {y})"):], html.unescape(text))
                picture = (self.folder / "pixel.svg").read_text(encoding="utf-8")
                self.assertIn(f'<figure class="shown">{picture}</figure>', scene)

    def test_every_rule_alternative_and_ruling_is_taught_once(self):
        pages = self.pages()
        text = "".join(pages.values())
        rules = json.loads(self.command("rules", "--json").stdout)
        for rule in rules:
            with self.subTest(rule=rule["id"]):
                (home,) = [name for name, page in pages.items() if f'id="{rule["id"]}"' in page]
                shown = text_of(pages[home]).replace("`", "")
                for words in (rule["title"], rule["latitude"],
                              *(r["text"] for r in rule["rulings"])):
                    self.assertIn(words.replace("`", ""), shown)
                alike = re.search(rf'id="{re.escape(rule["id"])}".*?(Its alternatives are|<h3|$)',
                                  pages[home], re.DOTALL)[1] == "Its alternatives are"
                if not alike:
                    for alternative in rule["alternatives"]:
                        self.assertIn(alternative["meaning"].replace("`", ""), shown)
        numbers = re.findall(r'id="ruling-(\d+)"', text)
        self.assertEqual(sorted(map(int, numbers)),
                         sorted(r["number"] for rule in rules for r in rule["rulings"]))
        for ruling in (r for rule in rules for r in rule["rulings"]):
            self.assertIn(ruling["quotation"], html.unescape(text))

    def test_links_lead_somewhere_and_pages_load_nothing(self):
        pages = self.pages()
        targets = {name: set(re.findall(r' id="([^"]*)"', page)) for name, page in pages.items()}
        for name, page in pages.items():
            self.assertEqual(len(targets[name]), page.count(' id="'), f"{name}: an id twice")
            self.assertIn("default-src 'none'", page)
            self.assertNotRegex(page, r"<(script|link|img|iframe|object|form)|\bsrc=|url\(| style=")
            for link in re.findall(r'href="([^"]*)"', page):
                file, _, anchor = link.partition("#")
                self.assertIn(file or name, pages)
                if anchor:
                    self.assertIn(anchor, targets[file or name], f"{name}: {link}")

    def test_the_same_bytes_again(self):
        self.assertEqual(self.pages("a"), self.pages("b"))

    def test_another_suite_is_refused(self):
        self.write("other/points/corner.json", triangle_case())
        told = self.command("rules", "--book", "book", "--suite", "other", expect=USAGE)
        self.assertIn("other/", told.stderr)
        self.assertFalse((self.folder / "book").exists())
        self.command("rules", "--book", "book", "--json", expect=USAGE)
        self.command("rules", "--suite", SUITE, expect=USAGE)

    def test_a_pixel_is_drawn_only_where_there_is_one(self):
        case = ROOT / "cases/triangles/ties/flat-top.json"
        told = self.command("explain", case, "--svg", "a.svg", expect=USAGE)
        self.assertIn("--pixel", told.stderr)
        self.command("explain", case, "--pixel", "8,0", "--svg", "a.svg", expect=USAGE)
        self.assertFalse((self.folder / "a.svg").exists())


if __name__ == "__main__":
    unittest.main()
