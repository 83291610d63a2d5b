# SPDX-License-Identifier: MIT
"""`edgecase backends exec:PROGRAM`: both examples and our own worker keep the protocol, programs that
break one sentence of it fail that check, and the example in C++ is charged with nothing that it draws."""
import collections
import json
import shlex
import subprocess
import sys
import textwrap
import unittest

from suite_data import COUNT, in_share
from support import (AS_EXPECTED, BIN, RENDERER, ROOT, SUITE, UNEXPECTED, CommandTest, only_result)

SMALL = f"exec:{shlex.quote(str(BIN / 'edgecase-example'))}"
LARGE = "exec:" + " ".join(map(shlex.quote, [
    sys.executable, "-B", str(ROOT / "reference" / "examples" / "rasterizer.py")]))
WORKER = "exec:" + " ".join(map(shlex.quote, [
    "env", "GALLIUM_DRIVER=llvmpipe", "LIBGL_ALWAYS_SOFTWARE=1", "LP_NUM_THREADS=0",
    str(BIN / "edgecase-gl"), "egl-surfaceless"]))
# One case in so many, of the folders that the example in C++ has something of.
SHARE = ["--sample", "1/20"]
FOLDERS = ("colors", "lines", "points", "surfaces", "targets", "triangles")

# A program that hands every request on to the example in C++, and its answers back. BEFORE changes
# the request, FAULT the answer or what becomes of it.
BETWEEN = """
import json, os, subprocess, sys
example = subprocess.Popen([sys.argv[1]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
count = 0
for line in sys.stdin:
    count += 1
    request = json.loads(line)
    {before}
    example.stdin.write(json.dumps(request) + chr(10))
    example.stdin.flush()
    answer = json.loads(example.stdout.readline())
    {fault}
    print(json.dumps(answer), flush=True)
"""
# What the example does not know is cut out of the scene, and the rest is made such that it draws it.
IGNORE = """
    known = {'target', 'viewport', 'draws', 'width', 'height', 'samples', 'color', 'surface', 'clear',
             'primitive', 'interpolation', 'provoking_vertex', 'line_width', 'point_size', 'vertices',
             'position'}
    def cut(thing):
        if isinstance(thing, list):
            return [cut(part) for part in thing]
        if isinstance(thing, dict):
            return {key: cut(part) for key, part in thing.items() if key in known}
        return thing
    request['scene'] = cut(request['scene'])
    request['scene']['target']['samples'] = 1
    for draw in request['scene']['draws']:
        draw.update(line_width=1, point_size=1, interpolation='flat')
"""
# Name of the fault: what it does, and the checks that it fails, by words of their names.
FAULTS = {
    "digest": ("answer['digest'] = 'x'", {"repeats the digest"}),
    "first digest": ("first = globals().setdefault('first', answer['digest']); "
                     "answer['digest'] = first", {"repeats the digest"}),
    "chatter": ("print('drawing', flush=True)", {"writes nothing else"}),
    "second line": ("print(json.dumps(answer), flush=True)", {"writes nothing else"}),
    "one scene": ("print(json.dumps(answer), flush=True); sys.exit(0)",
                  {"draws several scenes in one process"}),
    "counts": ("answer.get('pixels', [0])[0:1] = [count % 7]", {"answers the same scene alike"}),
    "swapped size": ("t = request['scene']['target']; "
                     "answer.get('pixels', [])[4 * t['height'] ** 2:] = []",
                     {"has as many pixels"}),
    "fragments of nothing": ("answer.get('fragments', []).append({'x': 0, 'y': 0, 'primitive': 0})",
                             {"answers an empty scene"}),
    "numbers from 1": ("[f.update(primitive=f['primitive'] + 1) for f in answer.get('fragments', [])]",
                       {"draws points", "draws triangles"}),
    "upside down": ("h = request['scene']['target']['height']; answer.pop('hits', None); "
                    "[f.update(y=h - 1 - f['y']) for f in answer.get('fragments', [])]",
                    {"draws line_strip", "draws triangles"}),
    "not a number": ("[f.update(color=['nan'] * 4) for f in answer.get('fragments', [])]",
                     {"tells finite values only"}),
    "deep": ("[f.update(depth=1.5) for f in answer.get('fragments', [])]",
             {"tells finite values only"}),
    "plain ids": ("request['id'].encode('ascii')", {"takes any character in an id"}),
    "strict request": ("assert set(request) <= {'edgecase', 'id', 'digest', 'scene', 'answer'}",
                       {"ignores an unknown key of the request"}),
    "lingers": ("__import__('atexit').register(__import__('time').sleep, 60)",
                {"ends when its input does"}),
    "bad end": ("__import__('atexit').register(os._exit, 9)", {"ends when its input does"}),
}


def between(before="pass", fault="pass"):
    return BETWEEN.replace("{before}", before).replace("{fault}", fault)


