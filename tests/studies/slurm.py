# SPDX-License-Identifier: GPL-2.0-or-later
"""A real Slurm of one node on this machine, for tests: all its files in one directory,
all its ports on the loopback device, no accounting.

Debian packages: slurmctld slurmd slurm-client munge.
"""
import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol")
WAIT = 60.  # s, when the machine is busy

# Requeued jobs are held until the credentials of their first start are over, hence
# cred_expire. Large arrays are split at MaxArraySize, which is small here.
CONFIGURATION = """ClusterName=studies
SlurmUser={user}
SlurmdUser={user}
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
AuthInfo=socket={folder}/munge.socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=0,sched_interval=2,sched_min_interval=0,bf_interval=2
KillWait=5
MinJobAge=300
MaxArraySize={max_array_size}
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus}
PartitionName=main Nodes={host} Default=YES DefaultTime=10 PriorityTier=1
PartitionName=urgent Nodes={host} DefaultTime=10 PriorityTier=10 PreemptMode=OFF
"""


def path_of(name):
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def missing():
    """Programs that are not installed."""
    return [name for name in PROGRAMS if path_of(name) is None]


def free_ports(number):
    """Of the loopback device."""
    sockets = [socket.socket() for _ in range(number)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """Starts with it and stops with stop(). cpus: as many as it is told, whatever the
    machine has. Sets SLURM_CONF of this process."""

    def __init__(self, folder, cpus=8, max_array_size=101):
        self.folder = pathlib.Path(folder).resolve()
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True, exist_ok=True)
        self.folder.chmod(0o755)
        controller_port, node_port = free_ports(2)
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(
            user=getpass.getuser(), host=socket.gethostname().split(".")[0],
            folder=self.folder, controller_port=controller_port, node_port=node_port,
            cpus=cpus, max_array_size=max_array_size))
        os.environ["SLURM_CONF"] = str(configuration)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        self.start_munge()
        self.start_controller("-c")
        self.start_daemon("slurmd", "-c")
        self.wait_until_idle()

    def start_munge(self):
        subprocess.run([path_of("munged")] + ["--%s=%s/munge.%s" % (
            option, self.folder, ending) for option, ending in (
                ("key-file", "key"), ("socket", "socket"), ("pid-file", "pid"),
                ("log-file", "log"), ("seed-file", "seed"))], check=True)

    def start_controller(self, *options):
        """Without options it goes on from the state that it has saved."""
        self.start_daemon("slurmctld", *options)

    def start_daemon(self, name, *options):
        subprocess.run([path_of(name), *options], check=True, stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL)

    def wait_until_idle(self):
        deadline = time.monotonic() + WAIT
        while not any(word in self.said("sinfo", "-h", "-o", "%T")
                      for word in ("idle", "mix", "alloc")):
            assert time.monotonic() < deadline, "Slurm does not start"
            time.sleep(0.1)

    def said(self, *words, check=False):
        process = subprocess.run(words, stdin=subprocess.DEVNULL, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 timeout=WAIT, check=False)
        assert process.returncode == 0 or not check, (words, process.stdout)
        return process.stdout

    def answer(self, *words):
        """Of a command that the controller may need some attempts for: an error is
        not an empty queue."""
        deadline = time.monotonic() + WAIT
        while True:
            try:
                return self.said(*words, check=True)
            except (AssertionError, subprocess.TimeoutExpired):
                if time.monotonic() > deadline:
                    raise
            time.sleep(0.5)

    def queue(self):
        """{id of a task: (state, name of the job, reason)} of what is in the queue."""
        found = {}
        for line in self.answer("squeue", "-h", "-r", "-o", "%i|%T|%j|%r").splitlines():
            words = line.split("|")
            if len(words) == 4:
                found[words[0]] = tuple(words[1:])
        return found

    def wait_until_empty(self, seconds, pause=0.5):
        deadline = time.monotonic() + seconds
        while True:
            text = self.answer("squeue", "-h", "-r", "-o", "%i %T %r")
            if not text.strip():
                return
            assert time.monotonic() < deadline, text
            time.sleep(pause)

    def process(self, name):
        """Its number, or None."""
        try:
            number = int((self.folder / (name + ".pid")).read_text())
            state = pathlib.Path("/proc/%d/stat" % number).read_text()
        except (OSError, ValueError):
            return None
        return None if state.rpartition(")")[2].split()[0] == "Z" else number

    def kill_controller(self):
        number = self.process("slurmctld")
        if number:
            os.kill(number, signal.SIGKILL)
            self.wait_for_end("slurmctld")

    def resume_node(self):
        """What an administrator does after a controller was killed while it started a
        job: it starts that again, is told that it is there, and drains the node."""
        if "drain" in self.said("sinfo", "-h", "-o", "%T"):
            self.said("scontrol", "update", "nodename=ALL", "state=resume")

    def compare_notes(self):
        """Makes controller and node tell each other which jobs there are: one that was
        killed before it had saved the end of a job believes for long that it runs."""
        self.said("scontrol", "reconfigure")

    def wait_for_end(self, name):
        deadline = time.monotonic() + WAIT
        while self.process(name) and time.monotonic() < deadline:
            time.sleep(0.05)

    def stop(self):
        for name in ("slurmd", "slurmctld", "munge"):
            number = self.process(name)
            if number:
                os.kill(number, signal.SIGTERM)
                self.wait_for_end(name)
        self.end_the_rest()

    def end_the_rest(self):
        """Keepers of jobs that still try to reach the controller."""
        mark = ("SLURM_CONF=%s\0" % (self.folder / "slurm.conf")).encode()
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if (process / "comm").read_text().strip() == "slurmstepd" \
                        and mark in (process / "environ").read_bytes():
                    os.kill(int(process.name), signal.SIGKILL)
            except OSError:
                continue
