# SPDX-License-Identifier: MIT
"""Where results are written: disks that are full, folders and files that take nothing, two runs in
one folder. What was there before is whole or replaced as a whole, the exit code is 3, and one
message names the file and what to do."""
import contextlib
import fcntl
import os
import resource
import signal
import stat
import subprocess
import time
import unittest

import results_file
from support import (AS_EXPECTED, EDGECASE, INTERNAL, PATIENCE, UNEXPECTED, CommandTest, contents,
                     environment, report_options, triangle_case, verdicts)

NAMES = ["a", "b", "c"]
REPORTS = ("json", "junit", "html", "ctrf", "markdown", "annotations", "csv")
RUN = ["run", "cases", "--against", "exact"]
EARLIER = "what was there before\n"
NOISE = """import json, os, sys
for line in sys.stdin:
    request = json.loads(line)
    target = request["scene"]["target"]
    pixels = list(os.urandom(4 * target["width"] * target["height"]))
    print(json.dumps({"digest": request["digest"], "pixels": pixels, "fragments": []}), flush=True)
"""


def may_mount():
    """Can a test have a file system of its own?"""
    return subprocess.run(["unshare", "--mount", "--map-root-user", "mount", "-t", "tmpfs", "none",
                           "/mnt"], capture_output=True).returncode == 0


class StorageTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)

    def start(self, *arguments, **more):
        running = subprocess.Popen([EDGECASE, *map(str, arguments)], cwd=self.folder, text=True,
                                   env=environment(), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, **more)
        self.addCleanup(running.stderr.close)
        self.addCleanup(running.kill)
        return running

    def parts(self):
        return [path for path in self.folder.rglob(".*.part")]


