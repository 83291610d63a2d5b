# SPDX-License-Identifier: MIT
"""The usual mistakes on the command line and in case files, each with the whole of what is said of
it: what is wrong, where, and what to write instead."""
import json
import unittest

from support import INTERNAL, NOTHING_SELECTED, USAGE, CommandTest, triangle_case

HELP = "; `edgecase help {}` says what it takes"
LISTS = "`edgecase help` lists them"
KNOWN = ("exact, egl:llvmpipe, egl:softpipe, egl:zink, egl:zink-swiftshader, egl:deviceN, "
         "egl:device=NAME, egl:lib=PATH, "
         "egl-es:llvmpipe, egl-es:softpipe, egl-es:zink, egl-es:deviceN, egl-es:device=NAME, "
         "egl-es:lib=PATH, osmesa:llvmpipe, "
         "osmesa:softpipe, webgl:chromium, webgl:chromium-gl, webgl:firefox, exec:PROGRAM, recording:FILE")
EXACT = ("--against", "exact")

# The command line, the exit code, and all that stands on standard error, "edgecase: " left out
# where the line begins so. Nothing stands on standard output.
COMMAND_LINES = (
    # Commands and options.
    (("rnu",), USAGE, f'there is no subcommand "rnu"; did you mean run? {LISTS}'),
    (("help", "explian"), USAGE, f'there is no subcommand "explian"; did you mean explain? {LISTS}'),
    ((), USAGE, f"a subcommand, such as run, is required; {LISTS}"),
    (("run", "--agianst", "exact"), USAGE,
     "run has no option --agianst; did you mean --against? `edgecase help run` lists them"),
    (("run", "-against", "exact"), USAGE,
     "run has no option -against; did you mean --against? `edgecase help run` lists them"),
    (("profile", "--agianst=exact"), USAGE,
     "profile has no option --agianst; did you mean --against? `edgecase help profile` "
     "lists them"),
    (("profile",), USAGE, "--against is required" + HELP.format("profile")),
    (("explain",), USAGE, "case is required" + HELP.format("explain")),
    (("compare", "a.json", "b.json", "c.json"), USAGE,
     'compare has no use for "c.json"' + HELP.format("compare")),
    (("run", "--jobs", "0"), USAGE, "--jobs: Value 0 not in range 1 to 256" + HELP.format("run")),
    (("run", "--shard", "3/2"), USAGE,
     '--shard: "3/2" is no shard; write I/N with I from 1 to N, for example 1/4'
     + HELP.format("run")),
    # Cases.
    (("run", "points/center"), USAGE,
     "points/center: there is no such file, folder or case; did you mean points/centre?"),
    (("explain", "centre"), USAGE,
     "centre: there is no such file, folder or case; did you mean points/centre?"),
    (("run", "pionts"), USAGE,
     "pionts: there is no such file, folder or case; did you mean points?"),
    (("validate", "cases/points/center.json"), USAGE,
     "cases/points/center.json: there is no such file or folder; did you mean "
     "cases/points/centre.json?"),
    (("run", "triangles/*"), USAGE,
     "triangles/*: there is no such file, folder or case; `edgecase run --list` prints the ids of "
     "all cases"),
    (("render", "lines/ramp:dx=9"), USAGE,
     "lines/ramp:dx=9: there is no such case; `edgecase run cases/lines/ramp.json --list` prints "
     "the ids of 4 that there are"),
    (("minimize", "lines/ramp", *EXACT), USAGE,
     "lines/ramp stands for 4 cases; name one of them, for example lines/ramp:dx=1:dy=1"),
    (("run", "--filter", "zzz*", *EXACT), NOTHING_SELECTED,
     "no case is selected; `edgecase run --list` prints the ids of all"),
    (("explain", "points/centre", "--pixel", "8,0"), USAGE,
     '--pixel "8,0" is no pixel of this target; write X,Y with X from 0 to 7 and Y from 0 (bottom) '
     "to 7"),
    # Renderers, rules, policies.
    (("run", "--against", "llvmpipe"), USAGE,
     f"there is no renderer 'llvmpipe'; did you mean egl:llvmpipe? Known are {KNOWN}"),
    (("render", "--with", "egl:lvmpipe"), USAGE,
     f"there is no renderer 'egl:lvmpipe'; did you mean egl:llvmpipe? Known are {KNOWN}"),
    (("run", "--against", "./mine.py"), USAGE,
     f"there is no renderer './mine.py'; did you mean exec:./mine.py? Known are {KNOWN}"),
    (("rules", "line.snab"), USAGE,
     'there is no rule "line.snab"; did you mean "line.snap"? `edgecase rules` prints all'),
    (("draw", "points/centre", "--rule", "line.algorthm"), USAGE,
     'there is no rule "line.algorthm"; did you mean "line.algorithm"? `edgecase rules` prints all'),
    (("run", "--policy", "direct3d11"), USAGE,
     'there is no policy "direct3d11"; did you mean "direct3d-11"? write the path of a policy file, '
     "or one of direct3d-11, opengl"),
    # Files.
    (("compare", "old.json", "new.json"), INTERNAL,
     "cannot read old.json: No such file or directory"),
    (("bless",), INTERNAL, "cannot read out/results.zst: No such file or directory"),
    (("report", "cases/points/centre.json"), USAGE,
     "cases/points/centre.json: this is no results file of `edgecase run`: it is one object over many lines; "
     "name a file that `edgecase run --json` wrote"),
    (("run", "--last-failed", *EXACT), USAGE,
     "--last-failed finds no last results: there is no out/results.zst; run once without it, or "
     "name the results with --json"),
)


