# SPDX-License-Identifier: MIT
"""The page that draws with the browser's own GPU, here SwiftShader's: its recording is judged as any
renderer's, lies are found out, and a device that fails says so."""
import base64
import contextlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TESTS / "tools"), str(TESTS / "support")]

from browser import Browser  # noqa: E402
from share import IS_QUICK, in_full_tier  # noqa: E402
from support import (BIN, EDGECASE, SUITE, UNEXPECTED, CommandTest, environment,  # noqa: E402
                     only_result, verdicts)

RENDERER_FAILED = 4
PATIENCE = 20  # seconds
SOFTWARE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
CORE = [SUITE, "--suite", "core", "--sample", "1/32" if IS_QUICK else "1/2"]
FEW = [f"{SUITE}/triangles/shared-edges", "--filter", "triangles/shared-edges/h*"]
TOLD_ALIKE = [f"{SUITE}/{name}.json" for name in (
    "output/depth/at-each-sample", "output/depth/clear-value-at-samples",
    "output/stencil/at-each-sample", "output/stencil/sample-mask", "samples/depth/at-edges",
    "samples/attributes/frag-coord-at-samples", "textures/level-of-detail/magnified",
    "textures/level-of-detail/sixteenths", "textures/level-of-detail/odd-images")][::3 if IS_QUICK else 1]
STATEFUL = [*(f"{SUITE}/{folder}" for folder in ("output", "samples", "textures")), "--sample",
            "1/40" if IS_QUICK else "1/4"]
FLAT = [f"{SUITE}/{folder}" for folder in ("points", "lines", "triangles")]
# What webgl:firefox needs, by the name of a program and of Debian's package.
NEEDED = {"firefox-esr": "firefox-esr", "xvfb-run": "xvfb", "xauth": "xauth"}
ABSENT = [package for program, package in NEEDED.items()
          if not shutil.which(program) and not (program == "firefox-esr" and shutil.which("firefox"))]
# Of a page that was just opened, before it draws.
SPOILT_SHADER = """(() => {
  const whole = WebGL2RenderingContext.prototype.shaderSource;
  WebGL2RenderingContext.prototype.shaderSource = function (shader, source) {
    return whole.call(this, shader, source.replace(FROM, TO));
  };
})()"""
LIES = {
    "a constant image": "answer.pixels.fill(255); answer.fragments = []; answer.hits.fill(0);",
    "another case's answer": "const mine = answer; answer = before || mine; before = mine;",
    "right fragments on a wrong picture": "answer.pixels[0] ^= 0x80;",
    "a fragment too many": "answer.fragments.push({...answer.fragments[0], x: 0, y: 0}); ++answer.hits[0];",
}