class Full(StorageTest):
    def limited(self, *arguments, most=100):
        """The standard error of the command, which may write files of so many bytes."""
        running = self.start(*arguments, preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (most, most)))
        _, errors = running.communicate(timeout=PATIENCE)
        self.assertEqual(running.returncode, INTERNAL, errors)
        self.assertEqual(self.parts(), [])
        return errors

    def test_a_device_that_is_full_costs_no_other_file(self):
        renderer = self.odd_renderer("mirror", "", "cases")
        wrong = ["run", "cases", "--against", renderer, "--no-rerun"]
        for kind in REPORTS:
            with self.subTest(kind):
                out = self.folder / kind
                others = [word for other in REPORTS if other != kind
                          for word in (f"--{other}", out / f"report.{other}")]
                run = self.command(*wrong, f"--{kind}", "/dev/full", *others, expect=INTERNAL)
                self.assertEqual(run.stderr, "edgecase: cannot write /dev/full: No space left on "
                                             "device; make room there, or name a file elsewhere\n")
                self.assertEqual(sorted(contents(out)), sorted(
                    f"report.{other}" for other in REPORTS if other != kind))

    def test_what_was_there_stays(self):
        for kind in ("json", "junit", "html"):
            with self.subTest(kind):
                path = self.write(f"out/report.{kind}", EARLIER)
                errors = self.limited(*RUN, f"--{kind}", path)
                self.assertEqual(errors, f"edgecase: cannot write {path}: File too large; make "
                                         "room there, or name a file elsewhere\n")
                self.assertEqual(path.read_text("utf-8"), EARLIER)

    def test_a_run_finds_more_than_there_is_room_for(self):
        """A little is kept without a file."""
        self.write("noise.py", NOISE)
        for n in range(40):
            self.write(f"many/{n}.json", triangle_case(target={"width": 64, "height": 64}))
        noisy = ["--against", "exec:python3 noise.py", "--no-rerun", "--json", "results.json"]
        self.command("run", "cases", *noisy, expect=UNEXPECTED, TMPDIR="nowhere")
        self.write("results.json", EARLIER)
        run = self.command("run", "many", *noisy, expect=INTERNAL, TMPDIR="nowhere")
        self.assertEqual(run.stderr, "edgecase: results cannot be kept in nowhere: No such file or "
                                     "directory; name a folder that has room in TMPDIR\n")
        self.assertEqual((self.folder / "results.json").read_text("utf-8"), EARLIER)

    def test_other_subcommands(self):
        self.command(*RUN, "--json", "results.json")
        renderer = self.odd_renderer("refuse", "c", "cases")
        self.command("record", "cases", "--against", renderer, "-o", "out")
        for arguments in (["render", "cases", "--json", "out"],
                          ["report", "results.json", "--html", "out"],
                          ["compare", "results.json", "results.json", "--json", "out"],
                          ["record", "cases", "--against", renderer, "-o", "out"]):
            with self.subTest(arguments[0]):
                self.write("out", EARLIER)
                errors = self.limited(*arguments, most=16)
                self.assertIn("cannot write out: File too large; make room there", errors)
                self.assertEqual((self.folder / "out").read_text("utf-8"), EARLIER)

    def test_pictures(self):
        wrong = self.odd_renderer("mirror", "", "cases")
        self.results("cases", "--against", wrong, expect=UNEXPECTED)
        for arguments in (["render", "cases", "--png", "pictures", "--scale", "16"],
                          ["run", "cases", "--against", wrong, "--triptychs", "pictures"]):
            errors = self.limited(*arguments, most=64)
            self.assertRegex(errors, r"cannot write pictures/\S+\.png: File too large")
            left = [path for path in (self.folder / "pictures").rglob("*") if path.is_file()]
            self.assertEqual(left, [])

    @unittest.skipUnless(may_mount(), "no file system can be mounted here")
    def test_a_small_file_system(self):
        """It has room for what was there, and not for what comes beside it; and it is read only."""
        (self.folder / "out").mkdir()
        for fault, state in (("No space left on device; make room there", "size=4k"),
                             ("Read-only file system; name a file that may be written", "ro")):
            script = (f"mount -t tmpfs -o size=4k none out && printf '{EARLIER}' > out/results.json"
                      f" && mount -o remount,{state} out && {{ {EDGECASE} run cases --against exact"
                      " --json out/results.json --junit junit.xml; echo $? > code; ls -A out > left"
                      "; cat out/results.json > kept; }")
            run = subprocess.run(["unshare", "--mount", "--map-root-user", "sh", "-c", script],
                                 cwd=self.folder, env=environment(), capture_output=True, text=True)
            self.assertIn(f"edgecase: cannot write out/results.json: {fault}", run.stderr)
            told = [(self.folder / name).read_text("utf-8") for name in ("code", "left", "kept")]
            self.assertEqual(told, [f"{INTERNAL}\n", "results.json\n", EARLIER])
            self.assertIn("</testsuites>", (self.folder / "junit.xml").read_text("utf-8"))


class Replaced(StorageTest):
    @unittest.skipUnless(may_mount(), "needs a file system of its own")
    def test_a_folder_that_may_not_be_written(self):
        """The reason is told, and not that a file which nobody made is missing."""
        out = self.folder / "out"
        out.mkdir()
        script = 'mount -t tmpfs -o ro none "$1" && shift && exec "$@"'
        run = subprocess.run(["unshare", "--mount", "--map-root-user", "sh", "-c", script, "sh",
                              out, EDGECASE, *RUN, "--json", "out/new/results.json"],
                             cwd=self.folder, capture_output=True, text=True, env=environment())
        self.assertEqual(run.returncode, INTERNAL)
        self.assertEqual(run.stderr, "edgecase: cannot write out/new/results.json: Read-only file "
                                     "system; name a file that may be written\n")

    def test_links_and_permissions_stay(self):
        path = self.write("kept/results.json", EARLIER)
        path.chmod(0o640)
        (self.folder / "link.json").symlink_to("kept/results.json")
        self.command(*RUN, "--json", "link.json")
        self.assertTrue((self.folder / "link.json").is_symlink())
        self.assertEqual(stat.S_IMODE(path.stat().st_mode), 0o640)
        results = results_file.read(path)
        self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "agree"))
        self.assertEqual([entry.name for entry in path.parent.iterdir()], ["results.json"])

    def test_new_files_have_the_usual_permissions(self):
        before = os.umask(0o027)
        self.addCleanup(os.umask, before)
        self.command(*RUN, "--json", "results.json")
        mode = (self.folder / "results.json").stat().st_mode
        self.assertEqual(stat.S_IMODE(mode), 0o640)

    def test_names_as_long_as_they_may_be(self):
        name = "x" * 250 + ".json"
        self.command(*RUN, "--json", name)
        self.assertTrue((self.folder / name).exists())


