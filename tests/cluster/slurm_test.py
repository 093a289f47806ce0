"""A campaign by the array of share/cluster/raycheck.sbatch, on a real Slurm of one node.

  slurm_test.py PROGRAM [unittest's arguments]

Exits with 0, with 1 if a test failed, and with 77 and a message if Slurm is not available.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import slurm

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "share/cluster/raycheck.sbatch"
CAMPAIGN = ("properties", "--cases", "2000")
SHARDS = 4
CPU_SECONDS = 1  # of a task until it is killed; a task needs several times this

# Mishaps of tasks at their first start: the kernel kills them with SIGKILL during their work, after CPU_SECONDS; or they hang
# until they are ended. `kept` lists the folder when a killed task starts again.
MISHAPS = f"""#!/usr/bin/env bash
case ${{SLURM_RESTART_COUNT:-first}}:${{SLURM_ARRAY_TASK_ID:-}} in
  first:@KILLED) ulimit -t {CPU_SECONDS} ;;
  first:@HANGS) exec sleep infinity ;;
  [1-9]*:@KILLED) ls --inode shards > kept ;;
esac
exec '@PROGRAM' "$@"
"""


class Shared:
    program = None
    slurm = None
    folder = None


def ran(*arguments, **options):
    return subprocess.run(list(map(str, arguments)), capture_output=True, **options)


class Array(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.alone = ran(Shared.program, *CAMPAIGN)
        assert cls.alone.returncode in (0, 1) and cls.alone.stdout, cls.alone

    def setUp(self):
        self.folder = Shared.folder / self.id().split(".")[-1]
        self.folder.mkdir()

    def program(self, killed="none", hangs="none"):
        path = self.folder / "raycheck"
        path.write_text(MISHAPS.replace("@KILLED", killed).replace("@HANGS", hangs).replace("@PROGRAM", str(Shared.program)))
        path.chmod(0o755)
        return path

    def submitted(self, program, **variables):
        """The jobs of the array and of the report, submitted by one command."""
        kept = {name: os.environ[name] for name in ("PATH", "SLURM_CONF")}
        environment = {**kept, "RAYCHECK": str(program), "SHARDS": str(SHARDS), "FOLDER": "shards", **variables}
        result = ran(SCRIPT, *CAMPAIGN, cwd=self.folder, env=environment, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return re.findall(r"^job (\d+)", result.stdout, re.MULTILINE)

    def log(self, name):
        return (self.folder / "shards.logs" / name).read_text()

    def check_report(self, merge):
        ended = Shared.slurm.wait_until_ended(merge)
        self.assertEqual(ended["ExitCode"], f"{self.alone.returncode}:0", self.log("merge"))
        self.assertEqual((self.folder / "shards.txt").read_bytes(), self.alone.stdout)

    def wait_until_hanging(self, task):
        def is_there():
            for process in pathlib.Path("/proc").glob("[0-9]*"):
                try:
                    if ((process / "cmdline").read_bytes() == b"sleep\0infinity\0" and
                            f"SLURM_ARRAY_TASK_ID={task}".encode() in (process / "environ").read_bytes().split(b"\0")):
                        return True
                except OSError:  # it has just ended
                    pass
            return False
        Shared.slurm.wait(f"task {task} at work", is_there)

    def test_killed_tasks_resume_and_the_report_equals_that_of_one_machine(self):
        array, merge = self.submitted(self.program(killed="2", hangs="[34]"))
        self.wait_until_hanging(3)
        Shared.slurm.told("scontrol", "requeue", f"{array}_3")
        self.wait_until_hanging(4)
        Shared.slurm.told("scancel", "--batch", "--signal=USR1", f"{array}_4")  # like Slurm before a time limit
        self.check_report(merge)
        restarts = [Shared.slurm.job(f"{array}_{task}")["Restarts"] for task in range(1, SHARDS + 1)]
        self.assertEqual(restarts, ["0", "1", "1", "1"])
        kept = {line for line in (self.folder / "kept").read_text().splitlines() if line.endswith(".unit")}
        now = set(ran("ls", "--inode", "shards", cwd=self.folder, text=True).stdout.splitlines())
        self.assertTrue(kept)
        self.assertLessEqual(kept, now)  # the same files: not computed again
        self.assertIn("ended by SIGKILL, requeued", self.log("shard-2"))
        self.assertIn("ended by its time limit, requeued", self.log("shard-4"))
        for task in range(1, SHARDS + 1):
            self.assertRegex(self.log(f"shard-{task}"), f"shard {task} of {SHARDS}\\b.*SLURM")

    def test_the_same_command_computes_what_a_cancelled_task_did_not(self):
        array, merge = self.submitted(self.program(killed="2", hangs="3"), RESTARTS="0")
        self.wait_until_hanging(3)
        Shared.slurm.told("scancel", f"{array}_3")
        ended = Shared.slurm.wait_until_ended(merge)
        self.assertEqual((ended["JobState"], ended["ExitCode"]), ("FAILED", "2:0"), self.log("merge"))
        self.assertRegex(self.log("merge"), r"unit \d+ of \d+ is missing")
        self.assertEqual(Shared.slurm.job(f"{array}_2")["ExitCode"], "137:0")
        self.check_report(self.submitted(self.program())[1])


def main():
    slurm.go_apart()
    Shared.program = pathlib.Path(sys.argv.pop(1)).resolve()
    with tempfile.TemporaryDirectory() as folder:
        Shared.folder = pathlib.Path(folder)
        Shared.slurm = slurm.Slurm(Shared.folder, SHARDS)
        try:
            result = unittest.main(exit=False, verbosity=2).result
        finally:
            Shared.slurm.end()
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)


main()
