# SPDX-License-Identifier: MIT
"""edgecase record, and recording:FILE: what was recorded is judged as the renderer itself is, and
nothing else is answered."""
import json
import pathlib
import signal
import subprocess
import time
import unittest

import results_file
from suite_data import COUNT, files_of_share, in_share
from support import (AS_EXPECTED, EDGECASE, INTERNAL, NOTHING_SELECTED, PATIENCE, RENDERER, SUITE,
                     UNEXPECTED, USAGE, CommandTest, environment, only_result, triangle_case)
# Some cases that both renderers draw as nothing allows, and some that they do not draw.
REMARKABLE = {pathlib.Path(SUITE, f"{name}.json")
              for name in ("lines/strips/diagonal-joint", "samples/counts/eight-lines",
                           "samples/counts/any-number")}


def renamed(text, recording, renderer):
    """The results of a recording, as those of the renderer would be."""
    results = results_file.parsed(text.replace(recording, renderer))
    for info in results["renderers"]:
        info["traits"].pop("recorded", None)
    return results


class Record(CommandTest):
    def record(self, renderer, *arguments, file="one.rec", expect=AS_EXPECTED):
        return self.command("record", "--against", renderer, "-o", file, *arguments, expect=expect)

    def results_text(self, renderer, *arguments, expect=None):
        self.command("run", *arguments, "--against", renderer, "--json", "results.json", "--junit",
                     "junit.xml", "--html", "report.html", expect=expect)
        return results_file.unpacked((self.folder / "results.json").read_bytes())

    def some(self):
        """Some cases of each folder but those of whole scenes. Of a share of the suite they stand
        alone: all cases, and what is expected of them, take longer to load than some to draw."""
        if COUNT == 1:
            return [SUITE, "--exclude", "scenes/*", "--sample", "5/100"]
        files = [file for file in files_of_share() if "scenes" not in file.parts]
        self.copy_cases({*files[2::4], *REMARKABLE})
        return ["cases"]

    def test_a_recording_is_judged_as_the_renderer_is(self):
        some = self.some()
        for renderer in in_share(("egl:llvmpipe", "egl:softpipe")):
            with self.subTest(renderer):
                self.record(renderer, *some)
                # Green: its known faults are those of the driver.
                live = results_file.parsed(self.results_text(renderer, *some, expect=AS_EXPECTED))
                text = self.results_text("recording:one.rec", *some, expect=AS_EXPECTED)
                (info,) = results_file.head_in(text.splitlines())["renderers"]
                self.assertEqual(info["traits"]["recorded"], renderer)
                replayed = renamed(text, "recording:one.rec", renderer)
                self.assertGreater(len(live["cases"]), 250)
                # Of the answer as it comes: a worker's are bytes, a recording's lines.
                for case in (*replayed["cases"], *live["cases"]):
                    only_result(case).pop("answer_digest", None)
                for ours, theirs in zip(replayed["cases"], live["cases"]):
                    self.assertEqual(json.dumps(ours), json.dumps(theirs))
                self.assertEqual(json.dumps(replayed), json.dumps(live))
                verdicts = {only_result(case)["verdict"] for case in live["cases"]}
                self.assertLessEqual({"violation", "agree", "not-run"}, verdicts)

    def test_the_same_whatever_the_number_of_threads(self):
        some = self.some()
        self.record("egl:llvmpipe", *some, "--jobs", "1")
        self.record("egl:llvmpipe", *some, "--jobs", "3", file="three.rec")
        one, three = (self.folder / name for name in ("one.rec", "three.rec"))
        self.assertEqual(one.read_bytes(), three.read_bytes())
        # A recording of a recording is the same again.
        self.record("recording:one.rec", *some, file="again.rec")
        self.assertEqual((self.folder / "again.rec").read_bytes(), one.read_bytes())

    def test_other_commands_take_it(self):
        case = f"{SUITE}/lines/short/between-diamonds.json"
        self.record("egl:softpipe", case)
        for command in (["explain", case, "--against"], ["render", case, "--with"]):
            live = self.command(*command, "egl:softpipe").stdout
            replayed = self.command(*command, "recording:one.rec").stdout
            self.assertEqual(replayed.replace("recording:one.rec", "egl:softpipe"), live)
        run = self.command("run", case, "--against", "recording:one.rec", "--json", "r.json",
                           "--junit", "j.xml", "--html", "r.html")
        self.assertRegex(run.stdout, r"recording:one.rec replays egl:softpipe \(softpipe, .*\), "
                                     r"whose known faults hold")
        self.command("report", "r.json", "--html", "again.html")
        self.assertIn("recording:one.rec", (self.folder / "again.html").read_text("utf-8"))
        bless = self.command("bless", "r.json", "--folder", f"{SUITE}/known")
        self.assertIn("softpipe.json: 0 changes", bless.stdout)
        profile = self.command("run", case, "--policy", "profile", "--against", "recording:one.rec",
                               "--json", "r.json", "--junit", "j.xml", "--html", "r.html",
                               expect=None)
        self.assertIn(profile.returncode, (AS_EXPECTED, UNEXPECTED))

    def test_what_has_to_ask_for_more_says_why_it_cannot(self):
        self.write_cases("a")
        self.record("exact")
        profile = self.command("profile", "cases", "--against", "recording:one.rec")
        self.assertRegex(profile.stdout, "fbo: [0-9]+ rules were asked; 1 of 1 drawings")
        profile = self.command("profile", f"{SUITE}/points", "--against", "recording:one.rec",
                               expect=RENDERER)
        self.assertIn("not measured: unavailable", profile.stdout)
        backends = self.command("backends", "recording:one.rec", expect=USAGE)
        self.assertIn("no program behind it", backends.stderr)

    def test_a_case_that_changed_and_one_that_is_new_are_not_run(self):
        self.write_cases("kept", "moved")
        self.record("egl:llvmpipe")
        changed = triangle_case(title="Triangle moved")
        changed["draws"][0]["vertices"][1] = [6.5, 1]
        self.write("cases/moved.json", changed)
        self.write_cases("new")
        # That the driver is known to crash is no excuse.
        self.write("cases/known/llvmpipe.json", {"driver": "llvmpipe", "faults": [
            {"id": "crash", "kind": "crashed", "cases": ["new"], "reason": "known"}]})
        results = results_file.parsed(self.results_text("recording:one.rec", expect=RENDERER))
        found = {case["id"]: only_result(case) for case in results["cases"]}
        self.assertEqual(found["kept"]["verdict"], "agree")
        self.assertIn("recorded from another scene: the case has changed since",
                      found["moved"]["failure"]["reason"])
        self.assertIn("not recorded", found["new"]["failure"]["reason"])
        self.assertEqual(found["new"]["standing"], "unexpected")
        self.assertEqual(found["moved"]["standing"], "unexpected")
        bless = self.command("bless", "results.json")
        self.assertNotIn("+ ", bless.stdout)

    def test_failures_are_recorded(self):
        self.write_cases("a", "b", "c")
        crash = self.odd_renderer("crash", "b", cases="cases")
        run = self.record(crash)
        self.assertIn("3 cases", run.stdout)
        self.assertIn("1 without a rendering", run.stdout)
        live = results_file.parsed(self.results_text(crash))
        name = json.dumps(crash)[1:-1]
        replayed = renamed(self.results_text("recording:one.rec"), "recording:one.rec", name)
        self.assertEqual(replayed, live)
        failures = [only_result(case).get("failure") for case in live["cases"]]
        self.assertEqual([f and f["kind"] for f in failures], [None, "crashed", None])

    def test_a_renderer_that_cannot_be_had_leaves_the_old_recording(self):
        self.write_cases("a")
        self.write("one.rec", "as it was")
        run = self.record("exec:/nonexistent/program", expect=RENDERER)
        self.assertIn("nothing was written", run.stderr)
        self.assertEqual((self.folder / "one.rec").read_text(), "as it was")
        self.record("egl:nothing", expect=USAGE)
        self.record("exact", "--filter", "b", expect=NOTHING_SELECTED)
        self.record("exact", file="cases/a.json/one.rec", expect=INTERNAL)
        self.record("exact")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["cases", "one.rec"])

    def test_a_damaged_recording_is_refused_in_one_sentence(self):
        self.write_cases("a")
        self.record("exact")
        path = self.folder / "one.rec"
        whole = path.read_bytes()
        middle = len(whole) // 2
        for damaged, why in (
                (whole[:-1], "its end is missing"),
                (whole[:middle], "its end is missing"),
                (b"", "it is no recording"),
                (b"{}\n", "it is no recording"),
                (whole.replace(b"recording 1", b"recording 7", 1), "it has version 7"),
                (whole[:middle] + bytes([whole[middle] ^ 64]) + whole[middle + 1:],
                 "not what was written")):
            path.write_bytes(damaged)
            for command in (["run"], ["explain", "cases/a.json"]):
                run = self.command(*command, "--against", "recording:one.rec", expect=USAGE)
                (line,) = run.stderr.splitlines()
                self.assertRegex(line, "the recording one.rec cannot be used: .*" + why)
        for name, why in (("missing.rec", "No such file"), ("cases", "cannot read"),
                          ("", "names no file")):
            run = self.command("run", "--against", f"recording:{name}", expect=USAGE)
            self.assertIn(why, run.stderr)

    def test_interrupted_it_keeps_what_was_finished(self):
        self.write_cases(*(f"case-{i:03}" for i in range(60)))
        slow = self.odd_renderer("nap", cases="cases")
        running = subprocess.Popen(
            [EDGECASE, "record", "--against", slow, "-o", "one.rec", "--jobs", "1"],
            cwd=self.folder, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True)
        self.addCleanup(running.kill)
        marks = self.folder / "truth.jsonl.marks"
        deadline = time.monotonic() + PATIENCE
        while not marks.exists() or marks.stat().st_size < 3:
            self.assertLess(time.monotonic(), deadline, "the renderer does not get going")
            time.sleep(.02)
        running.send_signal(signal.SIGINT)
        output, errors = running.communicate(timeout=PATIENCE)
        self.assertEqual(running.returncode, UNEXPECTED, errors)
        self.assertIn("incomplete", output)
        self.assertIn("interrupted", errors)
        results = results_file.parsed(self.results_text("recording:one.rec", expect=RENDERER))
        verdicts = [only_result(case)["verdict"] for case in results["cases"]]
        finished = verdicts.count("agree")
        self.assertGreaterEqual(finished, 2)
        self.assertEqual(verdicts, ["agree"] * finished + ["not-run"] * (60 - finished))
        self.assertIn("interrupted before this case",
                      only_result(results["cases"][-1])["failure"]["reason"])


if __name__ == "__main__":
    unittest.main()
