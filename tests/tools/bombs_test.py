# SPDX-License-Identifier: MIT
"""Small files that unpack to very much, lines and texts without end, paths that lead elsewhere:
each is refused in a second and 200 MB, with one message, and nothing else is lost."""
import json
import os
import shlex
import subprocess
import sys
import unittest
import zlib

import results_file
from support import (AS_EXPECTED, EDGECASE, NOTHING_DRAWN, PATIENCE, RENDERER, USAGE, CommandTest,
                     environment, only_result, processes_that_mention, triangle_case)

MOST_SECONDS = 1 * PATIENCE / 1200  # of processors, of the command and what it waits for
PLAIN_RUNS = 20  # that take as long as that, where nothing else is done
MOST_BYTES = 200 << 20
SANITIZED = PATIENCE > 1200  # whose memory is not its own
MILLION = 1_000_000
# Runs a command, and prints its exit code, seconds and kilobytes before what it printed itself. A
# process of its own, because memory counts from where a process is forked.
MEASURE = """
import resource, subprocess, sys
run = subprocess.run(sys.argv[1:], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(run.returncode, used.ru_utime + used.ru_stime, used.ru_maxrss, flush=True)
sys.stdout.buffer.write(run.stdout)
"""


class Bombs(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases("a", "b")

    def costs_little(self, *arguments, expect=USAGE, **variables):
        """What the command prints, on both streams, where it took little time and memory."""
        run = self.command("-c", MEASURE, EDGECASE, *arguments, program=sys.executable,
                           **variables)
        cost, _, text = run.stdout.partition("\n")
        code, seconds, kilobytes = map(float, cost.split())
        text += run.stderr
        self.assertEqual(code, expect, text[:2000])
        self.assertLess(len(text), 5000)
        if seconds >= MOST_SECONDS:  # on a machine that is busy with other things, perhaps
            self.assertLess(seconds, PLAIN_RUNS * self.cost_of_a_plain_run())
        if not SANITIZED:
            self.assertLess(1024 * kilobytes, MOST_BYTES)
        return text

    def cost_of_a_plain_run(self):
        """Seconds of processors, now, of a run of a case without anything strange."""
        (self.folder / "plain").mkdir(exist_ok=True)
        self.write("plain/plain.json", triangle_case())
        run = self.command("-c", MEASURE, EDGECASE, "run", "plain", "--against", "exact",
                           "--json", "plain.zst", "--html", "plain.html", program=sys.executable)
        return float(run.stdout.split()[1])

    def refused(self, words, *arguments, **variables):
        text = self.costs_little(*arguments, expect=USAGE, **variables)
        self.assertIn(words, text)
        self.assertEqual(text.count("\n"), 1, text)
        return text

    def renderer(self, body):
        """exec: name of a program that answers each request by `answer(digest, out)`."""
        program = self.write("program.py", f"import json, os, subprocess, sys\n{body}\n"
                             "for line in sys.stdin:\n"
                             "    answer(json.loads(line)['digest'], sys.stdout)\n"
                             "    print(flush=True)\n")
        return "exec:" + " ".join(map(shlex.quote, (sys.executable, str(program))))


class Packed(Bombs):
    """Results of a few kilobytes."""

    def setUp(self):
        super().setUp()
        wrong = self.odd_renderer("black", "", "cases")
        self.whole = self.results("cases/a.json", "--against", wrong, "--no-rerun", expect=None)

    def packed(self, text):
        path = self.folder / "bomb.zst"
        path.write_bytes(subprocess.run(["zstd", "-q"], input=text.encode(), capture_output=True,
                                        check=True).stdout)
        self.assertLess(path.stat().st_size, 20_000)
        return path

    def report_of(self, results):
        return ["report", self.packed(results_file.text_of(results)), "--csv", "found.csv"]

    def test_a_line_of_very_many_values(self):
        text = '{"edgecase_results": 2, "tool": [' + "0," * 32 * MILLION + "0]}\n"
        self.refused("unpack to more than", "report", self.packed(text))

    def test_a_window_of_a_gigabyte(self):
        path = self.folder / "window.zst"
        path.write_bytes(subprocess.run(["zstd", "-q", "--ultra", "--long=31"],
                                        input=b'{"edgecase_results": 2}\n' * 100,
                                        capture_output=True, check=True).stdout)
        self.refused("no results file", "report", path)

    def test_places_fragments_and_samples_beyond_any_case(self):
        (case,) = self.whole["cases"]
        case["width"] = case["height"] = 4096
        ((name, result),) = case["results"].items()
        result.pop("pixels", None)
        places = " ".join(f"y{y} 0+4096*4096" for y in range(1000))
        fragment = [[0, 4096], 0, 0, 1, 0.5, [0, 0, 0, 1]]
        samples = {"count": 16, "pixels": f"0*{1 << 28}", "hits": f"0*{1 << 28}"}
        values = {"attribute": "color", "rule": "triangle.fill-rule", "compared": 1,
                  "components": 4, "worst": [0, 0, 0], "worst_component": 0, "worst_exact": 0,
                  "worst_rendered": 0, "worst_ulp": 1, "mean_ulp": 1, "worst_relative": 0,
                  "ulp_histogram": {}, "differing": places}
        del case["pixels"]
        for change, words in (({"values": [values] * 8}, "values differ at more than"),
                              ({"exact_fragments": [fragment] * 4096}, "more fragments"),
                              ({"samples": samples}, "with 16 samples")):
            with self.subTest(words):
                case["results"] = {name: {**result, **change}}
                self.refused(words, *self.report_of(self.whole))

    def test_pictures_of_one_colour_take_no_memory(self):
        """Legal, and therefore read."""
        (case,) = self.whole["cases"]
        result = only_result(case)
        case["width"] = case["height"] = 4096
        case["pixels"] = f"ff*1 0*{(1 << 24) - 1}"
        result["pixels"] = f"ff00*{1 << 24}"
        result["exact_pixels"] = f"ff0000*{1 << 24}"
        self.costs_little(*self.report_of(self.whole), expect=AS_EXPECTED)

    def test_a_reason_without_end(self):
        (case,) = self.whole["cases"]
        ((name, result),) = case["results"].items()
        case["results"] = {name: {**result, "verdict": "not-run", "failure": {
            "kind": "unsupported", "reason": 4 * MILLION * "r"}}}
        path = self.packed(results_file.text_of(self.whole))
        self.assertIn("bytes more", self.costs_little("merge", path, "-o", "r.zst",
                                                      expect=NOTHING_DRAWN))

    def test_very_many_renderers_and_shards(self):
        info = self.whole["renderers"][0]
        self.whole["renderers"] = [{**info, "name": f"exec:{i}"} for i in range(20_000)]
        self.refused("20000 renderers", "report", self.write_results("many.json", self.whole))
        named = [f"--against=n{i}=exec:true" for i in range(20_000)]
        self.refused("20000 renderers", "run", "cases", *named)
        self.whole["renderers"] = [info]
        for count, words in ((2147483647, "no share 1 of 2147483647"),
                             (MILLION, "and 999979 more")):
            self.whole["shard"] = {"index": 1, "count": count, "cases": count, "selection": ""}
            self.refused(words, "merge", self.write_results("shard.json", self.whole))
        self.assertIn("1/2147483647", self.costs_little("run", "cases", "--shard", "1/2147483647"))


def size(number):
    out = bytearray()
    while number > 127:
        out.append(number & 127 | 128)
        number >>= 7
    return bytes(out) + bytes([number])


def stretch(data):
    packed = zlib.compress(data, 9 if len(data) < 1 << 20 else 1)
    return size(len(data)) + size(len(packed)) + packed


class Recordings(Bombs):
    def setUp(self):
        super().setUp()
        self.command("record", "cases/a.json", "--against", "exact", "-o", "good.rec")
        data = (self.folder / "good.rec").read_bytes()
        at = len(data) - 26 - int(data[-26:-10], 16)
        rest = data[at:-26].lstrip()
        while True:  # behind the two sizes
            try:
                self.index = json.loads(zlib.decompress(rest))
                break
            except zlib.error:
                rest = rest[1:]
        self.head = data[:self.index["head"]["size"]]

    def bomb(self, block, index=None):
        index = stretch(index or json.dumps({**self.index, "blocks": [{
            **self.index["blocks"][0], "size": len(block), "crc": zlib.crc32(block)}]}).encode())
        path = self.folder / "bomb.rec"
        path.write_bytes(self.head + block + index +
                         f"{len(index):016x} {zlib.crc32(index):08x}\n".encode())
        self.assertLess(path.stat().st_size, MILLION)
        return f"recording:{path}"

    def test_answers_that_are_longer_than_their_scene_can_need(self):
        marks = b"[" + b"#" * 64 * MILLION + b"]\n"
        column = b"\0" + stretch(bytes(16 * MILLION))
        for block in (stretch(marks) + size(1) + column, stretch(b"\n" * 64 * MILLION) + size(0),
                      stretch(b"[#]\n") + size(1) + column):
            text = self.costs_little("run", "cases/a.json", "--against", self.bomb(block),
                                     "--no-rerun", "--json", "r.json", expect=RENDERER)
            self.assertIn("garbage", text)

    def test_an_index_of_very_many_values(self):
        for index in (b"[" + b"0," * 8 * MILLION + b"0]", b"[" * MILLION, b" " * 64 * MILLION):
            self.assertIn("cannot be used", self.costs_little(
                "run", "cases/a.json", "--against", self.bomb(b"", index), "--no-rerun",
                expect=USAGE))


class Programs(Bombs):
    def ran(self, body, expect=RENDERER):
        text = self.costs_little("run", "cases", "--against", self.renderer(body), "--no-rerun",
                                 "--json", "r.json", "--html", "r.html", expect=expect)
        self.assertLess((self.folder / "r.json").stat().st_size, 20_000)
        self.assertLess((self.folder / "r.html").stat().st_size, 2 * MILLION)
        return text, results_file.read(self.folder / "r.json")

    def test_lines_without_end(self):
        for body in ("for i in range(200): out.write(1000000 * 'x')",
                     "out.write('[' * 8000000)",
                     "out.write('{\"a\":' * 1500000)"):
            text, results = self.ran(f"def answer(digest, out):\n    {body}")
            self.assertIn("garbage", text)
            self.assertEqual({only_result(case)["failure"]["kind"] for case in results["cases"]},
                             {"garbage"})

    def test_what_goes_on_behind_an_answer(self):
        """The request is not read to its end, so that it cannot be followed by another."""
        self.write("cases/large.json", triangle_case(
            textures=[{"size": [512, 512], "checker": {"cell": 4}}],
            draws=[{"primitive": "triangles", "state": {"texture": 0, "interpolation": "smooth"},
                    "vertices": [{"at": [1, 1], "uv": [0, 0]}, {"at": [6.25, 1], "uv": [1, 0]},
                                 {"at": [1, 6], "uv": [0, 1]}]}]))
        program = self.write("flood.py", "import os\nos.write(1, b'{}\\n')\n"
                             "while True: os.write(1, bytes(1 << 16))")
        self.costs_little("run", "cases/large.json", "--against",
                          f"exec:{sys.executable} {program}", "--no-rerun", expect=RENDERER)

    def test_reasons_and_claims(self):
        text, results = self.ran("""
def answer(digest, out):
    claims = {key: 1000000 * "v" for key in ("vendor", "version", "device")}
    claims["traits"] = {"line_widths": 1000000 * "t"}
    json.dump({"digest": digest, "not_run": 1000000 * "r", "renderer": claims}, out)""",
                                 expect=NOTHING_DRAWN)
        self.assertIn(100 * "r", text)
        self.assertLess(len(text), 5000)
        self.assertEqual(results["renderers"][0]["vendor"], 1000 * "v" + "... (999000 bytes more)")

    def test_very_many_traits(self):
        text, _ = self.ran("""
def answer(digest, out):
    traits = {str(i): "" for i in range(20000)}
    json.dump({"digest": digest, "not_run": "r", "renderer": {"traits": traits}}, out)""")
        self.assertIn("20000 traits", text)

    def test_nothing_that_was_started_outlives_the_run(self):
        mark = f"edgecase-orphan-{os.getpid()}"
        sleep = [sys.executable, "-c", "import time; time.sleep(600)", mark]
        self.ran(f"""
subprocess.Popen({sleep!r}, start_new_session=True)
subprocess.run([sys.executable, "-c",
                "import subprocess; subprocess.Popen({sleep!r}, start_new_session=True)"])
def answer(digest, out):
    json.dump({{"digest": digest, "not_run": "r"}}, out)""", expect=NOTHING_DRAWN)
        left = processes_that_mention(mark)
        for process in left:
            os.kill(process, 9)
        self.assertEqual(left, [])

    def test_what_others_started_stays(self):
        """A child of the shell that then becomes the command is no renderer's."""
        mark = f"edgecase-stranger-{os.getpid()}"
        renderer = self.renderer("def answer(digest, out):\n"
                                 "    json.dump({'digest': digest, 'not_run': 'r'}, out)")
        stranger = shlex.join([sys.executable, "-c", "import time; time.sleep(600)", mark])
        command = shlex.join([EDGECASE, "run", "cases", "--against", renderer])
        run = subprocess.run(["sh", "-c", f"{stranger} & exec {command}"], cwd=self.folder,
                             env=environment(), stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, check=False)
        left = processes_that_mention(mark)
        for process in left:
            os.kill(process, 9)
        self.assertEqual(run.returncode, NOTHING_DRAWN)
        self.assertEqual(len(left), 1)


class Documents(Bombs):
    def test_projects(self):
        for text, words in (("a" + ".a" * 100_000 + " = 1", "larger than 65536 bytes"),
                            ("a" + ".a" * 30_000 + " = 1", "more than 2000 dots"),
                            ("a = " + "[" * 60_000, "edgecase.toml")):
            self.write("edgecase.toml", text)
            self.assertIn(words, self.costs_little("run", "cases", "--against", "exact"))

    def test_nested_and_large_json(self):
        nested = "[" * MILLION
        for name, options in (("cases/n.json", ["cases/n.json"]),
                              ("known.json", ["cases", "--known", "known.json"]),
                              ("policy.json", ["cases", "--policy", "policy.json"])):
            for text in (nested, "[" + "0," * 4 * MILLION + "0]", " " * 20 * MILLION):
                self.write(name, text)
                self.assertIn(name, self.costs_little("run", *options, "--against", "exact"))

    def test_links_out_of_the_suite(self):
        self.write("secret", '{"password": "abcd"}')
        for secret in (self.folder / "secret", "/proc/kmsg", "/etc/shadow"):
            for name, command in (("cases/link.json", ["validate", "cases"]),
                                  ("cases/link.json", ["validate", "cases/link.json"]),
                                  ("cases/known/link.json", ["run", "cases"]),
                                  ("cases/policies/link.json",
                                   ["run", "cases", "--policy", "link"])):
                with self.subTest(f"{secret} {command}"):
                    link = self.folder / name
                    link.parent.mkdir(exist_ok=True)
                    link.symlink_to(secret)
                    text = self.costs_little(*command, expect=USAGE)
                    self.assertIn("link", text)
                    self.assertNotIn("password", text)
                    link.unlink()
        # The same file of another checkout, as build systems link it.
        self.write("other/cases/c.json", triangle_case())
        (self.folder / "cases/c.json").symlink_to(self.folder / "other/cases/c.json")
        self.command("validate", "cases")

    def test_files_of_the_system(self):
        os.mkfifo(self.folder / "cases/pipe.json")
        self.assertIn("no regular file", self.costs_little("validate", "cases"))
        (self.folder / "cases/pipe.json").unlink()
        (self.folder / "cases/known").mkdir()
        os.mkfifo(self.folder / "cases/known/pipe.json")
        self.assertIn("no regular file", self.costs_little("run", "cases", "--against", "exact"))

    def test_results_that_are_a_file_of_the_system(self):
        (self.folder / "out").mkdir()
        for link in ("out/results.zst", "other.zst"):
            (self.folder / link).symlink_to("/proc/kmsg")
        self.assertIn("it is empty", self.costs_little("report", "other.zst"))
        self.costs_little("run", "cases", "--against", "exact", "--csv", "f.csv",
                          expect=AS_EXPECTED)
        self.costs_little("run", "cases", "--against", "exact", "--last-failed")

    def test_a_log_obeys_nobody(self):
        title = "##[error]title"
        self.write("cases/spoken.json", triangle_case(
            title=title, why="why\n::error::one\n \u00a0::set-output name=a::b\n##[group]two",
            expect=[{"policy": "##[error]policy", "coverage": ["#" * 8] * 8}]))
        self.write("odd/::error::.json", triangle_case())
        renderer = self.renderer("""
def answer(digest, out):
    text = "\\n::error::three\\n##[error]four"
    claims = {key: text for key in ("vendor", "version", "device")}
    json.dump({"digest": digest, "not_run": text, "renderer": claims}, out)""")
        against = ["--against", renderer]
        for command in (["explain", "cases/spoken.json", "--pixel", "1,1", *against],
                        ["run", "cases", *against, "--json", "r.json"], ["validate", "cases"],
                        ["backends", renderer], ["render", "cases", "--with", renderer],
                        ["report", "r.json", "--csv", "-"], ["bless", "r.json"]):
            run = self.command(*command, expect=None)
            for line in (run.stdout + run.stderr).splitlines():
                self.assertFalse(line.strip().startswith("::"), (command, line))
                self.assertNotIn("##[", line, command)


class Outputs(Bombs):
    def test_onto_what_is_read(self):
        known = self.write("cases/known/exact.json", {"driver": "exact", "faults": []})
        policy = self.write("cases/policies/p.json", {"name": "p", "latitude": "none", "rules": {}})
        case = self.folder / "cases/a.json"
        os.link(case, self.folder / "twin.json")
        (self.folder / "away").symlink_to("cases")
        before = {path: path.read_bytes() for path in (known, policy, case)}
        run = ["run", "cases", "--against", "exact"]
        for option in ("--json", "--junit", "--timings"):
            for path in ("cases/a.json", "twin.json", "away/../cases/./a.json", "away/a.json",
                         known, policy):
                self.refused(f"{option} would replace", *run, option, path)
        for command in (["explain", "cases/a.json", "--pixel", "1,1", "--svg"],
                        ["record", "cases", "--against", "exact", "-o"],
                        ["render", "cases", "--json"],
                        ["minimize", "cases/a.json", "--against", "exact", "-o"]):
            self.refused("would replace", *command, "cases/a.json")
        self.assertEqual({path: path.read_bytes() for path in before}, before)

    def test_two_onto_one(self):
        (self.folder / "away").symlink_to("out")
        run = ["run", "cases", "--against", "exact"]
        for other in ("out/x", "./out/../out/x", self.folder / "out/x", "away/x"):
            self.refused("same file", *run, "--json", "out/x", "--html", other)
            (self.folder / "out").mkdir(exist_ok=True)
        self.assertEqual(list((self.folder / "out").iterdir()), [])
        self.command(*run, "--json", "/dev/null", "--html", "/dev/null")
        self.command(*run, "--json", "r.zst")
        self.command("report", "r.zst", "--json", "r.zst", "--html", "r.html")
        self.refused("would replace", "report", "r.zst", "--html", "r.zst")


if __name__ == "__main__":
    unittest.main()
