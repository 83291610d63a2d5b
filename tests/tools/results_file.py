# SPDX-License-Identifier: MIT
"""Results files (src/results/results_json.h) as tests read, change and write them.

A file's results are one object here: the members of its first and last line, and "cases", each with
"id" and the members of its head. What the file leaves out is there, as it is meant.
"""
import copy
import json
import subprocess

MAGIC = b"\x28\xb5\x2f\xfd"  # of Zstandard
HEAD = {"title": "", "why": "", "spec": "", "origin": ""}
RESULT = {"fingerprint": "", "standing": "expected", "standing_reason": "", "disagreements": [],
          "values": [], "evidence": [], "illegal_line_snaps": [], "refuted": ""}
DISAGREEMENT = {"sample": 0, "primitive": -1, "cause": "", "situation": "", "ruling": 0, "exact": [],
                "rendered": [], "explanation": ""}
HEAD_MEMBERS = ("file", "file_digest", "title", "why", "rules", "spec", "origin", "tags", "surface",
                "width", "height", "viewport")


def unpacked(data):
    """The text of a file."""
    if data.startswith(MAGIC):
        data = subprocess.run(["zstdcat"], input=data, capture_output=True, check=True).stdout
    return data.decode("utf-8")


def lines_of(path):
    """The lines of a file, one after the other: all of a large one would fill the memory."""
    with path.open("rb") as file:
        is_packed = file.read(len(MAGIC)) == MAGIC
    with subprocess.Popen(["zstdcat" if is_packed else "cat", path], stdout=subprocess.PIPE,
                          encoding="utf-8") as program:
        yield from program.stdout


def completed_case(case, heads):
    head = {key: value for key, value in heads[case.pop("head")].items() if key != "head"}
    case = {"id": case.pop("case"), **HEAD, **head, "expect_failures": [], **case}
    area = case["width"] * case["height"]
    counts = dict(agree=area, convention=0, permitted=0, contested=0, violation=0, same=area)
    for renderer, result in case["results"].items():
        more = {} if "failure" in result else {"pixel_counts": counts}
        result = case["results"][renderer] = {**copy.deepcopy(RESULT), **more, **result}
        result["disagreements"] = [{**DISAGREEMENT, **d} for d in result["disagreements"]]
    return case


def cases_of(path):
    """The cases of a file, one after the other."""
    return cases_in(lines_of(path))


def cases_in(lines):
    heads = []
    for line in lines:
        told = json.loads(line)
        if "case" in told:
            yield completed_case(told, heads)
        elif "head" in told:
            heads.append(told)


def head_of(path):
    """What a file says beside its cases."""
    return head_in(lines_of(path))


def head_in(lines):
    told = {}
    for line in lines:
        if not line.startswith(('{"case"', '{"head"')):
            told.update(json.loads(line))
    del told["end"], told["cases"]
    return told


def parsed(text):
    lines = text.splitlines()
    return {**head_in(lines), "cases": list(cases_in(lines))}


def read(path):
    return parsed(unpacked(path.read_bytes()))


def text_of(results):
    """The lines of a file, not packed."""
    first = {"edgecase_results": 2, **{key: results[key] for key in (
        "tool", "policy", "latitude", "policy_digest", "whole_suite", "shard", "renderers")
        if key in results}}
    last = {"end": True, "cases": len(results["cases"]), "left_out": results.get("left_out", 0),
            **{key: results[key] for key in ("interrupted", "diagnostics", "faults")}}
    lines = [first]
    for number, case in enumerate(results["cases"]):
        lines.append({"head": number, **{key: case[key] for key in HEAD_MEMBERS if key in case}})
        lines.append({"case": case["id"], "head": number, **{
            key: value for key, value in case.items() if key not in (*HEAD_MEMBERS, "id")}})
    return "".join(f"{json.dumps(line)}\n" for line in [*lines, last])


def words_of(text):
    """Packed words (src/results/packed_text.h)."""
    words = []
    for token in text.split():
        word, _, times = token.partition("*")
        words += [int(word, 16)] * int(times or 1)
    return words


def picture_of(case, result):
    """Pixels of a result, four bytes each."""
    width, pixels = case["width"], []
    for i, word in enumerate(words_of(case["pixels"])):
        left = pixels[i - 1] if i % width else bytes(4)
        below = pixels[i - width] if i >= width else bytes(4)
        corner = pixels[i - width - 1] if i % width and i >= width else bytes(4)
        pixels.append(bytes((w + a + b - c) % 256 for w, a, b, c in
                            zip(word.to_bytes(4, "big"), left, below, corner)))
    if "pixels" not in result:
        return pixels
    return [bytes(a ^ b for a, b in zip(pixel, word.to_bytes(4, "big")))
            for pixel, word in zip(pixels, words_of(result["pixels"]))]


def places_of(values):
    """The pixels at which values differ, each as often as it is told."""
    places, x, y = [], 0, 0
    for token in values["differing"].split():
        if token[0] == "y":
            x, y = 0, int(token[1:])
            continue
        token, _, times = token.partition("*")
        skip, _, count = token.partition("+")
        x += int(skip)
        for _ in range(int(count or 1)):
            places += [(x, y)] * int(times or 1)
            x += 1
    return places
