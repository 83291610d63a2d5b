# SPDX-License-Identifier: MIT
"""The journal of a run, FILE.unfinished: what a run that is killed had finished is gone on with, and
what somebody else has put there is believed only where the user names FILE."""
import os
import signal
import subprocess
import sys
import unittest

import results_file
from resume_test import NAMES, ResumeTest
from support import RENDERER, UNEXPECTED, USAGE

OUT = "out/results.zst"
JOURNAL = f"{OUT}.unfinished"
# Draws everything red, and takes its time while there is a file named "pause"; the case that its
# second word names is the death of it.
PROGRAM = """import json, os, sys, time
folder, victim = sys.argv[1:]
for line in sys.stdin:
    request = json.loads(line)
    if request["id"] == victim:
        sys.exit(7)
    with open(folder + "/truth.jsonl.marks", "ab") as marks:
        marks.write(b".")
    if os.path.exists(folder + "/pause"):
        time.sleep(.2)
    target = request["scene"]["target"]
    pixels = [255, 0, 0, 255] * (target["width"] * target["height"])
    print(json.dumps({"digest": request["digest"], "pixels": pixels, "fragments": [],
                      "renderer": {"device": "a device"}}), flush=True)
"""


class JournalTest(ResumeTest):
    def setUp(self):
        super().setUp()
        script = self.write("program.py", PROGRAM)
        self.program = f"mine=exec:{sys.executable} {script} {self.folder}"
        self.renderer = f"{self.program} none"
        self.journal = self.folder / JOURNAL

    def run_all(self, *arguments, expect=UNEXPECTED, **variables):
        return self.command("run", "cases", "--against", self.renderer, "--no-rerun", *arguments,
                            expect=expect, **variables).stderr

    def kill(self, *arguments):
        """A run that is killed when it has asked for some answers; how many it surely compared."""
        self.asked()
        pause = self.write("pause", "")
        code, _ = self.interrupt(self.renderer, signal.SIGKILL, "--no-rerun", *arguments)
        pause.unlink()
        self.assertEqual(code, -signal.SIGKILL)
        return self.asked() - 1

    def go_on(self, *arguments, expect=UNEXPECTED, **variables):
        """The standard error of a run that goes on with the one that was killed."""
        return self.run_all("--resume", *arguments, expect=expect, **variables)

    def read_journal(self):
        text = results_file.unpacked(self.journal.read_bytes())
        return results_file.parsed(text + '{"end": true, "cases": 0}\n')

    def held(self):
        return [case["id"] for case in self.read_journal()["cases"]]

    def check_whole(self, expect=UNEXPECTED):
        self.assertFalse(self.journal.exists())
        resumed = (self.folder / OUT).read_bytes()
        self.run_all("--ask-all", "--json", "whole.zst", expect=expect)
        self.assertEqual(resumed, (self.folder / "whole.zst").read_bytes())


class GoneOnWith(JournalTest):
    def test_at_most_the_case_at_hand_is_lost(self):
        compared = self.kill()
        self.assertFalse((self.folder / OUT).exists())
        held = self.held()
        self.assertEqual(held, NAMES[:len(held)])
        self.assertIn(len(held), (compared, compared + 1))
        self.assertEqual(self.go_on(), f"edgecase: {len(held)} of 8 cases are taken over from "
                                       f"{JOURNAL}\n")
        self.assertEqual(self.asked(), 8 - len(held) + 1)  # one to learn what the renderer is
        self.check_whole()

    def test_killed_twice(self):
        first = self.kill()
        self.kill("--resume")
        held = self.held()
        self.assertGreater(len(held), first)
        self.assertEqual(sorted(set(held)), sorted(held))
        self.go_on()
        self.check_whole()

    def test_a_frame_that_is_torn(self):
        self.kill()
        held = len(self.held())
        whole = self.journal.read_bytes()
        for torn in (whole[:-1], whole[:-36], whole[:-40], whole[:-41], whole + b"\0" * 100,
                     whole + whole[:20]):
            self.journal.write_bytes(torn)
            left = held if torn.startswith(whole) else held - 1
            self.assertIn(f"{left} of 8 cases ", self.go_on())
            self.check_whole()

    def test_nothing_was_finished(self):
        """Then what lies there is of an earlier run, and that is not gone on with."""
        self.run_all()
        self.journal.write_bytes(b"")
        self.asked()
        self.assertEqual(self.go_on(), "")
        self.assertEqual(self.asked(), 8)
        self.check_whole()

    def test_a_run_that_ends_leaves_none(self):
        for arguments in [], ["--max-failures", "1"], ["--shard", "1/2"]:
            self.kill()
            self.assertTrue(self.journal.exists())
            self.run_all(*arguments)
            self.assertFalse(self.journal.exists())

    def test_what_a_renderer_is_becomes_known_late(self):
        """A case is finished already."""
        self.renderer = f"{self.program} case-0"
        self.kill()
        read = self.read_journal()
        self.assertIn("failure", read["cases"][0]["results"]["mine"])
        self.assertEqual(read["renderers"][0]["device"], "a device")
        self.go_on(expect=RENDERER)
        self.check_whole(expect=RENDERER)

    def test_other_files_have_none(self):
        for path in "-", "/dev/null":
            self.command("run", "cases", "--against", "exact", "--json", path)
        self.assertFalse([name for name in os.listdir("/dev") if "unfinished" in name])


