# SPDX-License-Identifier: MIT
"""The right driver is really used: llvmpipe and softpipe are different programs at work, and a
worker that gets another driver than it was promised refuses."""
import glob
import json
import subprocess
import unittest

from support import (BIN, FRONT_ENDS, MESA, PATIENCE, RENDERER, SUITE, CommandTest, environment,
                     mesa_release, places)

WORKER = str(BIN / "edgecase-gl")
# A row of centres on the bottom edge of a triangle, where each driver has a rule of its own.
TIE = "triangles/ties/flat-bottom"
# How a user would choose a driver by hand.
BY_HAND = {
    "llvmpipe": {"GALLIUM_DRIVER": "llvmpipe", "LP_NUM_THREADS": "0"},
    "softpipe": {"GALLIUM_DRIVER": "softpipe", "MESA_GL_VERSION_OVERRIDE": "4.5",
                 "MESA_GLSL_VERSION_OVERRIDE": "450"},
}
# How a user would put zink upon a Vulkan driver by hand: its description, what is executed, and the
# Debian package that has both.
VULKAN = {
    "zink": ("/usr/share/vulkan/icd.d/lvp_icd.*json", "libvulkan_lvp.so", "mesa-vulkan-drivers"),
    "zink-swiftshader": ("/usr/lib/chromium/vk_swiftshader_icd.json", "libvk_swiftshader.so",
                         "chromium"),
}
ZINK = {"MESA_LOADER_DRIVER_OVERRIDE": "zink", "LIBGL_ALWAYS_SOFTWARE": "1",
        "NODEVICE_SELECT": "1", "MESA_GL_VERSION_OVERRIDE": "4.3",
        "MESA_GLSL_VERSION_OVERRIDE": "430", "LP_NUM_THREADS": "0",
        # Mesa 25.0 crashes where another version's programs are in its cache.
        "MESA_SHADER_CACHE_DISABLE": "true"}
LIBRARY = {"egl-surfaceless": "libEGL"}
if "osmesa" in FRONT_ENDS:
    LIBRARY["osmesa"] = "libOSMesa.so"


def executable_mappings(pid):
    """Names of what a process can execute, "" for memory that it filled itself."""
    with open(f"/proc/{pid}/maps", encoding="utf-8") as maps:
        lines = [line.split(maxsplit=5) for line in maps]
    return [line[5].strip() if len(line) > 5 else "" for line in lines if "x" in line[1]]


