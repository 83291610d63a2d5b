# SPDX-License-Identifier: MIT
"""A project's file takes effect unasked, so it has to be the user's own, its programs wait for a
word, and what it lets commands write stays in its folder."""
import grp
import os
import pathlib
import pty
import shutil
import struct
import subprocess
import tempfile
import unittest

import results_file
from support import (BIN, EDGECASE, INTERNAL, PATIENCE, ROOT, USAGE, CommandTest,
                     environment, triangle_case)
from two_users import NOBODY, as_nobody, give_to_nobody, needs_root

# Says that it was started, and draws nothing.
PROGRAM = "echo started >> started; while read line; do echo '{\"not_run\": \"no\"}'; done\n"
PROJECT = 'cases = "cases"\n[renderers]\nmine = "exec:sh program.sh"\nours = "exact"\n'
TOLD = "it names what you have not allowed to run: mine = exec:sh program.sh; allow it with --trust"


class TrustTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.top = self.folder
        self.caches = self.folder / "caches"
        self.make_project("project")

    def make_project(self, name, text=PROJECT):
        """A project in a folder of its own, in which commands run then."""
        self.folder = self.top / name
        self.write("cases/plain.json", triangle_case())
        self.write("program.sh", PROGRAM)
        self.write("edgecase.toml", text)

    def command(self, *arguments, **more):
        return super().command(*arguments, **{"XDG_CACHE_HOME": str(self.caches), **more})

    def starts(self):
        """How often the program was started since the last look."""
        started = self.folder / "started"
        count = len(started.read_text("utf-8").splitlines()) if started.exists() else 0
        started.unlink(missing_ok=True)
        return count

    def refused(self, *words, **more):
        """Why a run ends before it begins."""
        told = self.command("run", *words, expect=USAGE, **more)
        self.assertEqual((told.stdout, self.starts()), ("", 0))
        return told.stderr


class Word(TrustTest):
    def test_the_first_line_says_which_file_is_used(self):
        self.folder = self.folder / "cases"
        told = self.command("run", "--against", "ours", "--json", "r.json").stderr
        self.assertEqual(told.splitlines()[0],
                         f"edgecase: the project is {self.top}/project/edgecase.toml")

    def test_programs_wait_for_a_word_which_is_remembered(self):
        self.assertIn(f"{self.folder}/edgecase.toml: {TOLD}", self.refused())
        self.command("run", "--trust", expect=None)
        self.assertGreater(self.starts(), 0)
        self.command("run", expect=None)
        self.assertGreater(self.starts(), 0)
        # From any folder of the project.
        self.folder = self.folder / "cases"
        self.command("run", "--json", "r.json", expect=None)
        self.folder = self.folder.parent
        self.assertGreater(self.starts(), 0)
        for changed in (PROJECT + "# a word more\n", PROJECT.replace('"exact"', '"egl:softpipe"')):
            self.write("edgecase.toml", changed)
            self.assertIn(TOLD, self.refused())
        # As it was.
        self.write("edgecase.toml", PROJECT)
        self.command("run", expect=None)
        self.assertGreater(self.starts(), 0)

    def test_the_word_is_about_one_place(self):
        self.command("run", "--trust", expect=None)
        self.make_project("elsewhere")
        self.assertIn(TOLD, self.refused())

    def test_ci_means_no_word(self):
        self.assertIn(TOLD, self.refused(CI="true", GITHUB_ACTIONS="true"))

    def test_every_command_that_starts_programs_asks(self):
        case = "cases/plain.json"
        for words in (["run"], ["run", "--against", "mine"], ["explain", case, "--against", "mine"],
                      ["fuzz", "--count", "1"], ["profile", "--against", "mine"],
                      ["minimize", case, "--against", "mine"], ["draw", case, "--against", "mine"],
                      ["record", "--against", "mine", "-o", "mine.rec"],
                      ["render", case, "--with", "mine"],
                      ["gallery", "cs184", "--against", "mine", "--suite", ROOT / "cases"]):
            with self.subTest(words[0]):
                told = self.command(*words, expect=USAGE)
                self.assertIn(TOLD, told.stderr)
                self.assertEqual(self.starts(), 0)

    def test_what_starts_no_program_of_the_file_needs_no_word(self):
        for words in (["run", "--list"], ["explain", "cases/plain.json"],
                      ["run", "--against", "ours"]):
            self.command(*words)
        # A renderer of the command line is the user's own word, and of the user's own folder.
        self.folder = self.folder / "cases"
        self.write("program.sh", PROGRAM)
        self.command("run", "--against", "mine=exec:sh program.sh", "--json", "r.json", expect=None)
        self.assertGreater(self.starts(), 0)
        self.folder = self.top / "project"
        self.assertEqual(self.starts(), 0)

    def test_a_library_is_code_too_and_so_is_what_has_another_name(self):
        for address in ("egl:lib=here.so", "egl-es:lib=here", "name=exec:sh program.sh",
                        "a=b=egl:lib=here"):
            self.write("edgecase.toml", f'[renderers]\nmine = "{address}"\n')
            self.assertIn(f"not allowed to run: mine = {address};", self.refused())

    def test_googletest_has_a_variable(self):
        gtest = str(BIN / "edgecase-gtest")
        names = self.command("--gtest_list_tests", program=gtest).stdout
        self.assertIn("plain", names)
        self.assertIn(TOLD, self.command(program=gtest, expect=USAGE).stderr)
        self.command(program=gtest, expect=None, EDGECASE_TRUST="0", EDGECASE_AGAINST="ours")
        self.assertEqual(self.starts(), 0)
        self.command(program=gtest, expect=None, EDGECASE_TRUST="1")
        self.assertGreater(self.starts(), 0)

    def asked(self, answer):
        """The exit code of a run on a terminal, whom somebody answers, and what it asked."""
        ours, theirs = pty.openpty()
        with subprocess.Popen([EDGECASE, "run", "--progress", "never"], cwd=self.folder,
                              stdin=theirs, stderr=theirs, stdout=subprocess.DEVNULL,
                              env=environment(XDG_CACHE_HOME=str(self.caches))) as running:
            os.close(theirs)
            told = b""
            try:
                while b"[y/N] " not in told:
                    told += os.read(ours, 4096)
                os.write(ours, answer)
                while True:
                    told += os.read(ours, 4096)
            except OSError:  # the terminal's end
                pass
            code = running.wait(PATIENCE)
        os.close(ours)
        return code, told.decode()

    def test_a_terminal_is_asked(self):
        for answer in (b"\n", b"n\n", b"yellow\n", b"\x04"):
            code, told = self.asked(answer)
            self.assertEqual((code, self.starts()), (USAGE, 0))
            self.assertIn("  mine = exec:sh program.sh", told)
        code, _ = self.asked(b"y\n")
        self.assertNotEqual(code, USAGE)
        self.assertGreater(self.starts(), 0)
        self.command("run", expect=None)
        self.assertGreater(self.starts(), 0)


