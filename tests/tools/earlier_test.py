# SPDX-License-Identifier: MIT
"""Answers that are, to the bit, what they were in the earlier results are not compared once more, and
nothing shows it but the time: whatever has changed, results and reports are those of a run that
knows no earlier one."""
import os
import re
import stat
import subprocess
import unittest

import results_file
from support import (REPORTS, SUITE, UNEXPECTED, CommandTest, contents,
                     report_options, triangle_case)

NAMES = [f"case-{n}" for n in range(8)]
# Of the whole suite, few cases of every folder.
SAMPLE = [SUITE, "--exclude", "scenes/*", "--sample", "1/440"]
MESA = ["--against", "egl:llvmpipe"]


def kept(run):
    """The number of answers that a run has not compared anew."""
    told = re.search(r"unexpected, (\d+) answers? as before, ", run.stdout.splitlines()[0])
    return int(told[1]) if told else 0


class Earlier(CommandTest):
    def run_to(self, name, *arguments, expect=None, **variables):
        """Runs into the folder `name`; how many answers are as in the results that lie there."""
        run = self.command("run", *arguments, *report_options(name), "--csv", f"{name}/csv",
                           expect=expect, **variables)
        return kept(run)

    def fresh(self, *arguments):
        """What a run writes that knows no earlier one."""
        self.assertEqual(self.run_to("fresh", *arguments, "--ask-all"), 0)
        return contents(self.folder / "fresh")

    def check(self, kept, *arguments):
        """So many answers are kept, and nothing else differs from a run that keeps none."""
        self.assertEqual(self.run_to("reports", *arguments), kept)
        written = contents(self.folder / "reports")
        for name, fresh in self.fresh(*arguments).items():
            self.assertTrue(written[name] == fresh, name)

    def read(self):
        return results_file.read(self.folder / "reports" / f"reports.{REPORTS[0]}")


class OfTheSuite(Earlier):
    def test_all_that_was_drawn_is_kept(self):
        self.assertEqual(self.run_to("reports", *SAMPLE, *MESA), 0)
        results = [case["results"]["egl:llvmpipe"] for case in self.read()["cases"]]
        drawn = sum("failure" not in result for result in results)
        self.assertGreater(sum(bool(result["values"]) for result in results), 10)
        self.assertGreater(sum(bool(result["disagreements"]) for result in results), 10)
        self.check(drawn, *SAMPLE, *MESA)
        self.assertEqual(self.run_to("reports", *SAMPLE, *MESA, "--ask-all"), 0)

    def test_another_policy_or_latitude(self):
        for changed in ["--policy", "vulkan-strict"], ["--policy", "profile"], ["--no-latitude"]:
            with self.subTest(changed):
                self.run_to("reports", *SAMPLE, *MESA)
                self.check(0, *SAMPLE, *MESA, *changed)

    def test_known_faults_and_strictness_are_not_what_was_found(self):
        self.run_to("reports", *SAMPLE, *MESA)
        drawn = self.run_to("reports", *SAMPLE, *MESA)
        (self.folder / "none").mkdir()
        for changed in ["--known", "none"], ["--strict"]:
            self.check(drawn, *SAMPLE, *MESA, *changed)

    def test_another_profile(self):
        self.copy_suite("textures/filter")
        arguments = ["cases", *MESA]
        self.run_to("reports", *arguments)
        (self.folder / "cases/profiles/egl-llvmpipe.json").unlink()
        self.check(0, *arguments)

    def test_more_renderers_and_fewer(self):
        both = [*SAMPLE, *MESA, "--against", "egl:softpipe"]
        self.run_to("reports", *SAMPLE, *MESA)
        # Where all agree, results have no pictures for the other renderer to be held against.
        results = [case["results"]["egl:llvmpipe"] for case in self.read()["cases"]]
        shown = sum("pixels" in case and case["results"]["egl:llvmpipe"]["verdict"] != "not-run"
                    for case in self.read()["cases"])
        self.check(shown, *both)
        drawn = sum("failure" not in result for result in results)
        self.check(drawn, *SAMPLE, *MESA)
        self.run_to("reports", *both)
        self.check(drawn, *SAMPLE, *MESA)