class OneFolder(StorageTest):
    @contextlib.contextmanager
    def blocked_run(self, *arguments):
        """A run that has written all its files but the last, a pipe that nobody reads yet."""
        os.mkfifo(self.folder / "out/pipe")
        running = self.start(*RUN, *arguments, "--csv", "out/pipe")
        yield running
        (self.folder / "out/pipe").read_text("utf-8")
        running.communicate(timeout=PATIENCE)

    def wait_for(self, path):
        deadline = time.monotonic() + PATIENCE
        while not path.exists():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(.02)

    def test_a_second_run_waits_for_the_first(self):
        out = self.folder / "out"
        out.mkdir()
        with self.blocked_run("--json", "out/results.json", "--no-latitude") as first:
            self.wait_for(out / "results.json")
            written = (out / "results.json").read_bytes()
            second = self.start(*RUN, "--json", "out/results.json")
            self.assertEqual(second.stderr.readline(),
                             "edgecase: another command writes into out; waiting\n")
            self.assertEqual((out / "results.json").read_bytes(), written)
        self.assertEqual(first.returncode, AS_EXPECTED)
        self.assertEqual(second.wait(timeout=PATIENCE), AS_EXPECTED)
        self.assertEqual(results_file.parsed(results_file.unpacked(written))["latitude"], "none")
        results = results_file.read(out / "results.json")
        self.assertEqual(results["latitude"], "opengl")

    def test_a_lock_ends_with_its_process(self):
        (self.folder / "out").mkdir()
        descriptor = os.open(self.folder / "out", os.O_RDONLY)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        running = self.start(*RUN, "--json", "out/results.json", "--html", "out/../out/page.html")
        self.assertIn("waiting", running.stderr.readline())
        os.close(descriptor)
        self.assertEqual(running.wait(timeout=PATIENCE), AS_EXPECTED)

    def test_many_at_once_leave_the_reports_of_one(self):
        """Of two kinds of run, whose reports differ in each file."""
        wrong = self.odd_renderer("mirror", "", "cases")
        kinds = [["--against", "exact"], ["--against", wrong, "--no-rerun"]]
        wanted = []
        for kind in kinds:
            self.command("run", "cases", *kind, *report_options("single"), expect=None)
            wanted.append(contents(self.folder / "single"))
        running = [self.start("run", "cases", *kind, *report_options("out")) for kind in 3 * kinds]
        codes = [run.wait(timeout=PATIENCE) for run in running]
        self.assertEqual(codes, 3 * [AS_EXPECTED, UNEXPECTED])
        self.assertIn(contents(self.folder / "out"), wanted)

    def test_asked_to_stop_while_it_writes(self):
        """All is found, so all is written."""
        out = self.folder / "out"
        out.mkdir()
        with self.blocked_run("--json", "out/results.json", "--triptychs", "out/more") as running:
            self.wait_for(out / "results.json")
            running.send_signal(signal.SIGTERM)
            time.sleep(.2)
            self.assertIsNone(running.poll())
        self.assertEqual(running.returncode, AS_EXPECTED)
        results = results_file.read(out / "results.json")
        self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "agree"))
        self.assertFalse(results["interrupted"])


if __name__ == "__main__":
    unittest.main()
