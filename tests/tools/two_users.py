# SPDX-License-Identifier: MIT
"""What tests as another user of the machine: nobody, whom only the superuser can be."""
import os
import pathlib
import pwd
import subprocess
import unittest

from support import PATIENCE, environment

NOBODY = "nobody"
needs_root = unittest.skipIf(os.geteuid() != 0, "not run: only the superuser can be two users")


def as_nobody(command, folder, **variables):
    """Runs a command as nobody in a folder; the finished process."""
    return subprocess.run(list(map(str, command)), cwd=folder, user=NOBODY,
                          group=pwd.getpwnam(NOBODY).pw_gid, extra_groups=[],
                          env=environment(**variables), stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=PATIENCE, check=False)


def give_to_nobody(path):
    """A file or folder, and all in it."""
    path = pathlib.Path(path)
    for one in [path, *path.rglob("*")]:
        os.chown(one, pwd.getpwnam(NOBODY).pw_uid, pwd.getpwnam(NOBODY).pw_gid,
                 follow_symlinks=False)
