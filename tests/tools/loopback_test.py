# SPDX-License-Identifier: MIT
"""The worker of browsers answers the one browser that it started, whatever other programs and users
of the machine send it. In place of a browser a script reads the page with which one begins."""
import contextlib
import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import time
import unittest

from support import BIN, CommandTest, environment
from two_users import as_nobody, needs_root

PATIENCE = 20  # seconds
AT_ONCE = 8  # seconds, for whoever is answered or shown out
# A browser as far as the worker knows; what it does follows.
BROWSER = f"""#!{sys.executable}
import json, os, re, sys, time, urllib.request
from http.cookiejar import CookieJar
with open(sys.argv[-1]) as start:
    address = re.search('"(http:[^"]*)"', start.read())[1]
origin = address[:address.index("/", 7)]
jar = CookieJar()
opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor(jar))
def page():
    return opener.open(address).read().decode()
def sent(body):
    request = urllib.request.Request(address + "scene", body.encode(), {{"Origin": origin}})
    return opener.open(request).read().decode()
def tell(what):
    with open("told.part", "w") as file:
        json.dump(what, file)
    os.rename("told.part", "told")
"""
# Begins anew before it answers the first request.
STARTS_TWICE = """
page()
told = [sent("ready")]
page()
told += [sent("ready")]
told += [sent("answer to " + told[-1])]
tell(told)
sent("answer to " + told[-1])
"""
# Has the session, and draws its scene until a file says that it has.
DRAWS = """
page()
request = sent("ready")
tell({"address": address, "cookie": "; ".join(f"{one.name}={one.value}" for one in jar)})
while not os.path.exists("drawn"):
    time.sleep(0.01)
sent("answer to " + request)
"""
# Has read where the page is, and does not ask for it.
WAITS = """
tell({"address": address, "cookie": ""})
time.sleep(600)
"""