def drawn(primitive="triangles", vertices=((1, 1), (6.25, 1), (1, 6)), **keys):
    return triangle_case(draws=[{"primitive": primitive, "vertices": vertices, **keys}])


# What is written in the suite's wrong.json, and all that is said of it behind its name.
CASE_FILES = (
    (drawn(vertices=[[.1, 1], [6, 1], [1, 6]]),
     ":1: /draws/0/vertices/0/0: x: 0.1 is no multiple of 1/65536; write one of its neighbours "
     '0.0999908447265625 and 0.100006103515625, or "~0.1" for the nearest'),
    (drawn(vertices=[["1/3", 1], [6, 1], [1, 6]]),
     ':1: /draws/0/vertices/0/0: x: "1/3" has a denominator that is no power of two up to 65536; '
     "write the fraction with one, or ~ and a decimal for the nearest multiple of 1/65536"),
    (drawn(vertices=[[10000, 1], [6, 1], [1, 6]]),
     ":1: /draws/0/vertices/0/0: x is 10000, out of range; write a number from -8192 to 8192"),
    (drawn(vertices=[[1], [6, 1], [1, 6]]),
     ":1: /draws/0/vertices/0: a vertex takes 2 to 4 coordinates, and this has 1; write [x, y], "
     "[x, y, z] or [x, y, z, w]"),
    (drawn(vertices=[[1, 1], [6, 1]]),
     ":1: /draws/0/vertices: a draw has 2 vertices, and each primitive takes 3; write a multiple "
     "of 3"),
    (drawn("triangle"),
     ':1: /draws/0/primitive: a primitive cannot be "triangle"; did you mean "triangles"? Allowed '
     "are points, lines, line_strip, line_loop, triangles, triangle_strip, triangle_fan"),
    (drawn(colour=[1, 0, 0]),
     ':1: /draws/0/colour: "colour" is no key of a draw; did you mean "color"? Allowed are '
     "primitive, vertices, mesh, state, color, transform"),
    (drawn(state={"interpolation": "smoth"}),
     ':1: /draws/0/state/interpolation: interpolation cannot be "smoth"; did you mean "smooth"? '
     "Allowed are flat, smooth, noperspective"),
    (triangle_case(rules=["line.snab"]),
     ':1: /rules/0: there is no rule "line.snab"; did you mean "line.snap"?'),
    (triangle_case(title=7),
     ":1: /title: title must be a string, not the number 7; write it in double quotes"),
    (triangle_case(target={"width": 8}),
     ':1: /target: a target lacks "height"; add "height": ...'),
    (triangle_case(target={"width": 0, "height": 8}),
     ":1: /target/width: width is 0, out of range; write a whole number from 1 to 4096"),
    (triangle_case(expect=[{"policy": "opengl", "coverage": ["........"] * 7}]),
     ":1: /expect/0/coverage: the drawing has 7 rows, and the target has 8; draw 8 rows, the top "
     "one first"),
    ('{"title": "x",\n "rules": ["line.snap",]}',
     ":2: no valid JSON at line 2, column 24: a comma stands before the closing ]; remove the comma"),
    ('{\n // a triangle\n "title": "x"}',
     ':2: no valid JSON at line 2, column 2: JSON knows no comments; put the words into "why" or '
     "remove them"),
    ("{'title': 'x'}",
     ":1: no valid JSON at line 1, column 2: single quotes are no quotes in JSON; use double quotes"),
    ('{"title": "a" "rules": []}',
     ':1: no valid JSON at line 1, column 15: "rules" stands where no string can; put a comma '
     "between two values, and a colon between a key and its value"),
)


class Mistakes(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("cases/points/centre.json", drawn("points", [[1.5, 1.5]]))
        self.write("cases/lines/ramp.json", {
            **drawn("lines", [[1, 1], [3, 2]]),
            "sweep": {axis: {"add_to": [f"/draws/0/vertices/0/{axis[1]}"], "values": [0, 1]}
                      for axis in ("dx", "dy")}})
        self.write("cases/policies/direct3d-11.json", {"name": "direct3d-11"})
        self.write("mine.py", "")

    def test_on_the_command_line(self):
        self.assertGreaterEqual(len(COMMAND_LINES) + len(CASE_FILES), 20)
        for arguments, code, message in COMMAND_LINES:
            with self.subTest(" ".join(arguments)):
                run = self.command(*arguments, expect=code)
                self.assertEqual(run.stderr.removeprefix("edgecase: "), message + "\n")
                self.assertEqual(run.stdout, "")
                self.assertFalse((self.folder / "out").exists(), "nothing is written")

    def test_in_case_files(self):
        for content, message in CASE_FILES:
            with self.subTest(message):
                text = content if isinstance(content, str) else json.dumps(content)
                self.write("cases/wrong.json", text)
                run = self.command("validate", "wrong", expect=USAGE)
                self.assertEqual(run.stderr, f"cases/wrong.json{message}\n")


if __name__ == "__main__":
    unittest.main()
