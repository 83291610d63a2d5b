# SPDX-License-Identifier: MIT
"""Prints the tests that took longest.

    slowest.py COUNT JUNIT-FILE...

The files are what ctest writes with --output-junit; those that there are not are left out.
"""
import sys
import xml.etree.ElementTree
from pathlib import Path


def seconds_of(files):
    """[(seconds, name)] of all tests in the files."""
    return [(float(test.get("time", 0)), test.get("name"))
            for file in files if file.exists()
            for test in xml.etree.ElementTree.parse(file).iter("testcase")]


def main(count, *files):
    slowest = sorted(seconds_of(map(Path, files)), reverse=True)[:int(count)]
    for seconds, name in slowest:
        print(f"{seconds:7.1f} s  {name}")


if __name__ == "__main__":
    main(*sys.argv[1:])