class Worker(CommandTest):
    def started(self, script):
        self.write("bin/chromium", BROWSER + script).chmod(0o755)
        home = self.folder / "tmp"
        home.mkdir(exist_ok=True)
        worker = subprocess.Popen(
            [BIN / "edgecase-webgl", "chromium"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            text=True, cwd=self.folder,
            env=environment(PATH=f"{self.folder}/bin:{os.environ['PATH']}", TMPDIR=str(home)))
        self.addCleanup(worker.wait)
        self.addCleanup(worker.kill)
        self.addCleanup(worker.stdout.close)
        self.addCleanup(worker.stdin.close)
        return worker

    def told(self):
        until = time.monotonic() + PATIENCE
        while not (self.folder / "told").exists():
            self.assertLess(time.monotonic(), until)
            time.sleep(0.01)
        return json.loads((self.folder / "told").read_text("utf-8"))


class Reloaded(Worker):
    def test_a_page_that_is_loaded_again_gets_its_request_again(self):
        worker = self.started(STARTS_TWICE)
        out, _ = worker.communicate("one\ntwo\n", timeout=PATIENCE)
        self.assertEqual((worker.returncode, out), (0, "answer to one\nanswer to two\n"))
        self.assertEqual(self.told(), ["one", "one", "two"])


class Served(Worker):
    """A browser that does as its script says, and whoever else connects."""

    def setUp(self):
        super().setUp()
        self.worker = self.started(self.SCRIPT)
        self.worker.stdin.write("one\n")
        self.worker.stdin.flush()
        told = self.told()
        self.cookie = told["cookie"]
        self.host, self.secret = re.fullmatch(r"http://(127\.0\.0\.1:\d+)/(\w{32})/",
                                              told["address"]).groups()
        self.port = int(self.host.split(":")[1])

    def status(self, key):
        """A number of the worker's, of /proc/PID/status."""
        text = pathlib.Path(f"/proc/{self.worker.pid}/status").read_text("utf-8")
        return int(re.search(rf"(?m)^{key}:\s+(\d+)", text)[1])

    def connected(self):
        return contextlib.closing(socket.create_connection(("127.0.0.1", self.port), AT_ONCE))

    def answer_to(self, text):
        """The status of the answer; 0 where the connection just ends."""
        with self.connected() as stream:
            try:
                stream.sendall(text)
                return int((stream.recv(4096) or b"- 0").split()[1])
            except ConnectionError:
                return 0

    def request(self, line, body=b"", **fields):
        """Changes of a request that would be answered; a field that is None is left out."""
        told = {"Host": self.host, "Origin": f"http://{self.host}", "Cookie": self.cookie,
                "Content_Length": len(body), **fields}
        head = "".join(f"{name.replace('_', '-')}: {value}\r\n" for name, value in told.items()
                       if value is not None)
        return f"{line} HTTP/1.1\r\n{head}\r\n".encode() + body


class Strangers(Served):
    """What others do while the browser draws."""

    SCRIPT = DRAWS

    def is_answered(self):
        """The browser is, whatever came before."""
        self.write("drawn", "")
        self.assertEqual(self.worker.stdout.readline(), "answer to one\n")

    def test_only_the_browser_is_answered(self):
        scene = f"POST /{self.secret}/scene"
        page = f"GET /{self.secret}/"
        other = self.secret[::-1]
        for status, line, fields in (
                (404, "GET /", {}), (404, "POST /scene", {}), (404, f"POST /{other}/scene", {}),
                (404, f"POST /{self.secret[:-1]}/scene", {}), (404, f"POST /{self.secret}", {}),
                (404, f"POST /x/{self.secret}/scene", {}),
                (403, scene, {"Host": "rebound.example"}), (403, scene, {"Host": None}),
                (403, scene, {"Host": f"localhost:{self.port}"}),
                (403, scene, {"Origin": "http://rebound.example"}),
                (403, scene, {"Origin": "null"}), (403, scene, {"Origin": None}),
                (403, page, {"Origin": "null"}),
                # A second page, or somebody who has no page.
                (403, page, {"Cookie": None}), (403, scene, {"Cookie": None}),
                (403, page, {"Cookie": "session=" + other}), (403, scene, {"Cookie": "session="}),
                (405, f"GET /{self.secret}/scene", {}), (405, page.replace("GET", "POST"), {}),
                (411, scene, {"Content_Length": "many"}), (411, scene, {"Content_Length": "-1"}),
                (411, scene, {"Transfer_Encoding": "chunked"}),
                (413, scene, {"Content_Length": 1 << 40}), (413, page, {"Content_Length": 1})):
            self.assertEqual(self.answer_to(self.request(line, **fields)), status, (line, fields))
        self.assertEqual(self.answer_to(b"hello\r\n\r\n"), 400)
        self.assertEqual(self.answer_to(self.request(scene).replace(b"Host", b"Cookie", 1)), 400)
        # The page is there for whoever has the session, as when a browser loads it again.
        self.assertEqual(self.answer_to(self.request(page, Origin=None)), 200)
        self.is_answered()

    def test_a_body_is_not_read_before_its_head_is_right(self):
        before = self.status("VmHWM")
        for line, fields in (("POST /scene", {}), (f"POST /{self.secret}/scene", {"Cookie": None}),
                             (f"POST /{self.secret}/scene", {"Host": "rebound.example"})):
            with self.connected() as stream, self.assertRaises(ConnectionError):
                stream.sendall(self.request(line, Content_Length=400_000_000, **fields))
                for _ in range(400):
                    stream.sendall(bytes(1_000_000))
        self.assertLess(self.status("VmHWM") - before, 2_000)  # KiB
        self.is_answered()

    def test_a_head_is_short(self):
        before = self.status("VmHWM")
        long = self.request(f"POST /{self.secret}/scene", X="x" * 17_000)
        self.assertIn(self.answer_to(long), (0, 400, 431))
        with self.connected() as stream, self.assertRaises(ConnectionError):
            for _ in range(400):
                stream.sendall(b"x" * 1_000_000)
        self.assertLess(self.status("VmHWM") - before, 2_000)  # KiB
        self.is_answered()

    def test_many_connections_are_few(self):
        before = self.status("Threads")
        with contextlib.ExitStack() as stack:
            streams = [stack.enter_context(self.connected()) for _ in range(300)]
            streams[-1].sendall(b"GET ")
            self.assertEqual(self.status("Threads"), before)
            self.assertLess(len(os.listdir(f"/proc/{self.worker.pid}/fd")), 40)
            self.is_answered()

    def test_whoever_says_nothing_is_shown_out(self):
        with self.connected() as silent, self.connected() as slow:
            begun = time.monotonic()
            with self.assertRaises(ConnectionError):
                while time.monotonic() - begun < AT_ONCE:
                    slow.sendall(b"x")
                    time.sleep(0.02)
            self.assertEqual(silent.recv(1), b"")
        self.is_answered()

    def test_the_secret_stands_where_nobody_else_reads(self):
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            for name in ("cmdline", "environ"):
                with contextlib.suppress(OSError):
                    self.assertNotIn(self.secret.encode(), (entry / name).read_bytes(),
                                     (entry / "cmdline").read_bytes())
        (profile,) = (self.folder / "tmp").iterdir()
        self.assertEqual(profile.stat().st_mode & 0o7777, 0o700)

    @needs_root
    def test_nobody_learns_nothing(self):
        (profile,) = (self.folder / "tmp").iterdir()
        self.folder.chmod(0o755)
        (self.folder / "tmp").chmod(0o755)
        told = as_nobody(["sh", "-c", f"cat {profile}/start.html; ls {profile}; "
                          "cat /proc/*/cmdline /proc/*/environ"], "/")
        self.assertNotIn(self.secret, told.stdout)
        self.assertIn("edgecase-webgl", told.stdout)
        for path in ("", "scene", "0" * 32 + "/", "0" * 32 + "/scene"):
            request = f"POST /{path} HTTP/1.1\\r\\nHost: {self.host}\\r\\n\\r\\n"
            told = as_nobody(["bash", "-c", f"exec 3<>/dev/tcp/127.0.0.1/{self.port}; "
                              f"printf '{request}' >&3; head -1 <&3"], "/")
            self.assertEqual(told.stdout, "HTTP/1.1 404 Not Found\n", told.stderr)
        self.is_answered()


class BeforeThePage(Served):
    SCRIPT = WAITS

    def test_the_page_is_given_once(self):
        scene = self.request(f"POST /{self.secret}/scene", Cookie="session=")
        page = self.request(f"GET /{self.secret}/", Origin=None, Cookie=None)
        self.assertEqual([self.answer_to(one) for one in (scene, page, scene, page)],
                         [403, 200, 403, 403])


if __name__ == "__main__":
    unittest.main()
