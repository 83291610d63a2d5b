# SPDX-License-Identifier: MIT
"""A program whose output or errors go to a terminal."""
import fcntl
import os
import pty
import struct
import subprocess
import termios
import threading

from support import PATIENCE

END = b"\0"  # behind what the program printed


def run_on_a_terminal(command, stream, columns=80, **options):
    """The exit code, and what the program wrote to its `stream` ("stdout" or "stderr"), a terminal
    of so many columns. Options go to Popen."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("4H", 40, columns, 0, 0))
    text = b""
    with subprocess.Popen(command, **{stream: theirs}, **options) as running:

        def tell_end():
            running.wait()
            os.write(theirs, END)

        # Whoever closes a terminal may lose what was not read from it yet.
        threading.Thread(target=tell_end).start()
        while not text.endswith(END):
            text += os.read(ours, 65536)
        code = running.wait(timeout=PATIENCE)
    os.close(theirs)
    os.close(ours)
    return code, text.removesuffix(END).decode()
