"""A signal leaves a complete partial result and no child process; a second signal ends the program at once."""

import os
import signal
import time
import unittest
import xml.etree.ElementTree

from program import *

SIGNALS = {signal.SIGHUP: 129, signal.SIGINT: 130, signal.SIGTERM: 143}
HANGING_ENGINE = f"exec:/usr/bin/python3 {SOURCE / 'tests/app/motion/motion_engine.py'} hangs"
FOREVER = ["--time-limit", 3600]
PATIENCE = 300  # seconds, after which a program counts as hanging, also under the sanitizers on a busy machine


def children_of(pid):
    """The other processes of the session that this process leads. A dead one does not count, even if unreaped."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[3]) == pid and int(stat.parent.name) != pid and fields[0] != "Z":
            found.append((stat.parent.name, fields[0]))
    return found


def wait_until_asking(pid):
    """Waits until many processes have been seen: each piece of work starts fresh ones, so some pieces are then done."""
    seen = set()

    def are_many():
        seen.update(child for child, _ in children_of(pid))
        return len(seen) >= 16

    wait_until(are_many)


def wait_until_threads_work(pid):
    wait_until(lambda: len(list(pathlib.Path(f"/proc/{pid}/task").iterdir())) > 1)


def wait_until(done):
    end = time.monotonic() + PATIENCE
    while not done() and time.monotonic() < end:
        time.sleep(0.01)


def wait_until_a_child_hangs(pid):
    """Waits until the process loops: it has used more CPU time than starting takes."""
    def cpu_seconds():
        times = []
        for child, _ in children_of(pid):
            try:
                fields = pathlib.Path(f"/proc/{child}/stat").read_text().rpartition(")")[2].split()
                times.append((int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK"))
            except OSError:
                pass
        return max(times, default=0)

    wait_until(lambda: cpu_seconds() > 0.5)


def digits_of(a_scene):
    return sum(c in "123456789" for c in json.dumps([[b["X_WB"], b["shape"]["vertices"]] for b in a_scene["bodies"]]))


def a_case(**change):
    pairs = scene(body(ball(1)), body(ball(1), (3, 0, 0)))
    return {"touchstone": "case/1", "property": "distance.survives", "subject": "reference", "seed": 1, "index": 0,
            "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}, "scene": pairs, **change}


class Interruption(Test):
    def start(self, *words, **options):
        run = subprocess.Popen([PROGRAM, *as_asked(words)], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, start_new_session=True, **options)
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        return run

    def ended(self, run, code):
        out, errors = run.communicate(timeout=PATIENCE)
        self.assertEqual(run.returncode, code, errors)
        self.no_child_of(run.pid)
        return out, errors

    def no_child_of(self, pid):
        end = time.monotonic() + 2  # a killed child disappears a moment later
        while children_of(pid) and time.monotonic() < end:
            time.sleep(0.01)
        self.assertEqual(children_of(pid), [])

    def test_an_interrupted_report_is_complete(self):
        for sent, code in SIGNALS.items():
            with self.subTest(sent):
                out = f"R{code}"
                run = self.start("report", "--subjects", "reference,bullet.double", "--properties", "distance.survives", "--cases", 100000,
                                 "--jobs", 2, "--out", out)
                wait_until_asking(run.pid)
                self.assertFalse((self.folder / out / "index.html").exists())
                run.send_signal(sent)
                said, _ = self.ended(run, code)
                self.assertIn("interrupted", said)
                report = self.json(f"{out}/report.json")
                self.assertIs(report["interrupted"], True)
                self.assertGreater(sum(row["holds"] for row in report["rows"]), 0)
                self.assertIn("nterrupted", (self.folder / out / "index.html").read_text())
                xml.etree.ElementTree.parse(self.folder / out / "junit.xml")
                for row in report["rows"]:
                    if row.get("case"):
                        self.json(f"{out}/{row['case']}")

    def test_a_subject_that_is_given_up_has_not_failed(self):
        for sent, code in SIGNALS.items():
            with self.subTest(sent):
                run = self.start("check", "--subjects", f"{ENGINE} hangs", "--properties", "distance.survives", "--cases", 50,
                                 *FOREVER, "--jobs", 1, "--json", "r.json")
                wait_until_a_child_hangs(run.pid)
                run.send_signal(sent)
                said, _ = self.ended(run, code)
                self.assertIn("interrupted", said)
                self.assertEqual([(row["breaks"], row["holds"]) for row in self.json("r.json")["rows"]], [(0, 4)])

    def test_a_simulation_shows_what_is_known(self):
        falling = body(ball(0.5), (0, 0, 1.75))
        self.file("drop.json", {**scene(falling, body(box(4, 4, 1), (0, 0, -1), mass={"type": "fixed"})),
                                "gravity": [0, 0, -10], "motion": {"sample_times": [k / 16 for k in range(1, 65)]}})
        for sent, code in SIGNALS.items():
            with self.subTest(sent):
                run = self.start("simulate", "drop.json", "--engine", HANGING_ENGINE, *FOREVER, "--out", f"{code}.jsonl")
                wait_until_a_child_hangs(run.pid)
                run.send_signal(sent)
                said, errors = self.ended(run, code)
                self.assertIn("interrupted", errors)
                self.assertRegex(said, r"(?m)^ +1 .* 1$")
                self.assertEqual(len((self.folder / f"{code}.jsonl").read_text().splitlines()), 1)

    def test_soak_counts_what_was_asked(self):
        for sent, code in SIGNALS.items():
            with self.subTest(sent):
                run = self.start("soak", "--pairs", 100000, "--jobs", 2)
                wait_until_threads_work(run.pid)
                run.send_signal(sent)
                said, _ = self.ended(run, code)
                self.assertRegex(said, r"0 disagreements \(interrupted\)\n$")

    def test_minimise_keeps_the_smaller_scene(self):
        """An engine that slowly answers NaN."""
        engine = self.folder / "slow.py"
        engine.write_text("""
