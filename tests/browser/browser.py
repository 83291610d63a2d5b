# SPDX-License-Identifier: MIT
"""A headless Chromium without a network, and what it is asked: Debian's chromium, chromium-driver
and python3-selenium."""
import json
import pathlib
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

HERE = pathlib.Path(__file__).resolve().parent
AXE = HERE / "node_modules" / "axe-core" / "axe.min.js"
PATIENCE = 30  # seconds


class Browser:
    """One window; every request that pages make is noted."""

    def __init__(self, downloads, width=1280, height=800, gpu=("--disable-gpu",)):
        options = webdriver.ChromeOptions()
        for argument in ("--headless=new", "--no-sandbox", "--hide-scrollbars", *gpu,
                         "--disable-background-networking", "--force-device-scale-factor=1"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"performance": "ALL", "browser": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))
        self.driver.set_script_timeout(PATIENCE)
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height,
                 deviceScaleFactor=1, mobile=False)
        self.cdp("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(downloads))

    def close(self):
        self.driver.quit()

    def cdp(self, method, **parameters):
        return self.driver.execute_cdp_cmd(method, parameters)

    def ask(self, expression, *arguments):
        return self.driver.execute_script(f"return {expression}", *arguments)

    def open(self, page, fragment=""):
        self.driver.get("about:blank")
        self.driver.get(pathlib.Path(page).as_uri() + fragment)
        self.wait("document.querySelector('main')")

    def go(self, fragment, what):
        """To another place of the page, until `what` holds."""
        self.driver.execute_script("location.hash = arguments[0]", fragment)
        self.wait(what)

    def wait(self, expression):
        until = time.monotonic() + PATIENCE
        while not self.ask(f"Boolean({expression})"):
            if time.monotonic() > until:
                raise AssertionError(f"this does not come true: {expression}")
            time.sleep(0.02)

    def press(self, *keys):
        for key in keys:
            ActionChains(self.driver).send_keys(getattr(Keys, key, key)).perform()

    def scheme(self, name):
        self.cdp("Emulation.setEmulatedMedia",
                 features=[{"name": "prefers-color-scheme", "value": name}])

    def requests(self):
        """Addresses that were asked for since this was last called."""
        messages = [json.loads(entry["message"])["message"]
                    for entry in self.driver.get_log("performance")]
        return [message["params"]["request"]["url"] for message in messages
                if message["method"] == "Network.requestWillBeSent"]

    def complaints(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def violations(self):
        """What axe finds on the page as it is."""
        self.driver.execute_script(AXE.read_text(encoding="utf-8"))
        found = self.driver.execute_async_script(
            "const done = arguments[0]; axe.run().then((r) => done(r.violations), "
            "(fault) => done([{id: String(fault), nodes: []}]))")
        return [f"{v['id']}: " + "; ".join(node["html"][:160] for node in v["nodes"][:4])
                for v in found]
