# SPDX-License-Identifier: MIT
"""The subcommands beside `run`: explain, rules, validate, render, report; what `run` selects."""
import json
import shlex
import struct
import unittest
import zlib

import results_file
from suite_data import COUNT, files_of_share
from support import ROOT, SUITE, UNEXPECTED, USAGE, CommandTest, only_result, triangle_case

TIE = f"{SUITE}/triangles/ties/flat-bottom.json"
# What filters and shards are asked of: a share of it says less of the suite, and no less of them.
SELECTED = [SUITE] if COUNT == 1 else [
    f"{SUITE}/{folder}" for folder in ("lines", "points", "triangles")]


class Texts(CommandTest):
    def test_version_and_help(self):
        self.assertRegex(self.command("--version").stdout, r"^edgecase \d+\.\d+\.\d+\n$")
        told = self.command("--help").stdout
        for subcommand in ("run", "render", "explain", "rules", "backends", "validate", "bless",
                           "report", "gallery", "new", "minimize", "bench"):
            self.assertIn(f"\n  {subcommand} ", told)
            self.assertIn("Exit codes: 0", self.command(subcommand, "--help").stdout)

    def test_explain_a_pixel(self):
        results = self.results(TIE, "--against", "egl:softpipe", expect=None)
        told = only_result(results["cases"][0])["disagreements"][0]
        x, y = told["pixel"]
        out = self.command("explain", TIE, "--pixel", f"{x},{y}", "--against",
                           "egl:softpipe").stdout
        self.assertIn("triangles/ties/flat-bottom: A thin triangle", out)
        self.assertIn(f"Pixel ({x}, {y}), centre ({x + .5}, {y + .5}), by policy opengl:", out)
        self.assertIn("primitive 0 does not draw it (triangle.fill-rule): the sample", out)
        self.assertIn("egl:softpipe (softpipe): convention", out)
        self.assertIn(told["explanation"], out)
        self.assertIn(f"Ruling {told['ruling']}.", out)
        # Another pixel is not spoken of.
        self.assertNotIn(told["explanation"],
                         self.command("explain", TIE, "--pixel", "0,0", "--against",
                                      "egl:softpipe").stdout)

    def test_explain_draws_what_exact_draws(self):
        path = self.write("one.json", triangle_case(draws=[
            {"primitive": "points", "vertices": [[1.5, 0.5], [1.5, 0.5], [7.5, 7.5]]}]))
        lines = self.command("explain", path).stdout.splitlines()
        self.assertIn(".......#", lines)
        self.assertEqual(lines[-1], ".2......")

    def test_rules(self):
        text = self.command("rules").stdout
        rules = json.loads(self.command("rules", "--json").stdout)
        ids = [rule["id"] for rule in rules]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertLessEqual({"point.ownership", "line.diamond-exit", "triangle.fill-rule",
                              "triangle.shared-edge"}, set(ids))
        numbers = []
        for rule in rules:
            self.assertIn(rule["id"], text)
            self.assertTrue(rule["title"] and rule["spec"] and rule["latitude"], rule["id"])
            names = [alternative["name"] for alternative in rule["alternatives"]]
            self.assertTrue(not names or rule["standard"] in names, rule["id"])
            numbers += [ruling["number"] for ruling in rule["rulings"]]
            for ruling in rule["rulings"]:
                self.assertIn(ruling["basis"], ("normative", "contested"))
                self.assertIn(f'{ruling["clause"]}: "{ruling["quotation"]}"', text)
        self.assertEqual(sorted(numbers), sorted(set(numbers)))

    def test_rules_by_id(self):
        whole = self.command("rules").stdout
        one = self.command("rules", "line.snap").stdout
        self.assertTrue(one.startswith("line.snap\n"))
        self.assertIn(one.removesuffix("* the choice of policy opengl\n"), whole)
        self.assertEqual([rule["id"] for rule in
                          json.loads(self.command("rules", "*.snap", "--json").stdout)],
                         ["subpixel.snap", "point.snap", "line.snap", "triangle.snap"])
        self.command("rules", "line.snap", "--markdown", expect=USAGE)

    def test_rules_as_the_committed_document(self):
        document = (ROOT / "src" / "rules" / "RULINGS.md").read_text(encoding="utf-8")
        self.assertEqual(self.command("rules", "--markdown").stdout, document)
        self.command("rules", "--markdown", "--json", expect=USAGE)

    def test_commands_for_the_smallest_cases_of_clusters_work(self):
        """The summary's commands, run as they are printed, tell of the pixel that they name."""
        # Upside down here and there: nothing in the catalogue does so.
        odd = self.odd_renderer("mirror-of", "lines/strips/octagon-loop:dx=0.5:dy=0.5")
        summary = self.command("run", f"{SUITE}/lines/strips", "--against", odd, "--json",
                               "results.json",
                               expect=UNEXPECTED).stdout
        commands = [line.partition("edgecase ")[2] for line in summary.splitlines()
                    if line.startswith(" " * 15 + "edgecase explain ")]
        self.assertGreaterEqual(len(commands), 4)
        for line in commands:
            words = shlex.split(line)
            x, y = words[words.index("--pixel") + 1].split(",")
            self.assertIn(f"  ({x}, {y}) ", self.command(*words).stdout)

    def test_commands_for_what_is_unexpected_work(self):
        """The command that stands below a cause tells of the answer that it is about."""
        odd = self.odd_renderer("mirror-of", "lines/strips/octagon-loop:dx=0.5:dy=0.5")
        summary = self.command("run", f"{SUITE}/lines/strips", "--against", odd, "--json",
                               "results.json", expect=UNEXPECTED).stdout
        lines = summary.split("Unexpected, by cause:\n")[1].split("\n\n")[0].splitlines()
        self.assertEqual(lines[0], f"  1 case, {odd}: violation, not known")
        name, _, sentence = lines[2].strip().partition(": ")
        self.assertEqual(name, "lines/strips/octagon-loop:dx=0.5:dy=0.5")
        told = self.command(*shlex.split(lines[3])[1:]).stdout
        self.assertIn(sentence.rpartition(": ")[2], told)

    def test_validate(self):
        run = self.command("validate", *([SUITE] if COUNT == 1 else files_of_share()), "--check-format")
        self.assertRegex(run.stdout,
                         r"(?m)^[\d,]+ cases are well formed, 0 faults, 0 drawings not met$")
        self.assertEqual(run.stderr, "")