class Page(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.downloads = tempfile.TemporaryDirectory(prefix="edgecase-downloads-")
        cls.browser = Browser(cls.downloads.name, width=390, height=844, gpu=SOFTWARE)
        cls.browser.driver.set_script_timeout(300)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.downloads.cleanup()

    def page_of(self, *selection):
        page = self.folder / "page.html"
        self.command("web", *selection, "-o", page)
        return page

    def open(self, page, script=""):
        """Opens a page; the script runs before any of its own."""
        if script:
            added = self.browser.cdp("Page.addScriptToEvaluateOnNewDocument", source=script)
        self.browser.open(page)
        if script:
            self.browser.cdp("Page.removeScriptToEvaluateOnNewDocument",
                             identifier=added["identifier"])

    def draw(self, before="", instead="await page.run();"):
        """All that the page has, or what `instead` draws; returns the recording."""
        text = self.browser.driver.execute_async_script(
            before + """
            const done = arguments[0];
            (async () => {
              """ + instead + """
              const bytes = await page.recording();
              return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
            })().then(done, (fault) => done("!" + fault.stack));""")
        self.assertFalse(text.startswith("!"), text)
        path = self.folder / "page.rec"
        path.write_bytes(base64.b64decode(text))
        return f"recording:{path}"

    def counts(self):
        return self.browser.ask("page.counts")

    def state(self):
        return self.browser.ask("document.body.dataset.state")

    def test_a_recording_is_judged_as_any_renderer_is(self):
        self.browser.requests()
        page = self.page_of(*CORE)
        self.assertLess(page.stat().st_size, 2_000_000)
        self.open(page)
        results = self.results(*CORE, "--against", self.draw(), expect=None)
        self.assertEqual(self.state(), "done")
        [renderer] = results["renderers"]
        self.assertIn("SwiftShader", renderer["device"])
        # What a page hands back is measured, too.
        profile = self.command("profile", *CORE, "--against", renderer["name"], "--json",
                               "-").stdout
        rules = json.loads(profile)["policy"]["rules"]
        # Of few cases several grids remain, and the reported one is taken.
        self.assertEqual(rules["triangle.snap"], "4-half-even")
        self.assertIn("Chromium", renderer["traits"]["browser"])
        self.assertEqual(renderer["traits"]["recorded"], "webgl:chromium")
        found = list(verdicts(results).values())
        # SwiftShader's known faults are known of it here, too.
        red = [case["id"] for case in results["cases"]
               if only_result(case)["standing"] not in ("expected", "known", "tolerated")]
        self.assertEqual(red, [])
        self.assertEqual(found.count("not-run"), self.counts()["not supported"])
        self.assertGreater(self.counts()["drawn"], len(found) / 2)
        self.assertLessEqual({url.split(":")[0] for url in self.browser.requests()},
                             {"about", "file"})

    def test_a_planted_key_is_refused_by_its_name(self):
        """In any object of a scene, without anybody telling the page of it; the suite's own are known."""
        self.open(self.page_of(*STATEFUL))
        found = self.browser.driver.execute_async_script("""
          const done = arguments[0];
          const found = {unknown: [], drawn: [], objects: []};
          const objects = new Set();
          function plant(scene, value, place) {
            if (typeof value !== "object") return;
            if (!Array.isArray(value)) {
              objects.add(place.replace(/[0-9]+/g, "N"));
              value.planted = 1;
              const {not_run} = answerTo(page.device.renderer, {edgecase: 1, scene});
              if (not_run !== `/scene${place} has the unknown key "planted"`) found.drawn.push(place);
              delete value.planted;
            }
            // One of many vertices or numbers will do.
            Object.entries(value).slice(0, 20).forEach(
              ([key, part]) => plant(scene, part, `${place}/${key}`));
          }
          (async () => {
            for (const block of page.data.blocks)
              for (const {id, scene} of await casesOf(block)) {
                const unknown = unknownIn(scene, KNOWN_SCENE);
                if (unknown) found.unknown.push(id + unknown);
                plant(scene, scene, "");
              }
            found.objects = [...objects];
          })().then(() => done(found), (fault) => done({unknown: [fault.stack]}));""")
        self.assertEqual((found["unknown"], found["drawn"]), ([], []))
        self.assertLessEqual({"", "/target", "/textures/N/levels/N", "/draws/N/vertices/N",
                              "/draws/N/texture/lookup", "/draws/N/stencil/back",
                              "/draws/N/depth", "/draws/N/blend/alpha", "/draws/N/polygon_offset",
                              "/draws/N/multisampling"}, set(found["objects"]))

    def test_a_tab_that_is_about_to_be_closed_asks(self):
        """What was drawn until then can be saved, and says that it is not all."""
        self.open(self.page_of(SUITE, "--exclude", "scenes/*", "--sample", "1/20"))
        recording = self.draw(instead="page.run(); await new Promise((go) => setTimeout(go, 2000));")
        self.assertEqual(self.state(), "drawing")
        self.assertTrue(self.browser.ask(
            "!dispatchEvent(new Event('beforeunload', {cancelable: true}))"))
        self.browser.ask("page.state = 'done'")
        run = self.command("run", f"{SUITE}/values", "--against", recording, expect=None)
        self.assertIn("the recording was interrupted before this case", run.stdout)

    @in_full_tier
    def test_it_is_usable_by_thumb(self):
        self.open(self.page_of(*FEW))
        self.assertEqual(self.browser.ask("document.documentElement.scrollWidth"), 390)
        box = self.browser.ask("document.getElementById('start').getBoundingClientRect().toJSON()")
        self.assertGreaterEqual(box["height"], 44)
        self.assertGreaterEqual(box["width"], 300)
        self.assertGreater(box["top"], 700)
        self.draw()
        self.assertEqual(self.browser.ask("document.documentElement.scrollWidth"), 390)

    def test_a_lost_context_costs_one_case(self):
        self.open(self.page_of(*FEW))
        drawn = self.draw(
            "page.device.renderer.gl.getExtension('WEBGL_lose_context').loseContext();")
        self.assertEqual(self.state(), "done")
        self.assertEqual(self.counts()["lost contexts"], 1)
        run = self.command("run", *FEW, "--against", drawn, expect=RENDERER_FAILED)
        self.assertIn("the WebGL context was lost while this scene was drawn", run.stdout)

    def test_without_webgl_it_says_so(self):
        self.open(self.page_of(*FEW), "HTMLCanvasElement.prototype.getContext = () => null;")
        self.assertEqual(self.state(), "failed")
        self.assertIn("no WebGL 2", self.browser.ask("document.getElementById('word').textContent"))

    @in_full_tier
    def test_without_float_targets_the_rest_is_drawn(self):
        self.open(self.page_of(f"{SUITE}/samples/supersampling", *FEW[:1], "--sample", "1/40"), """
          const whole = WebGL2RenderingContext.prototype.getExtension;
          WebGL2RenderingContext.prototype.getExtension = function (name) {
            return name.includes("float") ? null : whole.call(this, name);
          };""")
        self.draw()
        reasons = self.browser.ask("[...page.reasons.keys()]")
        self.assertTrue(any("EXT_color_buffer_float" in reason for reason in reasons), reasons)
        self.assertGreater(self.counts()["drawn"], 0)

    def test_one_case_beside_exact(self):
        page = self.folder / "case.html"
        self.command("web", "--live", f"{SUITE}/triangles/shared-edges/hole-where-x-is-a-third.json",
                     "-o", page)
        self.open(page)
        self.assertEqual(self.state(), "done")
        width = self.browser.ask("page.panes[0].canvas.width")
        self.browser.ask("document.querySelector('#zoom button:last-child').click()")
        self.assertGreater(self.browser.ask("page.panes[0].canvas.width"), width)
        self.browser.ask("page.choose([6, 6])")
        self.assertIn("primitive", self.browser.ask("document.getElementById('counts').textContent"))

    def test_one_case_fills_a_phone(self):
        page = self.folder / "case.html"
        self.command("web", "--live", f"{SUITE}/triangles/shared-edges/hole-where-x-is-a-third.json",
                     "-o", page)
        self.open(page)
        widths = self.browser.ask("page.panes.map((pane) => pane.canvas.clientWidth)")
        self.assertEqual(widths, [390 - 2 * (16 + 1)] * 2)
        self.assertEqual(self.browser.ask("document.getElementById('progress').clientHeight"), 0)
        self.assertEqual(self.browser.ask("document.documentElement.scrollWidth"), 390)

    def test_each_lie_is_found_out(self):
        page = self.page_of(*FEW)
        for name, lie in LIES.items():
            with self.subTest(lie=name):
                self.open(page)
                drawn = self.draw(f"""
                  const whole = SceneRenderer.prototype.outcomeOf;
                  let before = null;
                  SceneRenderer.prototype.outcomeOf = function (scene) {{
                    let answer = whole.call(this, scene);
                    if (answer.not_run === undefined) {{ {lie} }}
                    return answer;
                  }};""")
                results = self.results(*FEW, "--against", drawn, expect=None)
                agreeing = [one for one, verdict in verdicts(results).items()
                            if verdict not in ("violation", "not-run")]
                self.assertLessEqual(len(agreeing), 1 if "another" in name else 0, agreeing)

    def test_samples_that_lie_are_refused(self):
        """What a page finds of a buffer's samples is proven before any scene is drawn with it."""
        page = self.page_of(f"{SUITE}/output/depth/at-each-sample.json",
                            f"{SUITE}/output/stencil/at-each-sample.json", "--sample", "1/4")
        for place, alteration, reasons in (
                ("float(1 << gl_SampleID)", "float(1 << (3 - gl_SampleID))",
                 ["not hold what a buffer without them holds", "not hold the stencils written"]),
                ("the text of no shader", "", [])):
            with self.subTest(alteration=alteration):
                self.open(page, SPOILT_SHADER.replace("FROM", json.dumps(place))
                          .replace("TO", json.dumps(alteration)))
                self.draw()
                found = self.browser.ask("[...page.reasons.keys()].join(' ')")
                self.assertEqual([one for one in reasons if one not in found], [], found)
                self.assertEqual(self.counts()["drawn"] > 0, not reasons, found)

    @in_full_tier
    def test_an_altered_shader_is_convicted(self):
        page = self.page_of(*FEW)
        for place, alteration in {
                "gl_Position = position;": "gl_Position = position + vec4(0.5, 0.0, 0.0, 0.0);",
                "target = LOOKUP;": "target = LOOKUP * 0.5;"}.items():
            with self.subTest(alteration=alteration):
                self.open(page, SPOILT_SHADER.replace("FROM", json.dumps(place))
                          .replace("TO", json.dumps(alteration)))
                results = self.results(*FEW, "--against", self.draw(), expect=UNEXPECTED)
                self.assertIn("violation", verdicts(results).values())


def answers(lines):
    """id -> what is drawn, in an order of its own, without what a page does not tell."""
    found = {}
    for line in lines.splitlines():
        answer = json.loads(line)
        answer.pop("sample_pixels", None)
        for fragment in answer.get("fragments", ()):
            for name in [name for name in fragment.get("derivatives", ()) if len(name) > 4]:
                del fragment["derivatives"][name]
        answer["fragments"] = sorted(answer.get("fragments", ()), key=json.dumps)
        found[answer.pop("id")] = answer
    return found


def status_of(address):
    """The status of an answer that somebody without the page gets at a page's address."""
    request = urllib.request.Request(address + "scene", b"ready",
                                     {"Origin": address[:address.index("/", 7)]})
    try:
        with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
            return answer.status
    except urllib.error.HTTPError as refusal:
        return refusal.code


class Live(CommandTest):
    def test_it_keeps_the_protocol(self):
        """What it does not know, such as a key of a later version, it refuses."""
        run = self.command("backends", f"exec:{shlex.quote(str(BIN / 'edgecase-webgl'))} chromium",
                           "--timeout", str(PATIENCE))
        self.assertRegex(run.stdout, r"\d+ checks: \d+ pass, .*\b0 fail\n")

    def rendered(self, renderer):
        run = self.command("render", *TOLD_ALIKE, "--with", renderer, "--json", "-", expect=None)
        return answers(run.stdout), run.stderr

    def test_samples_and_levels_are_told_as_by_the_driver_itself(self):
        """Fragment for fragment: samples with tests and masks, depths, stencils, levels of detail."""
        told, refusals = self.rendered("webgl:chromium-gl")
        itself, _ = self.rendered("egl:llvmpipe")
        self.assertGreater(len(told), len(itself) * 3 / 4, refusals)
        self.assertEqual([name for name, answer in told.items() if answer != itself[name]], [])
        fragments = [one for answer in told.values() for one in answer["fragments"]]
        self.assertTrue(any("level_of_detail" in one for one in fragments))
        self.assertTrue(any(answer["samples"] > 1 and answer.get(buffer) for buffer in
                            ("depths", "stencils") for answer in told.values()))

    def test_a_browser_is_a_renderer_and_leaves_nothing(self):
        home = self.folder / "tmp"
        home.mkdir()
        run = self.command("run", *FEW, "--against", "webgl:chromium", "--jobs", "1",
                           TMPDIR=str(home))
        self.assertIn("webgl:chromium", run.stdout)
        self.assertNotIn("not-run", run.stdout)
        until = time.monotonic() + PATIENCE
        while os.listdir(home) and time.monotonic() < until:
            time.sleep(0.05)
        self.assertEqual(os.listdir(home), [])

    def secrets_beside(self, renderer):
        """Runs a renderer; whether its address was seen in arguments or variables of any process,
        and what somebody is answered who knows it and has not its page."""
        home = self.folder / "tmp"
        home.mkdir(exist_ok=True)
        with subprocess.Popen([EDGECASE, "run", *FEW, "--against", renderer, "--jobs", "1"],
                              cwd=self.folder, env=environment(TMPDIR=str(home)),
                              stdout=subprocess.PIPE, text=True) as running:
            seen, answers, address = set(), set(), None
            while running.poll() is None:
                for start in home.glob("*/start.html"):
                    # It may be read while it is written, or after the renderer took it away.
                    with contextlib.suppress(FileNotFoundError):
                        if found := re.search('"(http:[^"]*)"', start.read_text("utf-8")):
                            address = found[1]
                if address is None:
                    continue
                with contextlib.suppress(OSError):
                    answers.add(status_of(address))
                for entry in pathlib.Path("/proc").glob("[0-9]*"):
                    for name in ("cmdline", "environ"):
                        with contextlib.suppress(OSError):
                            if address[-33:-1].encode() in (entry / name).read_bytes():
                                seen.add((entry / "cmdline").read_bytes())
            told = running.stdout.read()
        self.assertNotIn("not-run", told)
        self.assertIsNotNone(address)
        return seen, answers

    def test_no_process_tells_the_address_of_its_page(self):
        self.assertEqual(self.secrets_beside("webgl:chromium"), (set(), {403}))

    @in_full_tier
    @unittest.skipIf(ABSENT, f"not run: there is no {', no '.join(ABSENT)}; see tools/packages-full.txt")
    def test_no_process_of_firefox_tells_it(self):
        self.assertEqual(self.secrets_beside("webgl:firefox"), (set(), {403}))

    def recorded(self, renderer):
        """Of a share of the flat cases."""
        path = self.folder / f"{renderer.replace(':', '-')}.rec"
        self.command("record", *FLAT, "--sample", "1/8", "--against", renderer, "-o", path, expect=None)
        run = self.command("render", *FLAT, "--with", f"recording:{path}", "--json", "-", expect=None)
        return answers(run.stdout)

    @in_full_tier
    @unittest.skipIf(ABSENT, f"not run: there is no {', no '.join(ABSENT)}; see tools/packages-full.txt")
    def test_firefox_draws_as_chromium_does(self):
        """Two browsers upon one driver: what both draw is the same, fragment for fragment."""
        chromium, firefox = (self.recorded(f"webgl:{name}") for name in ("chromium-gl", "firefox"))
        both = chromium.keys() & firefox.keys()
        self.assertGreater(len(both), len(chromium) * 9 / 10)
        self.assertEqual([name for name in sorted(both) if chromium[name] != firefox[name]], [])

    def test_a_missing_browser_is_named(self):
        path = self.write("bin/edgecase-nothing", "")
        run = self.command("run", *FEW, "--against", "webgl:firefox", expect=RENDERER_FAILED,
                           PATH=str(path.parent))
        self.assertIn("there is no firefox in PATH", run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
