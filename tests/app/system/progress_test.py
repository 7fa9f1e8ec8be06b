"""The bar on a terminal: elapsed and remaining time, and no line wider than the window; no output into a pipe."""

import fcntl
import os
import pty
import re
import struct
import termios
import threading
import time
import unittest

from program import *

SLOW_ENGINE = """
import json, sys, time
name = sys.argv[1]
for line in sys.stdin:
    seq = json.loads(line)["seq"]
    time.sleep(0.01)
    card = {"name": name, "version": "0", "precision": "binary64", "answers": ["distance", "simulation"]}
    says = {"protocol": 1, "card": card} if seq == 1 else {"result": {"verdict": "separated", "distance": None}}
    print(json.dumps({"seq": seq, **says}), flush=True)
"""


class Terminal:
    """Records what a window of one line shows after each chunk of output. Each character takes one column."""

    def __init__(self, columns):
        self.ours, self.theirs = pty.openpty()
        self.written = b""
        self.resize(columns)

    def resize(self, columns):
        fcntl.ioctl(self.theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))

    def read_all(self):
        os.close(self.theirs)
        while True:
            try:
                some = os.read(self.ours, 65536)
            except OSError:  # the terminal's other side is closed
                break
            self.written += some
        os.close(self.ours)

    def lines(self):
        """The bars: each is drawn on a line that was cleared."""
        return self.written.decode().split("\r\x1b[K")[1:]


class ProgressBar(Test):
    def on_terminal(self, columns, *words, code=0, resize_to=None):
        terminal = Terminal(columns)
        run = subprocess.Popen([PROGRAM, *as_asked(words)], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=terminal.theirs, env={**os.environ, "TERM": "xterm"})
        if resize_to:
            theirs = os.dup(terminal.theirs)

            def resize():
                time.sleep(1)
                fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, resize_to, 0, 0))
                os.close(theirs)

            threading.Thread(target=resize).start()
        terminal.read_all()
        out, _ = run.communicate(timeout=60)
        self.assertEqual(run.returncode, code, terminal.written)
        self.assertTrue(terminal.written.endswith(b"\r\x1b[K"), "the bar is wiped away")
        self.assertNotRegex(out.decode(), "asking|left")
        return terminal.lines()

    def slow(self, name="slow"):
        self.file("slow.py", SLOW_ENGINE)
        return f"exec:/usr/bin/python3 {self.folder / 'slow.py'} \"{name}\""

    def check(self, name="slow", cases=10):
        return ["check", "--subjects", self.slow(name), "--properties", "distance.survives", "--cases", cases, "--jobs", 1]

    def test_silence_in_a_pipe(self):
        self.assertEqual(self.run_program("check", "--subjects", "inproc:reference", "--queries", "bounds", "--cases", 50).stderr, "")

    def test_silence_on_a_terminal_that_cannot_wipe(self):
        terminal = Terminal(80)
        run = subprocess.Popen([PROGRAM, "soak", "--pairs", "100"], stdout=subprocess.PIPE, stderr=terminal.theirs,
                               env={**os.environ, "TERM": "dumb"})
        terminal.read_all()
        run.communicate(timeout=60)
        self.assertEqual(terminal.written, b"")

    def test_it_fits_the_window(self):
        for columns in (7, 20, 40, 200):
            with self.subTest(columns):
                lines = self.on_terminal(columns, *self.check("x" * 300), code=1)
                self.assertGreater(len(lines), 3)
                for line in lines:
                    self.assertLess(len(line), columns, line)

    def test_a_window_that_shrinks(self):
        lines = self.on_terminal(200, *self.check("x" * 300, 40), code=1, resize_to=40)
        self.assertGreater(len(lines[0]), 40)
        self.assertLess(max(map(len, lines[-4:])), 40)

    def test_it_tells_the_time(self):
        lines = self.on_terminal(80, *self.check(cases=80), code=1)
        clocks = [re.search(r" (\d+)/(\d+) (\d+:\d\d)(, \d+:\d\d left)?", line) for line in lines if line]
        self.assertTrue(all(clocks), lines)
        self.assertEqual(clocks[0][3], "0:00")
        self.assertIsNone(clocks[0][4], "nothing is known of what remains")
        self.assertIn("0:02", [clock[3] for clock in clocks], "the clock goes on by itself")
        self.assertTrue(any(clock[4] for clock in clocks))

    def test_foreign_names_cannot_move_the_cursor(self):
        lines = self.on_terminal(200, *self.check("evil\x1b[31m\u202e"), code=1)
        self.assertTrue(any("evil\\u001b[31m\\u202e" in line for line in lines), lines)
        self.assertFalse(any("\x1b" in line or "\u202e" in line for line in lines))

    def test_all_that_takes_long_has_one(self):
        case = {"touchstone": "case/1", "property": "distance.survives", "subject": "reference", "seed": 1, "index": 0,
                "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0},
                "scene": scene(body(box(1.1, 1.2, 1.3)), body(ball(1), (3.7, 0, 0)))}
        self.file("case.json", case)
        write_meshes(self.folder / "meshes")
        for words, what, code in ((self.check(), "asking", 1), (self.check(), "reducing", 1),
                                  (["minimise", "case.json", "--subject", self.slow(), "--budget", 9], "reducing", 0),
                                  (["soak", "--pairs", 200], "three routes", 0),
                                  (["report", *self.check()[1:], "--meshes", "meshes", "--out", "R"], "reading meshes", 0),
                                  (["simulate", "bouncing_ball", "--engine", "inproc:fast"], "fast", 0)):
            with self.subTest(words[0]):
                lines = self.on_terminal(80, *words, code=code)
                self.assertTrue(any(line.startswith(what + " [") for line in lines), lines)


if __name__ == "__main__":
    unittest.main()
