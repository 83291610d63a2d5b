# SPDX-License-Identifier: MIT
"""`new` begins case files that load, and `validate` lays files out: by rule, from a case, from a
result, from coordinates. One command and no build later, the case is in the next run."""
import json
import unittest

from support import AS_EXPECTED, NOTHING_SELECTED, UNEXPECTED, USAGE, CommandTest, only_result

SOFTPIPE = ["--against", "egl:softpipe"]


class New(CommandTest):
    def setUp(self):
        super().setUp()
        self.copy_suite("points", "lines")
        self.write("cases/case.schema.json", "{}")

    def new(self, *arguments, expect=AS_EXPECTED):
        return self.command("new", *arguments, expect=expect)

    def read(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def test_from_coordinates(self):
        self.new("cases/found/one.json", "--draw", "lines 0.5,~0.3 9,1+1/2", "--rule", "line.snap")
        case = self.read("cases/found/one.json")
        self.assertEqual(case["$schema"], "../case.schema.json")
        self.assertEqual(case["rules"], ["line.snap"])
        self.assertEqual(case["target"], {"width": 16, "height": 16})
        self.assertEqual(case["draws"], [{"primitive": "lines",
                                          "vertices": [[0.5, "~0.3"], [9, "1+1/2"]]}])
        self.command("validate", "cases/found", "--check-format")

    def test_target_and_words_can_be_given(self):
        self.new("cases/one.json", "--draw", "triangles 1,1,0.5 7,1,0.5 1,7,0.25", "--size", "9x12",
                 "--samples", "4", "--depth", "depth24", "--title", "A title", "--why", "Because.")
        case = self.read("cases/one.json")
        self.assertEqual(case["target"], {"width": 9, "height": 12, "samples": 4,
                                          "depth": "depth24"})
        self.assertEqual((case["title"], case["why"]), ("A title", "Because."))
        self.assertEqual(case["rules"], ["triangle.fill-rule"])

    def test_with_what_exact_draws(self):
        out = self.new("cases/one.json", "--draw", "points 1.5,0.5 2.5,7.5", "--drawing").stdout
        self.assertIn("check the drawing by hand", out)
        drawing = self.read("cases/one.json")["expect"][0]["coverage"]
        self.assertEqual(drawing, ["..#....."] + 6 * ["........"] + [".#......"])
        self.command("validate", "cases/one.json", "--check-format")
        self.new("cases/two.json", "--draw", "points 1.5,0.5", "--samples", "4", "--drawing",
                 expect=USAGE)

    def test_by_rule(self):
        for rule in ("line.snap", "line.row-order", "subpixel.snap"):
            name = f"cases/new/{rule}.json"
            self.new(name, "--rule", rule)
            self.assertEqual(self.read(name)["rules"], [rule])
            # The loader chooses colours, as in the suite's own files.
            self.assertNotIn("color", (self.folder / name).read_text(encoding="utf-8"))
        self.command("validate", "cases/new", "--check-format")
        run = self.new("cases/x.json", "--rule", "texture.filter", expect=USAGE)
        self.assertIn('no case in "cases" is about texture.filter', run.stderr)

    def test_from_a_case(self):
        name = next(case for case in self.command("run", "cases/points", "--list").stdout.split()
                    if ":" in case)
        self.new("cases/again.json", "--from", name)
        exact = {}
        for line in self.command("render", "cases", "--filter", name, "--filter", "again",
                                 "--json", "-").stdout.splitlines():
            rendering = json.loads(line)
            exact[rendering["id"]] = [(f["x"], f["y"], f["primitive"])
                                      for f in rendering["fragments"]]
        self.assertEqual(exact[name], exact["again"])
        path = "cases/lines/short/between-diamonds.json"
        self.assertIn("between diamonds".replace(" ", "-"), self.new("-", "--from", path).stdout)

    def test_a_find_is_in_the_next_run_and_becomes_known(self):
        results = self.results("cases/lines/short", *SOFTPIPE, expect=None)
        found = next(case for case in results["cases"]
                     if only_result(case)["verdict"] == "violation")
        self.new("cases/finds/find.json", "--from", found["id"], "--results", "results.json",
                 "--title", "Found")
        why = self.read("cases/finds/find.json")["why"]
        told = only_result(found)["disagreements"][0]["explanation"]
        self.assertIn(f"egl:softpipe: violation: {told}", why)

        after = self.results("cases/finds", *SOFTPIPE, expect=UNEXPECTED)
        (case,) = after["cases"]
        self.assertEqual(case["id"], "finds/find")
        self.assertEqual(only_result(case)["fingerprint"], only_result(found)["fingerprint"])
        self.command("bless", "results.json", "--apply")
        self.results("cases/finds", *SOFTPIPE, expect=AS_EXPECTED)

    def test_nothing_is_overwritten_unasked(self):
        arguments = ("cases/one.json", "--draw", "points 1.5,1.5")
        self.new(*arguments)
        self.assertIn("--force", self.new(*arguments, expect=USAGE).stderr)
        self.new(*arguments, "--force")

    def test_bad_input(self):
        for arguments, message in (
                (("a.txt", "--rule", "line.snap"), "must end with .json"),
                (("a.json",), "nothing to begin with"),
                (("a.json", "--rule", "line.snab"), 'there is no rule "line.snab"; did you mean "line.snap"? `edgecase rules` prints all'),
                (("a.json", "--draw", "points 0.1,1"), "x: 0.1 is no multiple of 1/65536"),
                (("a.json", "--draw", "dots 1,1"), 'cannot be "dots"'),
                (("a.json", "--draw", "points 1"), '"1" is no vertex'),
                (("a.json", "--draw", "points"), "is no draw"),
                (("a.json", "--draw", "points 1,1", "--size", "8"), "write WIDTHxHEIGHT"),
                (("a.json", "--draw", "points 1,1", "--size", "0x8"), "width"),
                (("a.json", "--from", "no/such"), "no/such: there is no such file, folder or case"),
                (("a.json", "--from", "lines/short/between-diamonds:dx=1"),
                 "between-diamonds:dx=1: there is no such case"),
                (("a.json", "--from", "x", "--results", "none.json"), "none.json"),
                (("a.json", "--results", "none.json"), "--from")):
            with self.subTest(arguments):
                self.assertIn(message, self.new(*arguments, expect=USAGE).stderr)
                self.assertFalse((self.folder / "a.json").exists())


class Format(CommandTest):
    def test_lays_out_what_is_not(self):
        self.write_cases("tidy")
        self.write("cases/untidy.json", json.dumps(json.loads(
            (self.folder / "cases/tidy.json").read_text(encoding="utf-8")) | {"title": "Untidy"}))
        self.command("validate", "cases/tidy.json", "--format")
        tidy = (self.folder / "cases/tidy.json").read_bytes()
        run = self.command("validate", "cases", "--check-format", expect=UNEXPECTED)
        self.assertIn("cases/untidy.json: not laid out", run.stdout)
        self.assertNotIn("tidy.json: laid out", run.stdout)
        run = self.command("validate", "cases", "--format")
        self.assertIn("cases/untidy.json: laid out", run.stdout)
        self.assertEqual((self.folder / "cases/tidy.json").read_bytes(), tidy)
        self.command("validate", "cases", "--check-format")

    def test_leaves_faulty_files_alone(self):
        path = self.write("cases/faulty.json", '{"title":1}')
        self.command("validate", "cases", "--format", expect=USAGE)
        self.assertEqual(path.read_text(encoding="utf-8"), '{"title":1}')

    def test_nothing_to_lay_out(self):
        (self.folder / "cases").mkdir()
        self.command("validate", "cases", "--format", expect=NOTHING_SELECTED)


if __name__ == "__main__":
    unittest.main()