class Place(TrustTest):
    def test_a_file_that_others_can_write_is_refused(self):
        toml = self.folder / "edgecase.toml"
        for path, mode, words in ((toml, 0o666, "others may write the file"),
                                  (self.folder, 0o777, "others may write into the folder"),
                                  (self.folder, 0o1777, "others may write into the folder"),
                                  (self.top, 0o777, "others may write into the folder")):
            with self.subTest(words, path=path):
                before = path.stat().st_mode
                path.chmod(mode)
                told = self.refused("--trust")
                self.assertIn(f"{toml}: it is not used unasked, since {words} {path}; use it with "
                              "--config edgecase.toml, or none with --config /dev/null", told)
                # Who names it has asked for it; its programs wait for a word each time.
                self.assertIn("is not remembered, since others can write the file",
                              self.refused("--config", "edgecase.toml"))
                self.command("run", "--config", "edgecase.toml", "--trust", expect=None)
                self.assertGreater(self.starts(), 0)
                self.assertIn(TOLD, self.refused("--config", "edgecase.toml"))
                self.command("run", "cases", "--config", "/dev/null", "--against", "exact")
                path.chmod(before)
        self.command("run", "--against", "ours")

    def test_a_sticky_folder_above_does(self):
        self.top.chmod(0o1777)
        self.command("run", "--against", "ours")

    def test_a_link_counts_as_all_that_it_leads_through(self):
        self.make_project("open")
        real = self.top / "project/edgecase.toml"
        link = self.folder / "edgecase.toml"
        link.unlink()
        link.symlink_to(real)
        self.command("run", "--against", "ours")
        real.chmod(0o666)
        self.assertIn(f"others may write the file {real}", self.refused())
        real.chmod(0o644)
        real.parent.chmod(0o777)
        self.assertIn(f"others may write into the folder {real.parent}", self.refused())

    @unittest.skipIf(os.geteuid() != 0, "not run: only the superuser can set groups")
    def test_a_group_of_others_is_others(self):
        """A group of the owner's name and alone is the owner."""
        self.folder.chmod(0o775)
        self.command("run", "--against", "ours")
        os.chown(self.folder, 0, grp.getgrnam("users").gr_gid)
        self.assertIn("others may write into the folder", self.refused())
        os.chown(self.folder, 0, 0)
        self.command("run", "--against", "ours")
        # An access control list: nobody may write, too.
        try:
            os.setxattr(self.folder, "system.posix_acl_access", struct.pack(
                "<I" + 5 * "HHI", 2, 0x01, 7, 2**32 - 1, 0x02, 7, 65534, 0x04, 5, 2**32 - 1,
                0x10, 7, 2**32 - 1, 0x20, 5, 2**32 - 1))
        except OSError as error:
            self.skipTest(f"not run: {self.folder} has no access control lists: {error}")
        self.assertEqual(self.folder.stat().st_mode & 0o777, 0o775)
        self.assertIn("others may write into the folder", self.refused())


