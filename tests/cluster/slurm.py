"""A Slurm of one node: Debian's daemons in separate namespaces, with their own processes, address and host name.
Nothing outlives them, and concurrent tests do not interfere.
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
ADDRESS = "10.0.0.1"  # of `lo`: names are not resolved if 127.0.0.1 is the only address
WAIT = 0.2  # seconds between checks
SKIPPED = 77  # ctest's code for a skipped test

# Time limits that no busy machine exceeds, so that no node or job is lost. But a requeued job waits until its credential expires,
# which must not happen before the job starts. Only jobs that request it are requeued.
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
    """Restarts this program in separate namespaces; returns if it runs in them. Skips the test if that is impossible."""
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
        skip(f"namespaces cannot be made here: {tried.stderr.strip()}")
    # A shell is the first process there, to reap orphaned processes.
    os.execvpe(APART[0], [*APART, "bash", "-c", '"$@"; exit "$?"', "bash", sys.executable, *sys.argv],
               {**os.environ, "RAYCHECK_IS_APART": "1"})


def give_address():
    """Gives the namespace's `lo` the address and brings it up."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        name = b"lo".ljust(16, b"\0")
        address = struct.pack("=HH4s8x", socket.AF_INET, 0, socket.inet_aton(ADDRESS))
        fcntl.ioctl(any_socket, 0x8916, name + address)  # SIOCSIFADDR
        fcntl.ioctl(any_socket, 0x8914, name + struct.pack("=H14x", 1))  # SIOCSIFFLAGS: IFF_UP


class Slurm:
    def __init__(self, folder, processors):
        self.folder = pathlib.Path(folder)
        self.folder.chmod(0o755)  # munged requires that everyone can reach its socket
        give_address()
        socket.sethostname(HOST)
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(host=HOST, address=ADDRESS, folder=self.folder, processors=processors))
        # Disables control groups; Slurm 22.05 has no 'disabled', but never uses the plugin named instead.
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
        """Waits until `is_so()`, without a time limit."""
        while not is_so():
            for name, daemon in self.daemons.items():
                if daemon.poll() is not None:
                    raise RuntimeError(f"{name} ended before {what}: {(self.folder / name).read_text()}")
            time.sleep(WAIT)

    def asked(self, *command):
        """The output of a Slurm command; empty if it fails, as it does until the daemons are ready."""
        return subprocess.run(command, capture_output=True, text=True).stdout

    def told(self, *command):
        subprocess.run(command, check=True, capture_output=True, text=True)

    def job(self, number):
        """Slurm's description of a job, or of an array's task, JOB_TASK."""
        words = self.asked("scontrol", "--oneliner", "show", "job", number).split()
        return dict(word.split("=", 1) for word in words if "=" in word)

    def wait_until_ended(self, number):
        over = ("COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY")
        def has_ended():
            job = self.job(number)
            if job.get("Reason") == "DependencyNeverSatisfied":
                raise RuntimeError(f"job {number} will never start: {job}")
            return job.get("JobState") in over
        self.wait(f"the end of job {number}", has_ended)
        return self.job(number)