import json, sys, time
for line in sys.stdin:
    seq = json.loads(line)["seq"]
    print("asked", file=open(sys.argv[1], "a"))
    time.sleep(0.1)
    card = {"name": "slow", "version": "0", "precision": "binary64", "answers": ["distance"]}
    print(json.dumps({"seq": seq, **({"result": {"distance": None}} if seq > 1 else {"protocol": 1, "card": card})}), flush=True)
""")
        asked = self.folder / "asked"
        slow = f"exec:/usr/bin/python3 {engine} {asked}"
        vertices = [[a * 1.1, b * 1.2, c * 1.3] for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
        large = scene(*[body(hull(vertices), (3.3 * k, 0.1, 0.7), {"w": 3, "x": 1, "y": -2, "z": 1}) for k in range(2)])
        self.file("case.json", a_case(scene=large))
        for sent, code in SIGNALS.items():
            with self.subTest(sent):
                run = self.start("minimise", "case.json", "--subject", slow, "--out", f"{code}.json")
                wait_until(lambda: asked.exists() and asked.read_text().count("asked") > 12)
                run.send_signal(sent)
                said, _ = self.ended(run, code)
                self.assertIn("interrupted", said)
                asked.unlink()
                smaller = self.json(f"{code}.json")
                self.assertIn("interrupted", smaller["note"])
                self.assertEqual(smaller["finding"]["defect"], "garbage")
                self.assertLess(digits_of(smaller["scene"]), digits_of(large))
                self.succeeds("replay", f"{code}.json", "--subject", slow, code=1)

    def test_what_leaves_nothing_ends_at_once(self):
        self.file("case.json", a_case(scene={**a_case()["scene"], "name": "trap"}))
        for sent in SIGNALS:
            with self.subTest(sent):
                run = self.start("replay", "case.json", "--subject", f"exec:{MISBEHAVING} spin", *FOREVER)
                wait_until_a_child_hangs(run.pid)
                self.assertEqual(len(children_of(run.pid)), 1)
                run.send_signal(sent)
                self.ended(run, -sent)
                run = self.start("ask", "mass", "-", stdin=subprocess.PIPE)  # waits for what is never written
                time.sleep(0.3)
                run.send_signal(sent)
                self.ended(run, -sent)

    def test_a_second_signal_ends_it_at_once_with_its_children(self):
        """Two signals come while the program is stopped: the first cannot end it before the second is there."""
        self.file("case.json", a_case(scene={**a_case()["scene"], "name": "trap"}))
        for first in SIGNALS:
            for second in SIGNALS:
                with self.subTest([first, second]):
                    run = self.start("minimise", "case.json", "--subject", f"exec:{MISBEHAVING} spin", *FOREVER)
                    wait_until_a_child_hangs(run.pid)
                    self.assertEqual(len(children_of(run.pid)), 1)
                    run.send_signal(signal.SIGSTOP)
                    run.send_signal(first)
                    if first == second:  # two pending signals of one kind would be one
                        run.send_signal(signal.SIGCONT)
                        time.sleep(0.002)
                    run.send_signal(second)
                    run.send_signal(signal.SIGCONT)
                    said, errors = run.communicate(timeout=PATIENCE)
                    if first != second:
                        self.assertIn(run.returncode, (-first, -second), errors)
                        self.assertEqual((said, errors), ("", ""))
                    self.no_child_of(run.pid)

    def test_what_is_ignored_stays_ignored(self):
        """As under nohup."""
        run = self.start("soak", "--pairs", 2000, "--jobs", 2,
                         preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        wait_until_threads_work(run.pid)
        run.send_signal(signal.SIGHUP)
        said, _ = self.ended(run, 0)
        self.assertNotIn("interrupted", said)


if __name__ == "__main__":
    unittest.main()
