"""The files of share/cluster for schedulers that are not installed here: their raycheck commands, run with a smaller campaign in their
scheduler's environment, give the report of one machine. So does the documentation's command with GNU parallel.

  files_test.py PROGRAM [unittest's arguments]
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FILES = ROOT / "share/cluster"
CAMPAIGN = "properties --filter class --cases 40"
# As in the documentation.
PARALLEL = ("parallel --joblog shards.log --resume-failed raycheck properties --cases 100000 --threads 1 --out shards "
            "--shard {}/64 ::: {1..64} && raycheck merge shards")
DIES_ONCE = """#!/usr/bin/env bash
case "$*" in
  *"--shard 3/"*) [ -e has-died ] || { touch has-died; kill -9 $$; } ;;
esac
exec '@PROGRAM' "$@"
"""
SKIPPED = 77  # ctest's code for a skipped test
SCHEDULERS = re.compile("SLURM_|JOB_COMPLETION|TEST_SHARD|TEST_TOTAL|CI_NODE|GITHUB_")


class Shared:
    program = None
    was_skipped = False


def text_of(name):
    return (FILES / name).read_text()


def commands_of(text):
    """The shell lines that begin with `raycheck`, with their campaign replaced by CAMPAIGN."""
    lines = re.findall(r"^ *(?:- )?(raycheck .*)$", text, re.MULTILINE)
    return [re.sub(r"properties .*?(?= --out)", CAMPAIGN, line) for line in lines]


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_bash(self, command, **variables):
        environment = {name: value for name, value in os.environ.items() if not SCHEDULERS.match(name)}
        environment["PATH"] = f"{Shared.program.parent}:{environment['PATH']}"
        return subprocess.run(["bash", "-euo", "pipefail", "-c", command], cwd=self.folder, capture_output=True, text=True,
                              env={**environment, **variables})

    def check_done(self, command, **variables):
        result = self.run_bash(command, **variables)
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)

    def check_report(self, merge, options="", **variables):
        alone = self.run_bash(f"raycheck {CAMPAIGN} {options}", **variables)
        self.assertIn(alone.returncode, (0, 1), alone.stderr)
        self.assertTrue(alone.stdout)
        merged = self.run_bash(merge, **variables)
        self.assertEqual((merged.returncode, merged.stdout), (alone.returncode, alone.stdout), merged.stderr)

    def test_kubernetes(self):
        text = text_of("kubernetes.yaml")
        count = int(re.search(r"completions: (\d+)", text)[1])
        self.assertIn(f"--shard=auto/{count} ", text)
        shards = " ".join([f"raycheck {CAMPAIGN}", *re.findall(r"- (--(?:threads|out|shard)=\S+)", text)])
        for index in range(count):
            self.check_done(shards.replace("=/", "=./"), JOB_COMPLETION_INDEX=str(index))
        merge = re.search(r"args: \[(merge), /(shards)\]", text)
        self.check_report(f"raycheck {merge[1]} {merge[2]}")

    def test_github(self):
        text = text_of("github-actions.yaml")
        shard, merge = commands_of(text)
        numbers = re.search(r"shard: \[(.*)\]", text)[1].split(", ")
        self.assertEqual(numbers, [str(k + 1) for k in range(len(numbers))])
        self.assertIn("SHARD: ${{ matrix.shard }}/${{ strategy.job-total }}\n", text)
        for number in numbers:
            self.check_done(shard, SHARD=f"{number}/{len(numbers)}")
            (self.folder / "all").mkdir(exist_ok=True)
            (self.folder / "shards").rename(self.folder / f"all/raycheck-shard-{number}")
        (self.folder / "all").rename(self.folder / "shards")
        self.check_report(merge, "--format github --report markdown=alone.md", GITHUB_STEP_SUMMARY="summary.md")
        self.assertEqual(*((self.folder / name).read_bytes() for name in ("alone.md", "summary.md")))

    def test_gitlab(self):
        text = text_of("gitlab-ci.yaml")
        shard, merge = commands_of(text)
        count = int(re.search(r"parallel: (\d+)", text)[1])
        for number in range(1, count + 1):
            self.check_done(shard, CI_NODE_INDEX=str(number), CI_NODE_TOTAL=str(count))
        self.check_report(merge, "--report junit=alone.xml")
        self.assertEqual(*((self.folder / name).read_bytes() for name in ("alone.xml", "junit.xml")))

    def test_gnu_parallel(self):
        if shutil.which("parallel") is None:
            Shared.was_skipped = True
            self.skipTest("no parallel (parallel)")
        for page in sorted((ROOT / "docs").glob("*.md")):
            for line in re.findall(r"^parallel .*", page.read_text(), re.MULTILINE):
                self.assertEqual(line, PARALLEL, page.name)
        line = re.sub("properties .*?(?= --out)", CAMPAIGN, PARALLEL)
        program = self.folder / "bin/raycheck"
        program.parent.mkdir()
        program.write_text(DIES_ONCE.replace("@PROGRAM", str(Shared.program)))
        program.chmod(0o755)
        path = f"{program.parent}:{os.environ['PATH']}"
        killed = self.run_bash(line, PATH=path)
        self.assertEqual((killed.returncode, killed.stdout), (1, ""), killed.stderr)  # the number of failed jobs; no report
        self.check_report(line, PATH=path)
        log = [entry.split("\t") for entry in (self.folder / "shards.log").read_text().splitlines()[1:]]
        signals = [entry[7] for entry in log if entry[0] == "3"]
        self.assertEqual((signals, len(log)), (["9", "0"], 64 + 1))  # only the killed job was started again


def main():
    Shared.program = pathlib.Path(sys.argv.pop(1)).resolve()
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(1 if not result.wasSuccessful() or not result.testsRun else SKIPPED if Shared.was_skipped else 0)


main()
