# SPDX-License-Identifier: MIT
"""How much of its scenes a test asks: share.h says what EDGECASE_SHARE is."""
import os
import re
import sys
import unittest


def share_of_environment():
    """(number, count): the share of this process, `number` from 1."""
    text = os.environ.get("EDGECASE_SHARE") or "1/1"
    found = re.fullmatch(r"(\d+)/(\d+)", text)
    number, count = map(int, found.groups()) if found else (0, 0)
    if not 1 <= number <= count:
        sys.exit(f"EDGECASE_SHARE is '{text}'; it has to be I/N with 1 <= I <= N, as in 1/8")
    if count > 1:
        print(f"share {number} of {count}; to ask it again: EDGECASE_SHARE={number}/{count}")
    return number, count


NUMBER, COUNT = share_of_environment()


def in_share(items):
    """The items of this share: each item is in exactly one."""
    return list(items)[NUMBER - 1::COUNT]


def least_of(count):
    """How often something has to be seen in this share that is seen `count` times in all of them:
    half of its part, as share.h has it, since sweeps do not deal their values evenly."""
    return count if COUNT == 1 else count / COUNT / 2


# No test of the full tier has as many parts as the quick tier has shares.
IS_QUICK = COUNT >= 16


def in_full_tier(test):
    """Decorates a test that the first part of the full tier asks, and the quick tier does not."""
    return unittest.skipIf(IS_QUICK or NUMBER > 1, "the full tier asks this, once")(test)
