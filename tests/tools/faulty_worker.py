# SPDX-License-Identifier: MIT
"""Stands for edgecase-gl: faulty_worker.py FAULT VICTIM WORKER ARGUMENT...

Passes messages (eight bytes of length, then so many bytes) on to the real worker and back, until
the case VICTIM is asked for, and then shows the fault.
"""
import os
import resource
import signal
import struct
import subprocess
import sys


def read_message(stream):
    head = stream.read(8)
    if len(head) < 8:
        return None
    (length,) = struct.unpack("=Q", head)
    return stream.read(length)


def write_message(stream, message):
    stream.write(struct.pack("=Q", len(message)) + message)
    stream.flush()


class Link:
    """The real worker, and whoever asks it."""

    def __init__(self, command):
        self.worker = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.last = b""

    def ask(self, request):
        write_message(self.worker.stdin, request)
        answer = read_message(self.worker.stdout)
        if answer is None:
            die_as(self.worker.wait())
        return answer

    def answer(self, answer):
        self.last = answer
        write_message(sys.stdout.buffer, answer)


def die_as(status):
    """As subprocess tells it: negative, a signal."""
    if status < 0:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        os.kill(os.getpid(), -status)
    os._exit(status)


def kill(link, _):
    """Killed by others, as the kernel does when memory runs out."""
    link.worker.kill()
    die_as(link.worker.wait())


def stop(link, _):
    link.worker.send_signal(signal.SIGSTOP)
    os.kill(os.getpid(), signal.SIGSTOP)


def starve(link, request):
    """It gets no more memory than it has."""
    status = open(f"/proc/{link.worker.pid}/status", encoding="utf-8").read()
    kibibytes = int(status.split("VmSize:")[1].split()[0])
    limit = 1024 * kibibytes
    resource.prlimit(link.worker.pid, resource.RLIMIT_AS, (limit, limit))
    link.answer(link.ask(request))


def noise(link, request):
    link.answer(b"\xff" * len(link.ask(request)))


def cut(link, request):
    answer = link.ask(request)
    link.answer(answer[:len(answer) // 2])


def empty(link, _):
    link.answer(b"")


def endless(*_):
    """A length that no answer has, and what might be its beginning."""
    sys.stdout.buffer.write(struct.pack("=Q", 1 << 62) + bytes(1000))
    sys.stdout.buffer.flush()


def echo(link, _):
    """The answer to the request before."""
    link.answer(link.last)


def half(link, request):
    """As much as fits, then silence."""
    answer = link.ask(request)
    sys.stdout.buffer.write(struct.pack("=Q", len(answer)) + answer[:len(answer) // 2])
    sys.stdout.buffer.flush()
    stop(link, request)


FAULTS = {function.__name__: function
          for function in (kill, stop, starve, noise, cut, empty, endless, echo, half)}


def main():
    fault, victim, *command = sys.argv[1:]
    link = Link(command)
    while (request := read_message(sys.stdin.buffer)) is not None:
        if victim.encode() in request:
            FAULTS[fault](link, request)
        else:
            link.answer(link.ask(request))


main()
