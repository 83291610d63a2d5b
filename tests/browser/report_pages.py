# SPDX-License-Identifier: MIT
"""What tests of the HTML report in a browser have in common."""
import pathlib
import sys
import tempfile
from urllib.parse import quote

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TESTS / "tools"), str(TESTS / "support")]

import results_file  # noqa: E402
from browser import Browser  # noqa: E402
from support import CommandTest  # noqa: E402


class ReportTest(CommandTest):
    """With a browser for all of its tests, and the pages that `edgecase report` writes."""

    @classmethod
    def setUpClass(cls):
        cls.downloads = tempfile.TemporaryDirectory(prefix="edgecase-downloads-")
        cls.browser = Browser(cls.downloads.name)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.downloads.cleanup()

    def setUp(self):
        super().setUp()
        self.browser.requests()
        self.browser.complaints()

    def report(self, results, *options):
        """The page that `edgecase report` writes of results."""
        path = self.write("results.json", results_file.text_of(results))
        page = self.folder / "report.html"
        self.command("report", path, "--html", page, *options)
        return page

    def assert_quiet(self, page):
        """Nothing but the page and what lies beside it was asked for, and nothing was refused."""
        beside = page.parent.as_uri()
        asked = self.browser.requests()
        self.assertIn(page.as_uri(), [url.split("#")[0] for url in asked])
        self.assertEqual([url for url in asked if not url.startswith((beside, "about:", "blob:"))],
                         [])
        self.assertEqual(self.browser.complaints(), [])

    def open_case(self, page, one, **place):
        more = "".join(f"&{key}={quote(str(value), safe='')}" for key, value in place.items())
        self.browser.open(page, "#case=" + quote(one["id"], safe="") + more)
        self.browser.wait("document.querySelector('main.case h1')")