class Checks(CommandTest):
    def examine(self, renderer, expect):
        """name -> check."""
        self.command("backends", renderer, "--json", "checks.json", "--timeout", "20",
                     expect=expect)
        told = json.loads((self.folder / "checks.json").read_text(encoding="utf-8"))
        (told,) = told["renderers"]
        self.assertEqual(told["name"], renderer)
        self.assertEqual([check["number"] for check in told["checks"]],
                         list(range(1, len(told["checks"]) + 1)))
        self.assertEqual(sum(told["summary"].values()), len(told["checks"]))
        for check in told["checks"]:
            self.assertEqual(bool(check["finding"]), check["outcome"] != "pass", check)
            self.assertEqual(bool(check["remedy"]), check["outcome"] == "fail", check)
        return {check["name"]: check for check in told["checks"]}

    def program(self, text, *arguments):
        path = self.write("program.py", text)
        return "exec:" + " ".join(map(shlex.quote, [sys.executable, "-B", str(path), *arguments]))

    def test_the_examples_pass(self):
        outcomes = collections.Counter(c["outcome"] for c in self.examine(SMALL, AS_EXPECTED).values())
        self.assertEqual(set(outcomes), {"pass", "not supported"}, outcomes)
        if COUNT > 1:
            return  # the one in Python takes ten times as long
        checks = self.examine(LARGE, AS_EXPECTED)
        refused = {name for name, check in checks.items() if check["outcome"] == "not supported"}
        self.assertEqual(refused, {"draws or refuses wide lines", "draws or refuses supersampling"})

    def test_our_own_worker_passes(self):
        outcomes = {check["outcome"] for check in self.examine(WORKER, AS_EXPECTED).values()}
        self.assertEqual(outcomes, {"pass"})

    def test_as_text(self):
        run = self.command("backends", SMALL)
        self.assertIn("   1  pass           starts and answers\n", run.stdout)
        self.assertRegex(run.stdout, r"not supported  draws or refuses blending: this example")
        self.assertRegex(run.stdout, r"\d+ checks: \d+ pass, \d+ not supported, 0 fail\n")
        self.assertIn("bits claimed / measured", run.stdout)  # the table of probes comes, too
        (told,) = json.loads(self.command("backends", SMALL, "--json", "-").stdout)["renderers"]
        self.assertTrue(told["started"])

    def test_a_program_that_refuses_everything(self):
        refuses = """
            import json, sys
            for line in sys.stdin:
                print(json.dumps({"digest": json.loads(line)["digest"], "not_run": "no"}), flush=True)
            """
        checks = self.examine(self.program(textwrap.dedent(refuses)), AS_EXPECTED)
        self.assertNotIn("fail", {check["outcome"] for check in checks.values()})

    def test_each_fault_fails_its_check(self):
        for name, (fault, failing) in in_share(FAULTS.items()):
            with self.subTest(name):
                renderer = self.program(between(fault=fault), str(BIN / "edgecase-example"))
                failed = {check for check, told in self.examine(renderer, UNEXPECTED).items()
                          if told["outcome"] == "fail"}
                for words in failing:
                    self.assertTrue(any(words in check for check in failed), failed)

    def test_features_that_are_ignored(self):
        renderer = self.program(between(before=IGNORE.strip()), str(BIN / "edgecase-example"))
        checks = self.examine(renderer, UNEXPECTED)
        for feature in ("a depth buffer", "a stencil buffer", "several samples", "textures",
                        "blending", "a scissor", "culling", "a colour mask", "supersampling",
                        "wide lines", "large points", "perspective",
                        "vertices outside the clip volume", "colours that vary"):
            self.assertEqual(checks[f"draws or refuses {feature}"]["outcome"], "fail", feature)
        for what in ("key of the scene", "key of the target", "key of a draw", "key of a vertex"):
            self.assertEqual(checks[f"refuses an unknown {what}"]["outcome"], "fail", what)

    def test_programs_that_do_not_start(self):
        checks = self.examine(self.program("raise SystemExit(5)"), RENDERER)
        self.assertIn("exit status 5", checks["starts and answers"]["finding"])
        run = self.command("backends", "exec:/no/such/program", "--json", "-", expect=RENDERER)
        (told,) = json.loads(run.stdout)["renderers"]
        self.assertFalse(told["started"])
        (check,) = told["checks"]
        self.assertIn("No such file", check["finding"])


class Example(CommandTest):
    def test_nothing_is_charged(self):
        verdicts = collections.Counter()
        for case in self.results(*[f"{SUITE}/{folder}" for folder in FOLDERS], *SHARE, "--against",
                                 SMALL, expect=None)["cases"]:
            result = only_result(case)
            verdicts[result["verdict"]] += 1
            if result["verdict"] == "not-run":
                self.assertEqual(result["failure"]["kind"], "unsupported", case["id"])
                self.assertIn("this example", result["failure"]["reason"])
        self.assertEqual(set(verdicts), {"agree", "not-run"})
        self.assertGreater(verdicts["agree"], 200)

    def test_halfway_between_two_numbers_either_is_right(self):
        """The example in Python rounds as is right, and what is known of the exact value leaves it
        open which of two numbers that is."""
        cases = self.results(f"{SUITE}/values/interpolation/cancelling-values.json", "--against",
                             LARGE, expect=AS_EXPECTED)["cases"]
        self.assertEqual({only_result(case)["verdict"] for case in cases}, {"agree"})

    def test_its_command_is_that_of_its_readers(self):
        source = (ROOT / "reference" / "examples" / "rasterizer.cpp").read_text(encoding="utf-8")
        protocol = (ROOT / "reference" / "PROTOCOL.md").read_text(encoding="utf-8")
        line = "g++ -std=c++20 -O2 -o rasterizer reference/examples/rasterizer.cpp"
        self.assertIn(line, source)
        self.assertIn(line, protocol)
        subprocess.run([*line.replace("-O2 -o rasterizer", "-fsyntax-only").split()], cwd=ROOT,
                       check=True)


if __name__ == "__main__":
    unittest.main()
