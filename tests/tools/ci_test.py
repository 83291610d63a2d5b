# SPDX-License-Identifier: MIT
"""The examples for users' CI in tools/ci are run: each cuts a run into four, and what it joins is
what the whole run writes, byte by byte. Slurm is a real one, of this machine alone."""
import subprocess
import unittest

import yaml

from support import AS_EXPECTED, BIN, EDGECASE, PATIENCE, ROOT, UNEXPECTED, CommandTest, environment

EXAMPLES = ROOT / "tools/ci"
SHARDS = 4


class Example(CommandTest):
    """A repository that has Edgecase in the folder `edgecase`, with a small suite."""

    def setUp(self):
        super().setUp()
        self.copy_suite("points", "surfaces")
        checkout = self.folder / "edgecase"
        (checkout / "build/release").mkdir(parents=True)
        (checkout / "build/release/bin").symlink_to(BIN)
        (checkout / "tools").symlink_to(ROOT / "tools")
        (self.folder / "cases").rename(checkout / "cases")
        self.checkout = checkout

    def whole(self, renderer, expect=AS_EXPECTED):
        """What one run writes: results, JUnit XML and report."""
        names = ("results.zst", "junit.xml", "report.html")
        options = [word for name in names
                   for word in (f"--{name.split('.')[1].replace('xml', 'junit').replace('zst', 'json')}", f"whole/{name}")]
        run = subprocess.run([EDGECASE, "run", "--against", renderer, *options],
                             cwd=self.checkout, env=environment(), capture_output=True, text=True,
                             timeout=PATIENCE)
        self.assertEqual(run.returncode, expect, run.stderr)
        return {name: (self.checkout / "whole" / name).read_bytes() for name in names}

    def check_joined(self, folder, whole):
        for name, content in whole.items():
            self.assertEqual((folder / name).read_bytes(), content, name)

    def shell(self, lines, **variables):
        """A job's lines; the exit code must be 0."""
        run = subprocess.run(["sh", "-e", "-c", "\n".join(lines)], cwd=self.folder,
                             env=environment(**variables), capture_output=True, text=True,
                             timeout=PATIENCE)
        self.assertEqual(run.returncode, 0, f"{lines}\n{run.stdout}\n{run.stderr}")


class GitLab(Example):
    def test_four_jobs_are_one_run(self):
        jobs = yaml.safe_load((EXAMPLES / "gitlab-ci.yml").read_text(encoding="utf-8"))
        renderer = jobs["variables"]["RENDERER"]
        whole = self.whole(renderer)
        self.assertEqual(jobs["shard"]["parallel"], SHARDS)
        for index in range(1, SHARDS + 1):
            self.shell(jobs["shard"]["script"], RENDERER=renderer, CI_NODE_INDEX=str(index),
                       CI_NODE_TOTAL=str(SHARDS))
        self.shell(jobs["report"]["script"])
        self.check_joined(self.checkout / "out", whole)


class GitHub(Example):
    def lines_of(self, job):
        """What is run in the checkout; that the program travels is left to GitHub."""
        return ["cd edgecase"] + [step["run"] for step in job["steps"]
                                  if "run" in step and "working-directory" not in step
                                  and not step["run"].startswith("tar ")]

    def test_four_jobs_are_one_run(self):
        workflow = yaml.safe_load((EXAMPLES / "github-actions.yml").read_text(encoding="utf-8"))
        renderer = workflow["env"]["RENDERER"]
        whole = self.whole(renderer)
        shard = workflow["jobs"]["shard"]
        self.assertEqual(shard["strategy"]["matrix"]["shard"], list(range(1, SHARDS + 1)))
        for index in shard["strategy"]["matrix"]["shard"]:
            self.shell(self.lines_of(shard), RENDERER=renderer, SHARD=str(index))
        summary = self.folder / "summary.md"
        self.shell(self.lines_of(workflow["jobs"]["report"]), GITHUB_STEP_SUMMARY=str(summary))
        self.check_joined(self.checkout / "out", whole)
        self.assertIn(f"| `{renderer}` |", summary.read_text(encoding="utf-8"))


class Slurm(Example):
    def submit(self, *arguments, expect):
        run = subprocess.run([EXAMPLES / "slurm/one-node", EXAMPLES / "slurm/submit", str(SHARDS),
                              "joined", *arguments], cwd=self.checkout,
                             env=environment(EDGECASE=EDGECASE), capture_output=True, text=True,
                             timeout=PATIENCE)
        self.assertEqual(run.returncode, expect, f"{run.stdout}\n{run.stderr}")
        return run

    def test_four_tasks_are_one_run(self):
        whole = self.whole("egl:softpipe")
        self.submit("--against", "egl:softpipe", expect=AS_EXPECTED)
        for number in range(1, SHARDS + 1):
            self.assertTrue((self.checkout / f"joined/shard-{number}.zst").exists())
        self.check_joined(self.checkout / "joined", whole)

    def test_its_exit_code_is_that_of_the_run(self):
        (self.checkout / "cases/known/softpipe.json").unlink()
        whole = self.whole("egl:softpipe", expect=UNEXPECTED)
        self.submit("--against", "egl:softpipe", expect=UNEXPECTED)
        self.check_joined(self.checkout / "joined", whole)


if __name__ == "__main__":
    unittest.main()