def png_pixels(data):
    """Width, height, and RGBA rows from the top, of a PNG of 8-bit RGB or RGBA."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, position = [], 8
    while position < len(data):
        (length,) = struct.unpack(">I", data[position:position + 4])
        chunks.append((data[position + 4:position + 8], data[position + 8:position + 8 + length]))
        position += length + 12
    width, height, depth, kind = struct.unpack(">IIBB", chunks[0][1][:10])
    assert depth == 8 and kind in (2, 6)
    size = 3 if kind == 2 else 4
    packed = zlib.decompress(b"".join(content for name, content in chunks if name == b"IDAT"))
    rows, above = [], bytes(width * size)
    for y in range(height):
        start = y * (width * size + 1)
        above = unfilter(packed[start], packed[start + 1:start + 1 + width * size], above, size)
        rows.append([list(above[x * size:x * size + size]) + [255] * (4 - size)
                     for x in range(width)])
    return width, height, rows


def unfilter(kind, line, above, size):
    """A row of a PNG without its filter (PNG specification, 9.2)."""
    row = bytearray(line)
    for i in range(len(row)):
        left = row[i - size] if i >= size else 0
        corner = above[i - size] if i >= size else 0
        if kind == 4:
            estimate = left + above[i] - corner
            guess = min((left, above[i], corner), key=lambda value: abs(estimate - value))
        else:
            guess = [0, left, above[i], (left + above[i]) // 2][kind]
        row[i] = (row[i] + guess) % 256
    return bytes(row)


class Render(CommandTest):
    def test_png_files_show_the_pixels_top_row_first(self):
        for renderer, scale in (("exact", 1), ("egl:llvmpipe", 3)):
            self.command("render", f"{SUITE}/colors", "--with", renderer, "--png",
                         "pictures", "--scale", scale)
            lines = self.command("render", f"{SUITE}/colors", "--with", renderer,
                                 "--json", "-").stdout.splitlines()
            files = [path for path in (self.folder / "pictures").rglob("*") if path.is_file()]
            self.assertEqual(len(files), len(lines))
            for rendering in map(json.loads, lines):
                width, height, rows = png_pixels(
                    (self.folder / "pictures" / f"{rendering['id']}.png").read_bytes())
                self.assertEqual((width, height),
                                 (scale * rendering["width"], scale * rendering["height"]))
                for y in range(0, height):
                    for x in range(0, width):
                        index = ((rendering["height"] - 1 - y // scale) * rendering["width"]
                                 + x // scale)
                        self.assertEqual(rows[y][x], rendering["pixels"][4 * index:4 * index + 4])

    def test_json_is_one_line_per_case_in_order(self):
        files = files_of_share("lines", "points", "output")
        out = self.command("render", *files).stdout
        lines = [json.loads(line) for line in out.splitlines()]
        self.assertEqual([line["id"] for line in lines], sorted(line["id"] for line in lines))
        for line in lines:
            self.assertEqual(len(line["pixels"]), 4 * line["width"] * line["height"])
            order = [(f["y"], f["x"], f["primitive"]) for f in line["fragments"]]
            self.assertEqual(order, sorted(order))
        self.command("render", *files, "--json", "all.jsonl")
        self.assertEqual((self.folder / "all.jsonl").read_text(encoding="utf-8"), out)


class Report(CommandTest):
    def test_json_on_standard_output_is_nothing_but_json(self):
        run = self.command("run", f"{SUITE}/lines", "--against", "exact", "--json", "-")
        self.assertGreater(len(results_file.parsed(run.stdout)["cases"]), 50)
        self.assertIn("agree", run.stderr)

    def test_colours_only_where_asked(self):
        plain = self.command("run", TIE, "--against", "exact").stdout
        self.assertNotIn("\x1b", plain)
        self.assertIn("\x1b", self.command("run", TIE, "--against", "exact", "--color",
                                           "always").stdout)


class Selection(CommandTest):
    def listed(self, *arguments, **variables):
        return self.command("run", *arguments, "--list", **variables).stdout.split()

    def test_shards_partition_the_suite(self):
        everything = self.listed(*SELECTED)
        by_option = [self.listed(*SELECTED, "--shard", f"{i}/3") for i in (1, 2, 3)]
        self.assertEqual(sorted(sum(by_option, [])), everything)
        self.assertTrue(all(by_option))
        for i in range(3):
            by_bazel = self.listed(*SELECTED, TEST_TOTAL_SHARDS="3", TEST_SHARD_INDEX=str(i))
            by_gitlab = self.listed(*SELECTED, CI_NODE_TOTAL="3", CI_NODE_INDEX=str(i + 1))
            self.assertEqual(by_bazel, by_option[i])
            self.assertEqual(by_gitlab, by_option[i])
        # The option has the last word.
        self.assertEqual(self.listed(*SELECTED, "--shard", "1/3", TEST_TOTAL_SHARDS="7",
                                     TEST_SHARD_INDEX="2"), by_option[0])

    def test_samples_take_every_so_many_th_case(self):
        everything = self.listed(*SELECTED)
        for i in (1, 2, 50):
            self.assertEqual(self.listed(*SELECTED, "--sample", f"{i}/50"), everything[i - 1::50])
        # A sample is divided into shards, and is not the whole suite.
        shards = [self.listed(*SELECTED, "--sample", "2/50", "--shard", f"{i}/2") for i in (1, 2)]
        self.assertEqual(sorted(sum(shards, [])), everything[1::50])
        told = self.command("run", *SELECTED, "--sample", "0/3", "--list", expect=USAGE).stderr
        self.assertIn("\"0/3\" is no sample; write I/N with I from 1 to N", told)

    def test_filters_excludes_and_tags(self):
        everything = set(self.listed(*SELECTED))
        # An option takes one value: what follows is a path.
        points = set(self.listed("--filter", "points/*", *SELECTED))
        self.assertEqual(points, {name for name in everything if name.startswith("points/")})
        both = set(self.listed("--filter", "points/*", "--filter", "lines/*", *SELECTED))
        self.assertEqual(both, {n for n in everything if n.startswith(("points/", "lines/"))})
        self.assertEqual(set(self.listed(*SELECTED, "--exclude", "points/*")), everything - points)
        self.assertEqual(set(self.listed(*SELECTED, "--filter", "*", "--exclude", "lines/*",
                                         "--exclude", "points/*")), everything - both)
        slivers = set(self.listed("--tag", "sliver", *SELECTED))
        fans = set(self.listed("--tag", "fan", *SELECTED))
        self.assertTrue(slivers and fans)
        self.assertEqual(set(self.listed("--tag", "fan", "--tag", "sliver", *SELECTED)),
                         slivers | fans)

    def test_ids_stand_for_paths(self):
        """Those of the folder `cases` in the working folder; the suite's own in the checkout."""
        (self.folder / "cases").symlink_to(SUITE)
        points = self.listed("cases/points")
        for words in (["points"], ["points/*"], ["cases/points"]):
            self.assertEqual(self.listed(*words), points)
        self.assertEqual(self.listed("triangles/ties/flat-bottom"), ["triangles/ties/flat-bottom"])
        [swept] = self.listed("lines/strips/octagon-loop:dx=0.5:dy=0.5")
        self.assertEqual(swept, "lines/strips/octagon-loop:dx=0.5:dy=0.5")
        some = self.listed("lines/strips/octagon-loop:dx=0.5")
        self.assertEqual(some, [name for name in self.listed("lines/strips/octagon-loop")
                                if ":dx=0.5:" in name])
        for arguments in (["render", swept], ["explain", swept, "--pixel", "3,3"], ["draw", swept],
                          ["validate", swept], ["separation", swept],
                          ["record", swept, "--against", "exact", "-o", "one.rec"],
                          ["new", "-", "--from", swept]):
            told = self.command(*arguments)
            self.assertEqual(told.stderr, "", arguments)
        self.assertEqual(json.loads(self.command("render", swept).stdout)["id"], swept)
        self.assertTrue(self.command("explain", swept).stdout.startswith(f"{swept}: "))

    def test_single_files_and_folders_keep_their_ids(self):
        self.assertEqual(self.listed(TIE), ["triangles/ties/flat-bottom"])
        self.assertEqual(self.listed(f"{SUITE}/points"),
                         [name for name in self.listed(*SELECTED) if name.startswith("points/")])
        # A case that is named twice runs once.
        self.assertEqual(self.listed(TIE, TIE, f"{SUITE}/triangles/ties").count(
            "triangles/ties/flat-bottom"), 1)

    def test_against_takes_one_renderer(self):
        results = self.results("--against", "exact", f"{SUITE}/points")
        self.assertEqual([info["name"] for info in results["renderers"]], ["exact"])


if __name__ == "__main__":
    unittest.main()
