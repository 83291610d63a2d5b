# SPDX-License-Identifier: MIT
"""A renderer that lies or fails: odd_renderer.py BEHAVIOUR TRUTH [VICTIM]

TRUTH is what `edgecase render --json` wrote of the exact side; any answer starts from there. VICTIM
is the id of the case at which a failing renderer fails.
"""
import json
import os
import pathlib
import re
import resource
import signal
import sys
import time

GREY = [70, 80, 90, 255]


TOLD = ("pixels", "fragments", "depths", "stencils", "sample_pixels", "sample_positions")


def of_passes(truth, change):
    """The truth with each pass changed, where there are several; they alone have fragments."""
    return {key: truth[key] for key in ("pixels", "accumulated")} | {
        "passes": [change({**truth, **drawn}) for drawn in truth["passes"]]}


def image(truth, color, fragments):
    """One colour everywhere, and 0 where there is a depth or a stencil buffer."""
    area = truth["width"] * truth["height"]
    answer = {"pixels": color * area, "fragments": fragments(truth)}
    for key in {"depths", "stencils"} & truth.keys():
        answer[key] = [0] * len(truth[key])
    if "sample_pixels" in truth:
        answer["sample_pixels"] = color * (area * truth["samples"])
    return answer


def painted_with(truth, color, fragments):
    if "passes" not in truth:
        return image(truth, color, fragments)
    area = truth["width"] * truth["height"]
    return {**of_passes(truth, lambda drawn: image(drawn, color, fragments)),
            "pixels": color * area, "accumulated": [n / 255 for n in color] * area}


def honest(truth):
    if "passes" in truth:
        return {key: truth[key] for key in ("pixels", "accumulated", "passes")}
    return {key: truth[key] for key in TOLD if key in truth}


# Liars: the truth of the case and the previous answer (None at first) to an answer.

def constant(color):
    return lambda truth, _: painted_with(truth, color, lambda _: [])


def painted(truth, _):
    """A constant image, with fragments that are just right."""
    return painted_with(truth, GREY, lambda drawn: drawn["fragments"])


def first_fragments(truth, previous):
    """A constant image, with the fragments of the first case."""
    if previous is None:
        first_fragments.first = truth["fragments"]
    return painted_with(truth, GREY, lambda _: first_fragments.first)


def echo(truth, previous):
    """The previous case's answer. At first, nothing drawn on grey."""
    current = honest(truth)
    answer = echo.before or image(truth, GREY, lambda _: [])
    echo.before = current
    return answer


echo.before = None


def upside_down(values, width, height):
    """Of planes of so many rows of so many values each."""
    rows = [values[start:start + width] for start in range(0, len(values), width)]
    planes = [rows[start:start + height] for start in range(0, len(rows), height)]
    return [value for plane in planes for row in reversed(plane) for value in row]


def mirror_drawing(truth):
    """Pixel by pixel: within a pixel samples stay where they are."""
    width, height = truth["width"], truth["height"]
    answer = {"fragments": [dict(f, y=height - 1 - f["y"]) for f in truth["fragments"]]}
    for key, length in (("pixels", 4), ("sample_pixels", 4), ("depths", 1), ("stencils", 1)):
        if key in truth:
            answer[key] = upside_down(truth[key], length * width, height)
    return answer


def mirror(truth, _):
    if "passes" not in truth:
        return mirror_drawing(truth)
    size = 4 * truth["width"], truth["height"]
    return {**of_passes(truth, mirror_drawing), "pixels": upside_down(truth["pixels"], *size),
            "accumulated": upside_down(truth["accumulated"], *size)}


LIARS = {
    "black": constant([0, 0, 0, 255]),
    "white": constant([255, 255, 255, 255]),
    "grey": constant(GREY),
    "transparent": constant([0, 0, 0, 0]),
    "painted": painted,
    "first-fragments": first_fragments,
    "echo": echo,
    "mirror": mirror,
}


# Failures: the request and the honest answer to an answer, or to an end.

def leave_mark():
    """A byte in the file TRUTH.marks: a test waits for it."""
    with open(sys.argv[2] + ".marks", "ab") as marks:
        marks.write(b".")


def hang(*_):
    leave_mark()
    time.sleep(3600)


def await_death(*_):
    """Writes its number to the file TRUTH.pid: a test kills it."""
    with open(sys.argv[2] + ".part", "w") as file:
        file.write(str(os.getpid()))
    os.rename(sys.argv[2] + ".part", sys.argv[2] + ".pid")
    time.sleep(3600)


def late(_, answer):
    time.sleep(3)
    return answer


def die(*_):
    os._exit(7)


def die_by_signal(*_):
    os.kill(os.getpid(), signal.SIGKILL)


def crash(*_):
    os.abort()


def stop(*_):
    os.kill(os.getpid(), signal.SIGSTOP)


def out_of_memory(*_):
    """Wants more than it is allowed to have."""
    resource.setrlimit(resource.RLIMIT_AS, (1 << 28, 1 << 28))
    return bytearray(1 << 30)


def garbage(*_):
    print("this is no JSON", flush=True)
    return None


