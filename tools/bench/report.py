# SPDX-License-Identifier: MIT
"""How long the HTML report takes: to be written, to be seen, and to open a case.

    tools/bench/report.py [--program build/release/bin/edgecase] [--rounds 5]

Each time is the median of several rounds, and stands beside that of an empty page which was opened
in turn with the report in the same browser, as a ratio: what the machine is busy with meanwhile
hits both. Needs what tests/browser needs; prints a line per size, and fails never.
"""
import argparse
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / name) for name in ("browser", "tools")]

from browser import Browser  # noqa: E402
import results_file  # noqa: E402
import synthetic_results as synthetic  # noqa: E402

SIZES = [(2000, 30_000), (20_000, 60_000)]
EMPTY = "<!doctype html><title>Empty</title><main>Nothing</main>"
PAINT = "performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? 0"
# From the wish for a case, while nothing else is done, until it is laid out.
OPENING = """const [id, done] = arguments;
requestIdleCallback(() => {
  const start = performance.now();
  const watch = new MutationObserver(() => {
    if (CaseView.one?.id !== id || !document.querySelector('.finding .sentence')) return;
    watch.disconnect();
    document.body.offsetHeight;
    done(performance.now() - start);
  });
  watch.observe(document.getElementById('app'), {childList: true, subtree: true});
  Route.openCase(id, {on: ''});
});"""


def first_paint(browser, page):
    browser.open(page)
    browser.wait(PAINT)
    return browser.ask(PAINT)


def written(program, results, page):
    start = time.monotonic()
    subprocess.run([program, "report", results, "--html", page], check=True)
    with_page = time.monotonic() - start
    start = time.monotonic()
    subprocess.run([program, "report", results, "--junit", "/dev/null"], check=True)
    return with_page - (time.monotonic() - start)


def openings(browser, count):
    """The times of `count` cases with differences, spread over all."""
    ids = browser.ask("Cases.filter((one) => one.line !== undefined).map((one) => one.id)")
    return [browser.driver.execute_async_script(OPENING, ids[i * len(ids) // count])
            for i in range(count)]


def measure(program, folder, browser, size, rounds):
    results, page, empty = (folder / name for name in ("r.json", "report.html", "empty.html"))
    results.write_text(results_file.text_of(synthetic.make(*size)), encoding="utf-8")
    empty.write_text(EMPTY, encoding="utf-8")
    writing = statistics.median(written(program, results, page) for _ in range(3))
    paints, empties, opened = [], [], []
    for _ in range(rounds):
        empties.append(first_paint(browser, empty))
        paints.append(first_paint(browser, page))
        opened += openings(browser, 8)
    paint, beside = statistics.median(paints), statistics.median(empties)
    print(f"{size[0]} cases, {size[1]} differing pixels: {page.stat().st_size / 1e6:.2f} MB, "
          f"written in {writing:.2f} s; first paint {paint:.0f} ms, {paint / beside:.1f} times an "
          f"empty page ({beside:.0f} ms); a case opens in {statistics.median(opened):.1f} ms "
          f"(worst {max(opened):.1f} ms)")


def main():
    parser = argparse.ArgumentParser(description="Times of the HTML report.")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/edgecase"))
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="edgecase-bench-") as name:
        browser = Browser(name)
        try:
            for size in SIZES:
                measure(arguments.program, pathlib.Path(name), browser, size, arguments.rounds)
        finally:
            browser.close()


if __name__ == "__main__":
    main()
