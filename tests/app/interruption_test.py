"""Ctrl-C leaves a complete partial report and no child; a bar on a terminal, silence in a pipe."""

import os
import pty
import signal
import time
import unittest
import xml.etree.ElementTree

from program import *


def children_of(pid):
    """Processes of its group: the program leads one of its own here."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[2]) == pid or int(fields[3]) == pid:
            found.append((stat.parent.name, fields[0]))
    return found


def wait_until_asking(pid):
    """Each piece of work starts fresh processes: when many have been seen, some pieces are done."""
    seen = set()
    end = time.monotonic() + 60
    while len(seen) < 16 and time.monotonic() < end:
        seen.update(child for child, _ in children_of(pid))
        time.sleep(0.01)


class Interruption(Test):
    def test_an_interrupted_report_is_complete(self):
        run = subprocess.Popen([PROGRAM, "report", "--subjects", "reference,bullet.double", "--stems", "distance", "--cases", "100000",
                                "--jobs", "2", "--out", "R"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, start_new_session=True)
        wait_until_asking(run.pid)
        self.assertFalse((self.folder / "R/index.html").exists())
        run.send_signal(signal.SIGINT)
        out, errors = run.communicate(timeout=30)
        self.assertEqual(run.returncode, 130, errors)
        self.assertIn("interrupted", out)
        report = self.json("R/report.json")
        self.assertIs(report["interrupted"], True)
        self.assertGreater(sum(row["holds"] for row in report["rows"]), 0)
        self.assertIn("nterrupted", (self.folder / "R/index.html").read_text())
        xml.etree.ElementTree.parse(self.folder / "R/junit.xml")
        for row in report["rows"]:
            if row.get("case"):
                self.json("R/" + row["case"])
        self.assertEqual(children_of(run.pid), [])


class ProgressBar(Test):
    WORDS = [PROGRAM, "check", "--subjects", "inproc:reference", "--stems", "bounds", "--cases", "50"]

    def test_silence_in_a_pipe(self):
        self.assertEqual(self.run_program(*self.WORDS[1:]).stderr, "")

    def test_a_bar_on_a_terminal(self):
        ours, theirs = pty.openpty()
        run = subprocess.Popen(self.WORDS, cwd=self.folder, stdout=subprocess.PIPE, stderr=theirs, text=True)
        os.close(theirs)
        seen = b""
        while True:
            try:
                some = os.read(ours, 4096)
            except OSError:  # the terminal's other side is closed
                break
            seen += some
        out, _ = run.communicate(timeout=60)
        os.close(ours)
        self.assertIn("asking [", seen.decode())
        self.assertTrue(seen.endswith(b"\r\x1b[K"), "the bar is wiped away")
        self.assertNotIn("asking", out)


if __name__ == "__main__":
    unittest.main()