def bytes_of_no_text(*_):
    os.write(1, b"\xff\xfe\x00{\x80\n")


def endless_line(*_):
    """Until nobody reads it any more."""
    while True:
        os.write(1, b"0," * 65536)


def half_an_answer(_, answer):
    text = json.dumps(answer)
    os.write(1, text[:len(text) // 2].encode())
    time.sleep(3600)


def number_that_is_none(_, answer):
    return dict(answer, pixels=[float("nan")] + answer["pixels"][1:])


def twice(request, answer):
    line = json.dumps({"digest": request["digest"], **answer}) + "\n"
    os.write(1, line.encode() * 2)


def close_output(*_):
    os.close(1)
    time.sleep(3600)


def refuse(request, _):
    return {"not_run": "not today"}


def another_digest(_, answer):
    return dict(answer, digest="0123456789abcdef")


def wrong_size(_, answer):
    return dict(answer, pixels=answer["pixels"][4:])


def far_fragment(_, answer):
    return dict(answer, fragments=[{"x": 1000, "y": 0, "primitive": 0}])


def wrong_hits(_, answer):
    return dict(answer, hits=[9] * (len(answer["pixels"]) // 4))


def nan_colors(_, answer):
    fragments = [dict(f, color=["nan"] * 4) for f in answer["fragments"]]
    return dict(answer, fragments=fragments)


def infinite_depths(_, answer):
    fragments = [dict(f, depth="inf") for f in answer["fragments"]]
    return dict(answer, fragments=fragments)


def nap(_, answer):
    leave_mark()
    time.sleep(.2)
    return answer


FAILURES = {function.__name__.replace("_", "-"): function for function in (
    hang, await_death, late, die, die_by_signal, crash, stop, out_of_memory, garbage,
    bytes_of_no_text, endless_line, half_an_answer, number_that_is_none, twice, close_output, refuse,
    another_digest, wrong_size, far_fragment, wrong_hits, nan_colors, infinite_depths, nap)}


# Waverers: a case answered in one way the first time that anyone asks for it, in TRUTH.asked, and
# honestly from then on; "mirror-of" never learns.

def asked_before(name):
    path = pathlib.Path(sys.argv[2] + ".asked")
    names = path.read_text("utf-8").splitlines() if path.exists() else []
    path.write_text("\n".join(names + [name]), "utf-8")
    return name in names


WAVERERS = {
    "waver": lambda truth: mirror(truth, None),
    "refuse-once": lambda truth: {"not_run": "not yet"},
    "die-once": die,
    "mirror-of": lambda truth: mirror(truth, None),
}


class Truths:
    """Renderings by id, each read when it is asked for. A program that a test starts again and
    again must not read the whole suite each time: where each one lies is kept beside the file."""

    def __init__(self, path):
        self.path = pathlib.Path(path).resolve()
        self.places = self.kept_places() or self.found_places()

    def index(self):
        return self.path.with_suffix(".index")

    def state(self):
        """What changes when the file does."""
        stat = self.path.stat()
        return [stat.st_size, stat.st_mtime_ns]

    def kept_places(self):
        try:
            kept = json.loads(self.index().read_bytes())
        except FileNotFoundError:
            return None
        return kept["places"] if kept["state"] == self.state() else None

    def found_places(self):
        places, offset = {}, 0
        with self.path.open("rb") as lines:
            for line in lines:
                name = re.match(rb'{"id":("(?:[^"\\]|\\.)*")', line)[1]
                places[json.loads(name)] = offset
                offset += len(line)
        part = self.index().with_suffix(f".{os.getpid()}.part")
        part.write_text(json.dumps({"state": self.state(), "places": places}), "utf-8")
        part.replace(self.index())
        return places

    def get(self, name):
        if name not in self.places:
            return None
        with self.path.open("rb") as lines:
            lines.seek(self.places[name])
            return json.loads(lines.readline())


def answers(behaviour, truths, victim):
    previous = None
    for count, line in enumerate(sys.stdin, 1):
        request = json.loads(line)
        truth = truths.get(request["id"])
        if truth is None and behaviour in LIARS:  # an image of a scene
            yield {"digest": request["digest"], "not_run": "a scene without a truth"}
            continue
        if behaviour == "third" and count == 3:
            die()
        if behaviour in LIARS:
            answer = previous = LIARS[behaviour](truth, previous)
        else:
            answer = honest(truth) if truth else {"not_run": "a case without a truth"}
            if behaviour in WAVERERS and victim in ("", request["id"]) and (
                    behaviour == "mirror-of" or not asked_before(request["id"])):
                answer = WAVERERS[behaviour](truth)
            if behaviour in FAILURES and victim in ("", request["id"]):
                answer = FAILURES[behaviour](request, answer)
        if answer is not None:
            yield {"digest": request["digest"], **answer}


def main():
    behaviour, path, *victim = sys.argv[1:]
    for answer in answers(behaviour, Truths(path), victim[0] if victim else ""):
        answer.setdefault("renderer", {"device": behaviour, "subpixel_bits": 8})
        print(json.dumps(answer), flush=True)


main()
