"""Runs a program with a limit on its CPU time and that of all its children, so that a busy machine changes nothing."""

import dataclasses
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time

MEMORY = 6 << 30  # bytes; a mutant may ask for all that there is
TICKS = os.sysconf("SC_CLK_TCK")

stopping = threading.Event()  # set by a signal: all runs end


class Interrupted(Exception):
    pass


@dataclasses.dataclass(frozen=True)
class Run:
    code: int         # exit code; -N: killed by signal N
    output: str       # stdout and stderr
    seconds: float    # of CPU time
    in_time: bool


def session_members(session):
    """(process, CPU seconds) of each living process of a session."""
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            fields = (entry / "stat").read_text().rpartition(")")[2].split()
        except OSError:
            continue  # it has ended
        if int(fields[3]) == session:
            yield int(entry.name), sum(map(int, fields[11:15])) / TICKS


def kill_session(session):
    for process, _ in list(session_members(session)):
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass


def run(command, limit, folder=None):
    """`limit`: CPU seconds. A program that sleeps is ended after ten times as long."""
    began = time.monotonic()
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(["prlimit", f"--as={MEMORY}", "--core=0", "--", *command], cwd=folder,
                                   stdin=subprocess.DEVNULL, stdout=output, stderr=output, start_new_session=True)
        in_time, pause = True, 0.01
        while True:
            ended, status, usage = os.wait4(process.pid, os.WNOHANG)
            if ended:
                break
            used = sum(seconds for _, seconds in session_members(process.pid))
            if stopping.is_set() or used > limit or time.monotonic() - began > 10 * limit + 60:
                in_time = False
                kill_session(process.pid)
            time.sleep(pause)
            pause = min(2 * pause, 0.25)
        kill_session(process.pid)  # children that outlived it
        process.returncode = os.waitstatus_to_exitcode(status)
        if stopping.is_set():
            raise Interrupted
        output.seek(0)
        text = output.read().decode(errors="replace")
        return Run(process.returncode, text, usage.ru_utime + usage.ru_stime, in_time)