class OfTriangles(Earlier):
    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)
        self.right = ["cases", "--against", "mine=" + self.odd_renderer("mirror-of", "none", "cases")]
        self.wrong = ["cases", "--against", "mine=" + self.odd_renderer("mirror-of", "case-3", "cases")]
        self.run_to("reports", *self.right)

    def test_what_a_renderer_answers_otherwise_is_compared(self):
        self.check(7, *self.wrong)
        self.assertEqual(self.read()["cases"][3]["results"]["mine"]["verdict"], "violation")
        self.check(7, *self.right)
        self.check(8, *self.right)

    def test_an_answer_that_was_wrong_stays_wrong(self):
        self.run_to("reports", *self.wrong)
        self.assertEqual(self.run_to("reports", *self.wrong, expect=UNEXPECTED), 8)
        self.check(8, *self.wrong)

    def test_one_of_two_renderers(self):
        other = ["--against", "other=" + self.odd_renderer("mirror-of", "case-5", "cases")]
        self.run_to("reports", *self.right, *other)
        self.check(2, *self.wrong, *other)  # both of case 5, which alone has pictures
        self.check(4, *self.wrong, *other)
        self.check(3, *self.right, *other)

    def test_edited_and_new_cases(self):
        self.write("cases/case-3.json", triangle_case(title="Another"))
        self.write_cases("new")
        self.right = ["cases", "--against", "mine=" + self.odd_renderer("mirror-of", "none", "cases")]
        self.check(7, *self.right)

    def test_what_lies_in_other_files(self):
        mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        self.write("cases/triangle.obj", mesh)
        self.write("cases/mesh.json", triangle_case(
            draws=[{"primitive": "triangles", "mesh": "triangle.obj"}]))
        exact = ["cases", "--against", "exact"]
        self.run_to("reports", *exact)
        self.check(9, *exact)
        self.write("cases/triangle.obj", mesh.replace("v 1 0 0", "v 0.5 0 0"))
        self.check(8, *exact)

    def test_what_was_found_is_taken_as_it_is_written(self):
        """So it is indeed not found anew: a finding that somebody has changed stands."""
        results = self.read()
        results["cases"][3]["results"]["mine"]["refuted"] = ""
        self.write_results("changed.json", results)
        since = ["--since", "changed.json"]
        self.assertEqual(self.run_to("reports", *self.right, *since), 8)
        self.assertEqual(self.read()["cases"][3]["results"]["mine"]["refuted"], "")
        self.run_to("reports", *self.right, *since, "--ask-all")
        self.assertNotEqual(self.read()["cases"][3]["results"]["mine"]["refuted"], "")

    def test_results_of_since(self):
        since = ["--since", "reports/reports.json"]
        run = self.command("run", *self.right, *since, "--json", "new.json")
        self.assertEqual(kept(run), 8)
        self.assertEqual(run.stdout.splitlines()[1],
                         "8 answers are as in reports/reports.json, and not compared anew; "
                         "--ask-all compares them")
        self.command("run", *self.right, "--since", "missing.json", "--json", "new.json", expect=3)

    def test_the_file_that_is_meant_without_a_name(self):
        for number in 0, 8:
            self.assertEqual(kept(self.command("run", *self.right)), number)

    def test_an_earlier_file_that_is_of_no_use(self):
        path = self.folder / "reports/reports.json"
        packed = path.read_bytes()
        for broken in b"", b"{}", b"\0" * 100, packed[:len(packed) // 2], packed[:-8] + b"\0" * 8:
            path.write_bytes(broken)
            run = self.command("run", *self.right, "--json", path)
            self.assertEqual((kept(run), run.stderr), (0, ""))
            self.assertEqual(path.read_bytes(), packed)

    def test_without_digests_nothing_is_kept(self):
        results = self.read()
        for case in results["cases"]:
            del case["results"]["mine"]["answer_digest"]
        self.write_results("without.json", results)
        self.check(0, *self.right, "--since", "without.json")

    def test_a_run_that_ends_early_compares(self):
        self.assertEqual(self.run_to("reports", *self.wrong, "--max-failures", "1",
                                     expect=UNEXPECTED), 0)


class Believed(CommandTest):
    """Nobody names the file: it has to be as a run of this user wrote it."""

    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES[:2])
        self.out = self.folder / "out/results.zst"
        self.cache = self.folder / "cache"
        self.key = self.cache / "edgecase/results/key"
        self.against = ["--against", "mine=" + self.odd_renderer("mirror", "", "cases")]
        self.run_again(0)

    def run_again(self, taken, *arguments, **variables):
        """Runs into out/; so many answers are taken over, and all are wrong. The second line."""
        run = self.command("run", "cases", *self.against, *arguments, expect=UNEXPECTED,
                           **{"XDG_CACHE_HOME": str(self.cache), **variables})
        self.assertIn(" 2 unexpected, ", run.stdout.splitlines()[0])
        self.assertEqual((kept(run), run.stderr), (taken, ""))
        return run.stdout.splitlines()[1]

    def check_doubt(self, reason, **variables):
        """Nothing is taken over for this reason, which the second line tells."""
        told = self.run_again(0, **variables)
        self.assertEqual(told, f"nothing is taken over from out/results.zst: {reason}; --since "
                               "out/results.zst takes it over all the same")

    def forge(self):
        """Violations become agreement, and the digests of the answers stay."""
        results = results_file.read(self.out)
        for case in results["cases"]:
            digest = case["results"]["mine"]["answer_digest"]
            case["results"]["mine"] = {"verdict": "agree", "answer_digest": digest}
        return self.write("forged.json", results_file.text_of(results))

    def test_what_a_run_wrote(self):
        self.assertEqual(self.run_again(2), "2 answers are as in out/results.zst, and not compared "
                                            "anew; --ask-all compares them")
        self.out.rename(self.folder / "moved.zst")
        self.assertEqual(self.run_again(0), "")
        (self.folder / "moved.zst").replace(self.out)
        self.run_again(2)

    def test_forged_results(self):
        forged = self.forge()
        forged.replace(self.out)
        self.check_doubt("it is not as a run of yours wrote it")
        self.run_again(2)

    def test_who_names_forged_results_is_believed_and_nobody_else(self):
        forged = self.forge()
        run = self.command("run", "cases", *self.against, "--since", forged,
                           XDG_CACHE_HOME=str(self.cache))
        self.assertEqual(kept(run), 2)
        self.check_doubt("it is not as a run of yours wrote it")
        self.command("run", "cases", *self.against, "--json", forged, "--resume",
                     XDG_CACHE_HOME=str(self.cache))
        forged.replace(self.out)
        self.check_doubt("it is not as a run of yours wrote it")

    def test_merged_results(self):
        """They may be of parts from anywhere."""
        self.command("merge", self.forge(), "--json", "out/results.zst",
                     XDG_CACHE_HOME=str(self.cache))
        self.check_doubt("it is not as a run of yours wrote it")

    def test_in_ci(self):
        self.check_doubt("CI is set", CI="true")
        self.run_again(2, CI="")

    def test_tracked_files(self):
        def git(*arguments):
            subprocess.run(["git", "-C", self.folder, *arguments], check=True)
        self.write("a/out/results.zst", "of a folder below")
        git("init", "--quiet")
        git("add", "a", "cases")
        self.run_again(2)
        for version in "2", "4", "3":
            git("update-index", "--index-version", version)
            git("add", "--force", "out/results.zst")
            if version == "3":  # which git writes where an entry has more flags
                git("update-index", "--skip-worktree", "out/results.zst")
            index = (self.folder / ".git/index").read_bytes()
            self.assertEqual(index[:8], b"DIRC\0\0\0" + bytes([int(version)]))
            self.check_doubt("git tracks it")
            if version != "3":
                git("rm", "--quiet", "--force", "--cached", "out/results.zst")
        (self.folder / ".git/index").unlink()
        self.run_again(2)

    def test_a_work_tree_and_a_broken_checkout(self):
        git = self.write(".git", f"gitdir: {self.folder}/elsewhere\n")
        self.run_again(2)
        for index in b"", b"DIRC\0\0\0\x09", b"DIRC\0\0\0\x02\0\0\0\1\x0fout/results.zst\0":
            self.write("elsewhere/index", "").write_bytes(index)
            self.check_doubt("git tracks it")
        git.write_text("no folder", "utf-8")
        self.check_doubt("git tracks it")

    @unittest.skipIf(os.geteuid() != 0, "only root gives files away")
    def test_a_file_of_another_user(self):
        os.chown(self.out, 65534, 65534)
        self.check_doubt("it belongs to another user")

    def test_keys(self):
        self.assertEqual([stat.S_IMODE(path.stat().st_mode) for path in
                          (self.key, self.key.with_name("written"), self.key.parent)],
                         [0o600, 0o600, 0o700])
        self.assertEqual(len(self.key.read_bytes()), 32)
        self.check_doubt("it is not as a run of yours wrote it",
                         XDG_CACHE_HOME=str(self.folder / "other"))
        self.key.unlink()
        self.check_doubt("it is not as a run of yours wrote it")
        self.run_again(2)
        self.key.chmod(0o644)
        self.check_doubt(f"the key {self.key} cannot be read or made, or others may read it; "
                         "remove it")
        self.key.chmod(0o600)
        self.key.parent.chmod(0o755)
        self.check_doubt(f"others than you may use the folder {self.key.parent}; shut them out: "
                         f"chmod go-rwx {self.key.parent}")
        self.check_doubt("there is no folder for caches; name one in XDG_CACHE_HOME, by its "
                         "absolute path", XDG_CACHE_HOME="", HOME="")

    def test_folders_that_are_not_the_users(self):
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir(mode=0o700)
        (self.key.parent).rename(self.folder / "moved")
        self.key.parent.symlink_to(elsewhere)
        self.check_doubt(f"{self.key.parent} is no folder; remove it")
        self.key.parent.unlink()
        if os.geteuid() == 0:
            self.key.parent.mkdir(mode=0o700)
            os.chown(self.key.parent, 65534, 65534)
            self.check_doubt(f"the folder {self.key.parent} belongs to another user; remove it, or "
                             "name another folder for caches in XDG_CACHE_HOME")


if __name__ == "__main__":
    unittest.main()
