# SPDX-License-Identifier: MIT
"""A run that is killed at any moment: what --resume makes of what is left equals, to the byte, what
one run writes, and at most the cases at hand were lost."""
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
# Few cases of every folder, on two drivers: violations, values, samples, what is not supported.
RUN = ["run", SUITE, "--exclude", "scenes/*", "--sample", "1/700", "--against", MESA[-2],
       "--against", MESA[-1]]
TAKEN = re.compile(r"edgecase: (\d+) of (\d+) cases (?:is|are) taken over from (\S+)\n")


class Killed(CommandTest):
    def kill(self, after, *arguments):
        """Kills a run so many seconds after its start; false if it had ended before."""
        running = subprocess.Popen([EDGECASE, *arguments], cwd=self.folder, env=environment(),
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(running.kill)
        time.sleep(after)
        running.send_signal(signal.SIGKILL)
        return running.wait(timeout=PATIENCE) == -signal.SIGKILL

    def resume(self):
        """What was taken over, and what is there in the end; nothing of the journal."""
        run = self.command(*RUN, *report_options("out"), "--resume", expect=None)
        written = contents(self.folder / "out")
        self.assertNotIn("reports.json.unfinished", written)
        found = TAKEN.search(run.stderr)
        return (int(found[1]), found[3]) if found else (0, "")

    def test_at_any_moment(self):
        begin = time.monotonic()
        self.command(*RUN, *report_options("whole"), "--ask-all", expect=None)
        took = time.monotonic() - begin
        whole = contents(self.folder / "whole")
        moments = random.Random(NUMBER)
        outcomes = []
        for number in range(KILLS):
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            killed = [self.kill(moments.uniform(0, took), *RUN, *report_options("out"))]
            if number % 3 == 0:  # and once more
                killed.append(self.kill(moments.uniform(0, took), *RUN, *report_options("out"),
                                        "--resume"))
            taken, source = self.resume()
            left = contents(self.folder / "out")
            for name, expected in whole.items():
                self.assertEqual(left.get(name) == expected, True, (number, name))
            outcomes.append((killed, taken, source))
        print(f"{KILLS} kills:", *outcomes, sep="\n", file=sys.stderr)
        going_on = [taken for _, taken, source in outcomes if source.endswith(".unfinished")]
        self.assertGreaterEqual(len(going_on), KILLS / 5)
        self.assertGreater(len(set(going_on)), KILLS / 10)


if __name__ == "__main__":
    unittest.main()