class Outputs(TrustTest):
    def test_outputs_stay_in_the_folder(self):
        (self.folder / "way").symlink_to("../elsewhere")
        (self.folder / "loop").symlink_to("loop")
        (self.folder / "file.json").symlink_to("../elsewhere/not-yet.json")
        (self.folder / "cases/back").symlink_to("..")
        for key, value in (("json", "../r.json"), ("html", f"{self.top}/r.html"),
                           ("json", f"{self.folder}/r.json"), ("json", "way/r.json"),
                           ("json", "out/../../r.json"), ("json", "file.json"),
                           ("json", "loop/r.json"), ("json", "cases/back/../r.json/../../..")):
            with self.subTest(value):
                self.write("edgecase.toml", PROJECT + f'[outputs]\n{key} = "{value}"\n')
                told = self.command("run", "--against", "ours", expect=USAGE)
                self.assertIn(f'edgecase.toml:6: {key} = "{value}" is outside of the project\'s '
                              f"folder; name a path in it, or give --{key} on the command line",
                              told.stderr)
        self.assertEqual([one.name for one in self.top.iterdir()], ["project"])
        # The command line may.
        self.write("edgecase.toml", PROJECT)
        self.command("run", "--against", "ours", "--json", self.top / "r.json")

    def test_links_within_the_folder_do(self):
        (self.folder / "built").mkdir()
        (self.folder / "out").symlink_to("built")
        # The text of a path is what counts, as it is what is opened: "..", too.
        for value in ("out/new/r.json", "out/../../project/built/new/r.json"):
            self.write("edgecase.toml", PROJECT + f'[outputs]\njson = "{value}"\n')
            self.command("run", "--against", "ours")
            results_file.read(self.folder / "built/new/r.json")
            shutil.rmtree(self.folder / "built/new")

    def test_known_faults_are_read_from_anywhere_and_written_in_the_folder(self):
        (self.top / "known").mkdir()
        self.write("edgecase.toml", 'known = "../known"\n' + PROJECT)
        self.command("run", "--against", "ours", "--json", "r.json")
        told = self.command("bless", "r.json", "--apply", expect=USAGE).stderr
        self.assertIn('known = "../known" is outside of the project\'s folder; name a path in it, '
                      "or give --folder on the command line", told)
        self.command("bless", "r.json", "--apply", "--folder", "../known")