class Drivers(CommandTest):
    def a_request(self):
        """A line as the command sends it, caught by a renderer that keeps it."""
        catcher = self.write("catch.sh", "#!/bin/sh\nhead -n 1 > request\nexit 3\n")
        catcher.chmod(0o755)
        self.command("run", f"{SUITE}/{TIE}.json", "--against", f"exec:{catcher}", expect=RENDERER)
        return (self.folder / "request").read_text(encoding="utf-8")

    def test_what_mesa_has_compiled_is_kept_in_a_folder_of_ours(self):
        caches = self.folder / "caches"
        self.command("run", f"{SUITE}/{TIE}.json", "--against", "egl:llvmpipe",
                     XDG_CACHE_HOME=str(caches))
        kept = [path for path in (caches / "edgecase/mesa/llvmpipe").rglob("*") if path.is_file()]
        self.assertTrue(kept)

    def work(self, context, driver, request, **variables):
        """Has a worker draw one scene; what it says of itself, and what it can execute."""
        worker = subprocess.Popen([WORKER, context, "--expect-driver", driver], text=True,
                                  env=environment(**variables), stdin=subprocess.PIPE,
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        with worker:
            worker.stdin.write(request)
            worker.stdin.flush()
            answer = json.loads(worker.stdout.readline())
            mappings = executable_mappings(worker.pid)
            worker.stdin.close()
            self.assertEqual(worker.wait(timeout=PATIENCE), 0)
        return answer, mappings

    def test_processes_execute_different_code(self):
        request = self.a_request()
        for context, library in LIBRARY.items():
            compiled, fragments = {}, {}
            for driver in BY_HAND:
                answer, mappings = self.work(context, driver, request,
                                             LIBGL_ALWAYS_SOFTWARE="1", **BY_HAND[driver])
                self.assertTrue(answer["renderer"]["device"].startswith(driver))
                self.assertTrue(any(library in name for name in mappings), mappings)
                compiled[driver] = mappings.count("")
                fragments[driver] = places(answer["fragments"])
            # llvmpipe compiles shaders into memory of its own; softpipe interprets them.
            self.assertGreater(compiled["llvmpipe"], compiled["softpipe"])
            self.assertNotEqual(fragments["llvmpipe"], fragments["softpipe"])

    def test_zink_executes_the_vulkan_driver_that_it_was_given(self):
        request = self.a_request()
        libraries = {library for _, library, _ in VULKAN.values()}
        for driver, (pattern, library, package) in VULKAN.items():
            found = glob.glob(pattern)
            if not found:
                run = self.command("backends", f"egl:{driver}", expect=RENDERER)
                self.assertIn(f"Debian has it in the package {package}", run.stdout)
                continue
            if driver == "zink-swiftshader" and mesa_release().startswith("26."):
                # This zink refuses SwiftShader's device, and the command says so.
                run = self.command("backends", f"egl:{driver}", expect=RENDERER)
                self.assertRegex(run.stdout, "unavailable: .*EGL surfaceless cannot be initialised")
                continue
            variables = {**ZINK, "VK_ICD_FILENAMES": found[0], "VK_DRIVER_FILES": found[0]}
            answer, mappings = self.work("egl-surfaceless", driver, request, **variables)
            self.assertTrue(answer["renderer"]["device"].startswith("zink "))
            executed = {name for name in libraries if any(name in path for path in mappings)}
            self.assertEqual(executed, {library})
            self.assertEqual("unofficial" in answer["renderer"]["traits"]["stack"],
                             driver == "zink-swiftshader")
            # Neither the other driver's name nor that of plain llvmpipe is believed.
            for promised in ({"llvmpipe", "softpipe"} | set(VULKAN)) - {driver}:
                run = subprocess.run([WORKER, "egl-surfaceless", "--expect-driver", promised],
                                     input="", capture_output=True, text=True, timeout=PATIENCE,
                                     env=environment(**variables))
                self.assertEqual(run.returncode, 3)
                self.assertIn("the driver is 'zink ", run.stderr)
                self.assertIn(f"not {promised}", run.stderr)

    def test_zink_draws_the_same_with_any_number_of_threads(self):
        pattern = VULKAN["zink"][0]
        plain = self.command("render", f"{SUITE}/{TIE}.json", "--with", "egl:zink").stdout
        variables = " ".join(f"{name}={value}" for name, value in
                             {**ZINK, "VK_ICD_FILENAMES": glob.glob(pattern)[0]}.items())
        for threads in (1, 4):
            other = (f"exec:env {variables} LP_NUM_THREADS={threads} {WORKER} egl-surfaceless "
                     "--expect-driver zink")
            run = self.command("render", f"{SUITE}/{TIE}.json", "--with", other)
            self.assertEqual(run.stdout, plain)

    def test_devices_and_renderings_differ(self):
        case = f"{SUITE}/{TIE}.json"
        against = [word for renderer in MESA for word in ("--against", renderer)]
        results = self.results(case, *against, expect=None)
        devices = {info["name"]: info["device"] for info in results["renderers"]}
        contexts = {info["name"]: info["traits"]["context"] for info in results["renderers"]}
        drawn = {}
        for renderer in MESA:
            front_end, driver = renderer.split(":")
            self.assertTrue(devices[renderer].startswith(driver), devices)
            self.assertIn(front_end.upper(), contexts[renderer].upper())
            drawn[renderer] = json.loads(
                self.command("render", case, "--with", renderer, "--json", "-").stdout)
        for front_end in FRONT_ENDS:
            one, other = (drawn[f"{front_end}:{driver}"] for driver in BY_HAND)
            self.assertNotEqual(places(one["fragments"]), places(other["fragments"]))
            self.assertNotEqual(one["pixels"], other["pixels"])

    def test_a_worker_refuses_another_driver(self):
        for context in LIBRARY:
            for promised, given in (("softpipe", "llvmpipe"), ("llvmpipe", "softpipe")):
                run = subprocess.run([WORKER, context, "--expect-driver", promised], input="",
                                     env=environment(LIBGL_ALWAYS_SOFTWARE="1", **BY_HAND[given]),
                                     capture_output=True, text=True, timeout=PATIENCE)
                self.assertEqual(run.returncode, 3)
                self.assertIn(f"the driver is '{given}", run.stderr)
                self.assertIn(f"not {promised}", run.stderr)

    def test_the_users_environment_changes_no_driver(self):
        case = f"{SUITE}/{TIE}.json"
        for renderer in MESA:
            driver = renderer.split(":")[1]
            (other,) = set(BY_HAND) - {driver}
            plain = self.command("render", case, "--with", renderer).stdout
            for variable in ("GALLIUM_DRIVER", "MESA_LOADER_DRIVER_OVERRIDE"):
                run = self.command("render", case, "--with", renderer, **{variable: other})
                self.assertEqual(run.stdout, plain, f"{variable}={other}")

    def test_backends_tell_all(self):
        table = self.command("backends").stdout.splitlines()
        rows = {line.split()[0]: line for line in table if ":" in line.split(" ")[0]}
        for renderer in MESA:
            self.assertIn(renderer.split(":")[1], rows[renderer])
            self.assertIn("yes + hits", rows[renderer])
        for renderer in ("egl:zink", "egl:zink-swiftshader", "egl:device0", "egl-es:llvmpipe",
                         "egl-es:softpipe", "egl-es:zink"):
            self.assertIn(renderer, rows)
        listed = int(subprocess.run([WORKER, "--devices"], capture_output=True, text=True,
                                    timeout=PATIENCE, check=True).stdout)
        for front_end in ("egl", "egl-es"):
            devices = [name for name in rows if name.startswith(f"{front_end}:device")]
            self.assertEqual(devices, [f"{front_end}:device{i}" for i in range(max(1, listed))])
        self.assertRegex(rows["egl:zink"], r"zink ?(Vulkan 1\.\d)?\(llvmpipe")
        self.assertIn("yes + hits", rows["egl:zink"])
        self.assertEqual(table[0].split()[0], "renderer")

    def test_backends_of_a_renderer_that_is_missing(self):
        run = self.command("backends", "exact-ish", expect=2)
        self.assertIn("no renderer 'exact-ish'", run.stderr)
        run = self.command("backends", "exec:/no/such/program", expect=RENDERER)
        self.assertIn("cannot be started", run.stdout)


if __name__ == "__main__":
    unittest.main()
