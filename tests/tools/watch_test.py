# SPDX-License-Identifier: MIT
"""`edgecase run --watch` runs again what a saved file touches, says what has changed, and renews the
report; it ends when it is interrupted."""
import json
import os
import queue
import shutil
import signal
import subprocess
import sys
import threading
import time
import unittest

from support import EDGECASE, PATIENCE, ROOT, SUITE, CommandTest, environment


class Watch(CommandTest):
    def setUp(self):
        super().setUp()
        for name in ("flat-top", "right-angle-lower-left"):
            shutil.copy(f"{SUITE}/triangles/ties/{name}.json", self.folder)
        shutil.copy(ROOT / "reference" / "examples" / "triangles.py", self.folder)
        self.process = subprocess.Popen(
            [EDGECASE, "run", ".", "--watch", "--against", f"mine=exec:{sys.executable} triangles.py",
             "--html", "report.html"], cwd=self.folder, env=environment(), stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, errors="replace")
        self.lines = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()

    def tearDown(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.process.stdout.close()
        super().tearDown()

    def read(self):
        for line in self.process.stdout:
            self.lines.put(line.rstrip("\n"))

    def until(self, text):
        """What is printed up to a line with this text."""
        seen, end = [], time.monotonic() + PATIENCE
        while not seen or text not in seen[-1]:
            try:
                seen.append(self.lines.get(timeout=max(0.01, end - time.monotonic())))
            except queue.Empty:
                self.fail(f"nobody prints {text!r}: {seen}")
        return seen

    def save(self, name, change):
        path = self.folder / name
        text = change(path.read_text(encoding="utf-8"))
        fresh = self.folder / "fresh"
        fresh.write_text(text, encoding="utf-8")
        os.replace(fresh, path)  # as editors save

    def test_a_saved_file_runs_again_what_it_touches(self):
        self.until("watching case files")
        report = self.folder / "report.html"
        before = report.read_bytes()
        self.save("flat-top.json", lambda text: json.dumps({**json.loads(text), "title": "Another"}))
        seen = "\n".join(self.until("nothing has changed"))
        self.assertIn("flat-top.json is saved", seen)
        self.assertIn("1 of 2 cases is taken over from the latest run", seen)
        self.assertIn("2 cases, ", seen)
        end = time.monotonic() + PATIENCE
        while report.read_bytes() == before and time.monotonic() < end:
            time.sleep(0.05)
        self.assertIn(b"Another", report.read_bytes())
        self.save("triangles.py", lambda text: text.replace("min(sides) >= 0", "min(sides) > 0"))
        seen = "\n".join(self.until("first "))
        self.assertIn("triangles.py is saved", seen)
        self.assertNotIn("taken over", seen)
        self.assertIn("Changed since, mine: ", seen)
        self.process.send_signal(signal.SIGINT)
        self.process.wait(PATIENCE)

    def test_a_broken_file_is_told_and_its_mend_runs(self):
        self.until("watching case files")
        text = (self.folder / "flat-top.json").read_text(encoding="utf-8")
        self.save("flat-top.json", lambda _: text[:-20])
        self.until("flat-top.json is saved")
        self.save("flat-top.json", lambda _: text)
        self.until("flat-top.json is saved")
        self.until("2 cases, ")


if __name__ == "__main__":
    unittest.main()