class Believed(JournalTest):
    def forge(self):
        """A journal with what the results in out/ say, and a number that is none of theirs."""
        results = results_file.read(self.folder / OUT)
        results["cases"][5]["fragments"] = 99
        text = results_file.text_of(results)
        lines = "".join(f"{line}\n" for line in text.splitlines()[:-1])
        return subprocess.run(["zstd", "-q"], input=lines.encode(), capture_output=True,
                              check=True).stdout

    def check_refused(self, reason, path=JOURNAL, project="", **variables):
        self.assertEqual(
            self.go_on(expect=USAGE, **variables),
            f"{project}edgecase: --resume does not go on with {path}, which nobody has named: {reason}; if "
            f"you trust it, name the results with --json {OUT}, or else remove it\n")

    def test_what_no_run_of_the_user_wrote(self):
        self.run_all()
        self.kill()
        held = len(self.held())
        own = self.journal.read_bytes()
        forged = self.forge()
        for content in forged, forged + own, own[:-40] + forged, own + forged + own[-40:]:
            self.journal.write_bytes(content)
            self.check_refused("it is not as a run of yours wrote it")
        # A last frame without its code counts as torn.
        self.journal.write_bytes(own + forged)
        self.assertIn(f"{held} of 8 cases ", self.go_on())
        self.check_whole()

    def test_who_names_the_results_is_believed(self):
        self.run_all()
        self.journal.write_bytes(self.forge())
        self.assertIn("8 of 8 cases are taken over", self.go_on("--json", OUT))
        # Nobody else is: what comes of it is not the user's own.
        self.check_refused("it is not as a run of yours wrote it", OUT)

    def test_in_ci_and_with_another_key(self):
        self.kill()
        self.check_refused("CI is set", CI="1")
        self.check_refused("it is not as a run of yours wrote it",
                           XDG_CACHE_HOME=str(self.folder / "cache"))
        held = len(self.held())
        told = self.go_on("--json", OUT, CI="1", XDG_CACHE_HOME=str(self.folder / "cache"))
        self.assertIn(f"{held} of 8 cases are taken over", told)
        self.check_whole()

    def test_results_without_a_journal(self):
        self.run_all()
        results = self.folder / OUT
        results.write_text(results_file.text_of(results_file.read(results)), "utf-8")
        self.check_refused("it is not as a run of yours wrote it", OUT)
        self.assertIn("8 of 8 cases are taken over", self.go_on("--json", OUT))

    def test_a_project_does_not_name(self):
        file = self.write("edgecase.toml", f'[outputs]\njson = "{OUT}"\n')
        self.kill()
        self.check_refused("CI is set", project=f"edgecase: the project is {file}\n", CI="1")

    def test_a_link_is_replaced(self):
        victim = self.write("victim", "untouched")
        self.journal.parent.mkdir()
        self.journal.symlink_to(victim)
        self.kill()
        self.assertEqual(victim.read_text("utf-8"), "untouched")
        self.assertFalse(self.journal.is_symlink())
        self.go_on()
        self.check_whole()


if __name__ == "__main__":
    unittest.main()
