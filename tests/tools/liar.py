# SPDX-License-Identifier: MIT
"""A renderer that tells one lie about everything: liar.py KIND TRUTH

TRUTH is what `edgecase render --json` wrote of an honest renderer. Each answer is that renderer's,
spoilt in one way of liar_kinds.py. The file TRUTH.KIND gets a line for each case of which the
answer then says something else: its id, a space, and a digest of what is drawn.
"""
import hashlib
import json
import re
import sys

from liar_kinds import KINDS, PLANES

# What an answer may have (reference/PROTOCOL.md); a rendering has more.
KEYS = ("pixels", "fragments", "depths", "stencils", "sample_pixels", "sample_positions", "hits",
        "passes", "accumulated", "mip_chains")
ID = re.compile(rb'\{"id":"([^"\\]+)"')


def place(fragment):
    return [fragment.get(key, 1) for key in ("y", "x", "primitive", "coverage")]


def says_otherwise(told, honest):
    """Does an answer contradict another? What it leaves out contradicts nothing."""
    if any(told.get(key) and told[key] != honest.get(key) for key in PLANES):
        return True
    if "passes" in told:
        return any(map(says_otherwise, told["passes"], honest["passes"]))
    ones, others = (sorted(answer["fragments"], key=place) for answer in (told, honest))
    if list(map(place, ones)) != list(map(place, others)):
        return True
    return any(key in one and one[key] != other[key]
               for one, other in zip(ones, others) for key in other)


def misplaces(answer, scene):
    """Are samples elsewhere than the scene requires?"""
    required = scene["target"].get("sample_positions")
    return bool(required) and answer.get("sample_positions", required) != required


def digest_of_drawn(answer):
    """Of all that stays in the target."""
    drawn = [answer.get(key) or None for key in ("pixels", "sample_pixels", "depths", "stencils")]
    return hashlib.sha256(json.dumps(drawn).encode()).hexdigest()


class Truth:
    """The honest answers, found by the case's id."""

    def __init__(self, path):
        self.file = open(path, "rb")
        self.places, at = {}, 0
        for line in self.file:
            self.places[ID.match(line)[1].decode()] = at
            at += len(line)

    def answer(self, name):
        if name not in self.places:
            return None
        self.file.seek(self.places[name])
        rendering = json.loads(self.file.readline())
        answer = {key: rendering[key] for key in KEYS if key in rendering}
        if "passes" in answer:
            for key in ("fragments", "depths", "hits", "mip_chains"):
                answer.pop(key, None)
        return answer


def main(kind, path):
    truth, before = Truth(path), None
    # Several processes may answer at once, and append a line each.
    with open(f"{path}.{kind}", "a", encoding="utf-8") as contradicted:
        for line in sys.stdin:
            request = json.loads(line)
            answer = truth.answer(request["id"])
            if answer is None:
                answer = {"not_run": "not among the honest answers"}
            else:
                KINDS[kind](answer, request["scene"], before)
                before, honest = truth.answer(request["id"]), truth.answer(request["id"])
                if says_otherwise(answer, honest) or misplaces(answer, request["scene"]):
                    print(request["id"], digest_of_drawn(answer), file=contradicted, flush=True)
            print(json.dumps({"digest": request["digest"], **answer}), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
