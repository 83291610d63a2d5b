# SPDX-License-Identifier: MIT
"""A run that is killed at any moment: what --resume makes of what is left equals, to the byte, what
one run writes."""
import random
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

from suite_data import COUNT, IS_QUICK, NUMBER
from support import (EDGECASE, MESA, PATIENCE, SUITE, CommandTest, contents, environment,
                     report_options)

KILLS = 5 if IS_QUICK else 50 // COUNT
# Cases of every kind, on two drivers: violations, values, samples, what is not supported.
FOLDERS = ("lines/diamonds", "triangles/shared-edges", "textures/filter", "samples/resolve",
           "output/blending", "points")
RUN = ["run", *(f"{SUITE}/{folder}" for folder in FOLDERS), "--sample", "1/15", "--jobs", "2",
       "--against", MESA[-2], "--against", MESA[-1]]
TAKEN = re.compile(r"edgecase: (\d+) of \d+ cases (?:is|are) taken over from (\S+)\n")


class Killed(CommandTest):
    def setUp(self):
        super().setUp()
        self.journal = self.folder / "out/reports.json.unfinished"

    def start(self, *arguments):
        running = subprocess.Popen([EDGECASE, *RUN, *report_options("out"), *arguments],
                                   cwd=self.folder, env=environment(), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.addCleanup(running.kill)
        return running

    def await_journal(self, running, size):
        """Waits until the run has written so much, or ends."""
        deadline = time.monotonic() + PATIENCE
        while running.poll() is None and not (self.journal.exists() and
                                              self.journal.stat().st_size >= size):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(.001)

    def seconds_of_a_run(self):
        """How long a run takes behind its first case."""
        running = self.start("--ask-all")
        self.await_journal(running, 1)
        begin = time.monotonic()
        running.wait(timeout=PATIENCE)
        return time.monotonic() - begin

    def kill(self, after, *arguments):
        """Kills a run so long behind its first case, or, where that is below 0, before."""
        running = self.start(*arguments)
        if after >= 0:
            self.await_journal(running, 1)
        time.sleep(abs(after))
        running.send_signal(signal.SIGKILL)
        return running.wait(timeout=PATIENCE) == -signal.SIGKILL

    def resume(self):
        """How many cases were taken over, and from which file."""
        run = self.command(*RUN, *report_options("out"), "--resume", expect=None)
        self.assertFalse(self.journal.exists())
        found = TAKEN.search(run.stderr)
        return (int(found[1]), found[2]) if found else (0, "")

    def test_at_any_moment(self):
        self.command(*RUN, *report_options("whole"), expect=None)
        whole = contents(self.folder / "whole")
        took = self.seconds_of_a_run()
        moments = random.Random(NUMBER)
        going_on = []
        for number in range(KILLS):
            shutil.rmtree(self.folder / "out")
            kills = [self.kill(moments.uniform(-.1, 1) * took)]
            if number % 3 == 0:  # and once more
                kills.append(self.kill(moments.uniform(-.1, 1) * took, "--resume"))
            taken, source = self.resume()
            left = contents(self.folder / "out")
            for name, expected in whole.items():
                self.assertTrue(left[name] == expected, (number, name))
            print(f"kill {number}: {kills}, {taken} cases from {source}", file=sys.stderr)
            if source.endswith(".unfinished"):
                going_on.append(taken)
        self.assertGreaterEqual(len(going_on), KILLS / 2)
        self.assertGreater(len(set(going_on)), KILLS / 4)


if __name__ == "__main__":
    unittest.main()