@needs_root
class TwoUsers(CommandTest):
    """In a folder that both can enter."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="edgecase-two-", dir="/tmp")
        self.addCleanup(folder.cleanup)
        self.folder = self.shared = pathlib.Path(folder.name)
        self.shared.chmod(0o755)
        self.edgecase = shutil.copy(EDGECASE, self.shared)
        self.make("roots")
        self.make("nobodys")
        give_to_nobody(self.shared / "nobodys")

    def make(self, name):
        """A project of which a run overwrites `precious`, in whose folder `work` somebody works."""
        self.folder = self.shared / name
        self.write("work/cases/plain.json", triangle_case())
        self.write("program.sh", PROGRAM)
        self.write("precious", "precious")
        self.write("edgecase.toml", PROJECT + '[outputs]\njson = "precious"\n')
        # Whoever is started may say so.
        self.write("started", "").chmod(0o666)

    def is_as_before(self, name):
        folder = self.shared / name
        self.assertEqual((folder / "started").read_text("utf-8"), "")
        self.assertEqual((folder / "precious").read_text("utf-8"), "precious")

    def test_a_file_of_nobody_does_nothing_for_root(self):
        work = self.shared / "nobodys/work"
        os.chown(work, 0, 0)
        self.folder = work
        for words in (["run"], ["run", "--trust"], ["fuzz", "--count", "1"], ["bless"]):
            told = self.command(*words, expect=USAGE, XDG_CACHE_HOME=str(self.shared / "caches"))
            self.assertIn(f"{self.shared}/nobodys belongs to the user {NOBODY}", told.stderr)
            self.assertEqual(told.stdout, "")
        self.is_as_before("nobodys")

    def test_a_link_of_nobody_does_not_either(self):
        self.folder = self.shared / "roots/work"
        (self.folder / "edgecase.toml").symlink_to(self.shared / "nobodys/edgecase.toml")
        told = self.command("run", "--trust", expect=USAGE).stderr
        self.assertIn(f"belongs to the user {NOBODY}", told)
        os.chown(self.folder / "edgecase.toml", 65534, 65534, follow_symlinks=False)
        told = self.command("run", "--trust", expect=USAGE).stderr
        self.assertIn(f"{self.folder}/edgecase.toml belongs to the user {NOBODY}", told)
        self.is_as_before("nobodys")

    def test_a_file_of_root_may_be_used_and_what_is_roots_stays(self):
        caches = self.shared / "caches-of-nobody"
        caches.mkdir()
        give_to_nobody(caches)
        told = as_nobody([self.edgecase, "run", "cases"], self.shared / "roots/work",
                         XDG_CACHE_HOME=str(caches))
        self.assertEqual(told.returncode, USAGE, told.stderr)
        self.assertIn(TOLD, told.stderr)
        as_nobody([self.edgecase, "run", "cases", "--trust"], self.shared / "roots/work",
                  XDG_CACHE_HOME=str(caches))
        self.assertEqual((self.shared / "roots/precious").read_text("utf-8"), "precious")
        # The word is nobody's, not root's.
        self.folder = self.shared / "roots/work"
        told = self.command("run", expect=USAGE, XDG_CACHE_HOME=str(self.shared / "caches"))
        self.assertIn(TOLD, told.stderr)
        told = self.command("run", expect=USAGE, XDG_CACHE_HOME=str(caches))
        self.assertIn(TOLD, told.stderr)

    def test_outputs_do_not_go_where_a_link_of_nobody_leads(self):
        """Nor may others write what another user let everybody write."""
        self.folder = self.shared
        shared = self.shared / "like-tmp"
        shared.mkdir()
        precious = self.write("precious", "precious")
        pictures = self.shared / "pictures"
        pictures.mkdir()
        for name, target in (("r.json", precious), ("new.json", self.shared / "new"),
                             ("out", self.shared), ("pictures", pictures)):
            (shared / name).symlink_to(target)
        (shared / "open.json").write_text("{}", encoding="utf-8")
        give_to_nobody(shared)
        (shared / "open.json").chmod(0o666)
        shared.chmod(0o1777)
        self.write("cases/plain.json", triangle_case())
        run = ("run", "cases", "--against", "exact", "--json")
        for words in ((*run, shared / "r.json"), (*run, shared / "new.json"),
                      (*run, shared / "out/precious"), (*run, "-", "--csv", shared / "r.json"),
                      ("render", "cases", "--png", shared / "pictures")):
            told = self.command(*words, expect=INTERNAL, XDG_CACHE_HOME=str(self.shared / "caches"))
            self.assertRegex(told.stderr, f"the link {shared}/[a-z.]+ belongs to another user; "
                                          "name where it leads")
        self.assertEqual(precious.read_text("utf-8"), "precious")
        self.assertFalse((self.shared / "new").exists())
        self.assertEqual(list(pictures.iterdir()), [])
        self.command(*run, shared / "open.json", XDG_CACHE_HOME=str(self.shared / "caches"))
        self.assertEqual((shared / "open.json").stat().st_uid, 0)
        self.assertEqual((shared / "open.json").stat().st_mode & 0o022, 0)

    def test_nobody_has_a_project_too(self):
        caches = self.shared / "nobodys"
        told = as_nobody([self.edgecase, "run", "cases", "--trust"], self.shared / "nobodys/work",
                         XDG_CACHE_HOME=str(caches))
        self.assertNotEqual(told.returncode, USAGE, told.stderr)
        self.assertIn("started", (self.shared / "nobodys/started").read_text("utf-8"))


if __name__ == "__main__":
    unittest.main()
