"""The recipe of docs/how_to/many_machines.md for Slurm, with a controller and two node daemons on this machine: eight
shards, of which one is killed and run again, merge into the report of one run. Skipped where they cannot start."""

import os
import shutil
import signal
import socket
import subprocess
import time
import unittest

from program import *

DAEMONS = ["munged", "slurmctld", "slurmd"]
RUN = ["--subjects", "fast", "--subjects", altered("1.5"), "--properties", "distance.value,mass.mass", "--cases", 250,
       "--meshes", "meshes", "--skip-adapter-check"]

CONFIGURATION = """
ClusterName=touchstone
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
SlurmctldPort={port}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
KillWait=1
MinJobAge=300
NodeName=one NodeHostname={host} NodeAddr=127.0.0.1 Port={one} CPUs=2
NodeName=two NodeHostname={host} NodeAddr=127.0.0.1 Port={two} CPUs=2
PartitionName=all Nodes=one,two Default=YES MaxTime=INFINITE State=UP
"""


def program(name):
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [s.getsockname()[1] for s in sockets]
    [s.close() for s in sockets]
    return ports


@unittest.skipUnless(all(map(program, DAEMONS)) and is_root(), "Slurm's daemons (slurm-wlm) or root are missing")
class Slurm(Test):
    def setUp(self):
        super().setUp()
        self.slurm = self.folder / "slurm"
        for folder in ["state", "spool-one", "spool-two"]:
            (self.slurm / folder).mkdir(parents=True)
        port, one, two = free_ports(3)
        configuration = self.slurm / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(host=socket.gethostname().split(".")[0], folder=self.slurm,
                                                      port=port, one=one, two=two))
        self.environment = {**os.environ, "SLURM_CONF": str(configuration), "TOUCHSTONE": PROGRAM}
        key = self.slurm / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o600)
        self.start("munged", "--foreground", "--force", "--key-file", key, "--socket", self.slurm / "munge.socket",
                   "--pid-file", self.slurm / "munge.pid", "--seed-file", self.slurm / "munge.seed",
                   "--log-file", self.slurm / "munge.log")
        self.start("slurmctld", "-D")
        for node in ["one", "two"]:
            self.start("slurmd", "-D", "-N", node)
        if not self.wait(lambda: self.asked("sinfo", "-h", "-o", "%D %t").split() == ["2", "idle"], 30):
            self.skipTest("Slurm's nodes do not come up: " + self.asked("sinfo"))
        write_meshes(self.folder / "meshes")

    def start(self, name, *words):
        log = open(self.slurm / f"{name}.out", "ab")
        self.addCleanup(log.close)
        daemon = subprocess.Popen([program(name), *map(str, words)], cwd=self.slurm, env=self.environment, stdout=log,
                                  stderr=log, start_new_session=True)
        self.addCleanup(self.stop, daemon)

    def stop(self, daemon):
        try:
            os.killpg(daemon.pid, signal.SIGTERM)
            daemon.wait(20)
        except (ProcessLookupError, subprocess.TimeoutExpired):
            daemon.kill()
            daemon.wait()

    def asked(self, *words):
        done = subprocess.run(list(map(str, words)), cwd=self.folder, env=self.environment, capture_output=True,
                              text=True, timeout=60)
        return done.stdout + done.stderr

    def wait(self, holds, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if holds():
                return True
            time.sleep(0.2)
        return False

    def submit(self, *words):
        said = self.asked("sbatch", "--parsable", *words, SOURCE / "docs/examples/report.sbatch", "quick", *RUN)
        self.assertRegex(said, r"^\d+\n$")
        return said.strip()

    def ended(self, job):
        return self.wait(lambda: not self.asked("squeue", "-h", "-j", job).strip(), 240)

    def test_eight_shards_of_which_one_is_killed(self):
        self.succeeds("report", *RUN, "--out", "report")
        files = ["report.json", "index.html", "junit.xml", "atlas.csv"]
        whole = {name: (self.folder / "report" / name).read_bytes() for name in files}
        shutil.rmtree(self.folder / "report")

        job = self.submit("--array=1-8", "--cpus-per-task=1")
        self.asked("scancel", f"{job}_8")
        self.assertTrue(self.ended(job), self.asked("squeue"))
        self.assertEqual(len(list((self.folder / "shards").glob("*.jsonl"))), 7)
        self.refused("merge", "shards", says="shard 8 of 8 is missing")

        again = self.submit("--array=8", "--cpus-per-task=1", "--export=ALL,SHARDS=8")
        self.assertTrue(self.ended(again), self.asked("squeue"))
        self.succeeds("merge", "shards")
        merged = {name: (self.folder / "report" / name).read_bytes() for name in files}
        for name, content in without_times(whole).items():
            self.assertEqual(without_times(merged)[name], content, name)


if __name__ == "__main__":
    unittest.main()
