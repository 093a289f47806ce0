"""A Slurm of one node: its daemons, as Debian packages them, in namespaces of their own, where the only process, address and
host's name are theirs. Nothing outlives them, and two tests at once do not meet.
"""
import fcntl
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import sys
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scancel", "scontrol", "unshare")
APART = ("unshare", "--pid", "--fork", "--kill-child", "--mount-proc", "--net", "--uts", "--ipc")
HOST = "node"
ADDRESS = "10.0.0.1"  # of `lo`: names are not resolved where there is but 127.0.0.1
WAIT = 0.2  # seconds between looks
SKIPPED = 77  # as ctest knows it

# On a busy machine nothing comes too late: no node is lost, no job. A requeued job waits for its credential to expire, though,
# which it may not do before the job is begun. Only jobs are requeued that ask for it.
CONFIGURATION = """
ClusterName=cluster
SlurmctldHost={host}({address})
SlurmUser=root
AuthInfo=socket={folder}/munge.socket,cred_expire=60
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1
JobRequeue=0
MessageTimeout=100
BatchStartTimeout=600
SlurmdTimeout=0
KillWait=5
MinJobAge=86400
NodeName={host} NodeAddr={address} CPUs={processors} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def skip(reason):
    print("SKIPPED: " + reason)
    sys.exit(SKIPPED)


def go_apart():
    """Begins this program again in namespaces of its own; returns where it is in them. Says why where that cannot be."""
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    if os.environ.pop("RAYCHECK_IS_APART", None):
        return
    if os.geteuid() != 0:
        skip("Slurm's daemons need root")
    missing = [name for name in PROGRAMS if shutil.which(name) is None]
    if missing:
        skip(f"no {', '.join(missing)} (slurmctld, slurmd, slurm-client, munge)")
    tried = subprocess.run([*APART, "true"], capture_output=True, text=True)
    if tried.returncode != 0:
        skip(f"no namespaces of its own here: {tried.stderr.strip()}")
    # A shell is the first process there: it buries what other processes leave behind.
    os.execvpe(APART[0], [*APART, "bash", "-c", '"$@"; exit "$?"', "bash", sys.executable, *sys.argv],
               {**os.environ, "RAYCHECK_IS_APART": "1"})


def give_address():
    """The namespace's `lo` has the address, and is up."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        name = b"lo".ljust(16, b"\0")
        address = struct.pack("=HH4s8x", socket.AF_INET, 0, socket.inet_aton(ADDRESS))
        fcntl.ioctl(any_socket, 0x8916, name + address)  # SIOCSIFADDR
        fcntl.ioctl(any_socket, 0x8914, name + struct.pack("=H14x", 1))  # SIOCSIFFLAGS: IFF_UP


class Slurm:
    def __init__(self, folder, processors):
        self.folder = pathlib.Path(folder)
        self.folder.chmod(0o755)  # munged wants everyone to come to its socket
        give_address()
        socket.sethostname(HOST)
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(host=HOST, address=ADDRESS, folder=self.folder, processors=processors))
        # No control groups, of whichever version this system has: what 22.05 takes by this name is never asked for anything.
        version = tuple(map(int, re.findall(r"\d+", self.asked("slurmd", "-V"))[:2]))
        (self.folder / "cgroup.conf").write_text(f"CgroupPlugin={'disabled' if version >= (24, 5) else 'cgroup/v1'}\n")
        os.environ["SLURM_CONF"] = str(configuration)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.daemons = {}
        munge = self.folder / "munge"
        self.begin("munged", "--foreground", f"--origin={ADDRESS}", f"--key-file={key}", f"--socket={munge}.socket",
                   f"--pid-file={munge}.pid", f"--log-file={munge}.log", f"--seed-file={munge}.seed")
        self.wait("munged's socket", lambda: pathlib.Path(f"{munge}.socket").exists())
        self.begin("slurmctld", "-D")
        self.begin("slurmd", "-D")
        self.wait("the node", lambda: "State=IDLE " in self.asked("scontrol", "--oneliner", "show", "node", HOST))

    def begin(self, name, *arguments):
        with open(self.folder / name, "w") as said:
            self.daemons[name] = subprocess.Popen([name, *arguments], stdout=said, stderr=subprocess.STDOUT)

    def end(self):
        for daemon in reversed(self.daemons.values()):
            daemon.terminate()
            daemon.wait()

    def wait(self, what, is_so):
        """Until it is so: for states, never for times."""
        while not is_so():
            for name, daemon in self.daemons.items():
                if daemon.poll() is not None:
                    raise RuntimeError(f"{name} has ended, before {what}: {(self.folder / name).read_text()}")
            time.sleep(WAIT)

    def asked(self, *command):
        """What a command of Slurm prints, empty where it fails, as long as daemons are not ready."""
        return subprocess.run(command, capture_output=True, text=True).stdout

    def told(self, *command):
        subprocess.run(command, check=True, capture_output=True, text=True)

    def job(self, number):
        """What Slurm knows of a job, or of a task of an array, JOB_TASK."""
        words = self.asked("scontrol", "--oneliner", "show", "job", number).split()
        return dict(word.split("=", 1) for word in words if "=" in word)

    def wait_until_ended(self, number):
        over = ("COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY")
        def has_ended():
            job = self.job(number)
            if job.get("Reason") == "DependencyNeverSatisfied":
                raise RuntimeError(f"job {number} will never begin: {job}")
            return job.get("JobState") in over
        self.wait(f"the end of job {number}", has_ended)
        return self.job(number)
