# SPDX-License-Identifier: MIT
"""The tiers of tests/tiers.cmake lose nothing: the quick tier and the eight turns together are the
full tier, and the parts of a test together are all of it."""
import copy
import json
import os
import re
import subprocess
import unittest
from collections import Counter

TURNS = [f"turn-{number}" for number in range(1, 9)]
PART = re.compile(r"(.*)\.(\d+)")


def registered():
    """[{"name", "labels", "share", "sets_up", "cost"}] of all tests that ctest knows."""
    shown = subprocess.run(["ctest", "--test-dir", os.environ["EDGECASE_BUILD"],
                            "--show-only=json-v1"], capture_output=True, text=True, check=True)
    tests = []
    for test in json.loads(shown.stdout)["tests"]:
        properties = {entry["name"]: entry["value"] for entry in test["properties"]}
        variables = dict(word.split("=", 1) for word in properties.get("ENVIRONMENT", []))
        tests.append({"name": test["name"], "labels": properties.get("LABELS", []),
                      "share": variables.get("EDGECASE_SHARE", ""),
                      "sets_up": bool(properties.get("FIXTURES_SETUP")),
                      "cost": properties.get("COST", 0)})
    return tests


def faults_of(tests):
    """What is wrong with the tiers, in words."""
    shares = {test["name"]: test["share"] for test in tests if "all" in test["labels"]}
    for test in tests:
        name, labels = test["name"], test["labels"]
        turns = [label for label in labels if label in TURNS]
        if "quick" not in labels and "all" not in labels:
            yield f"{name} is in no tier"
        # What makes a fixture runs with each test that reads it.
        if "all" in labels and "quick" not in labels and not test["sets_up"] and len(turns) != 1:
            yield f"{name} is in {len(turns)} turns"
        if "all" not in labels and f"{name}.1" not in shares:
            yield f"{name} is asked a share, and nothing asks the rest"
    for name in {PART.fullmatch(name)[1] for name in shares if PART.fullmatch(name)}:
        parts = sorted(share for part, share in shares.items() if part.startswith(f"{name}.")
                       and PART.fullmatch(part) and PART.fullmatch(part)[1] == name)
        wanted = sorted(f"{i + 1}/{len(parts)}" for i in range(len(parts)))
        if parts != wanted:
            yield f"{name} asks the shares {parts}"


class Tiers(unittest.TestCase):
    def setUp(self):
        self.tests = registered()

    def test_nothing_is_lost(self):
        self.assertGreater(len(self.tests), 100)
        self.assertEqual(list(faults_of(self.tests)), [])

    def test_turns_take_about_the_same_time(self):
        seconds = Counter()
        for test in self.tests:
            for label in set(test["labels"]) & set(TURNS):
                seconds[label] += test["cost"]
        longest = max(test["cost"] for test in self.tests)
        self.assertEqual(sorted(seconds), TURNS)
        self.assertLessEqual(max(seconds.values()) - min(seconds.values()), longest)

    def test_a_loss_is_noticed(self):
        full = next(i for i, test in enumerate(self.tests) if PART.fullmatch(test["name"])
                    and not test["sets_up"])
        for change in ({"labels": ["all"]}, {"labels": []}, {"share": "2/1"},
                       {"labels": ["all", "turn-1", "turn-2"]}):
            tests = copy.deepcopy(self.tests)
            tests[full].update(change)
            self.assertNotEqual(list(faults_of(tests)), [], change)


if __name__ == "__main__":
    unittest.main()
