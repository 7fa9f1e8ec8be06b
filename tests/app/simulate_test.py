"""What happens next: books, events, files, and what becomes of an engine that does not get to the end."""

import os
import pty
import re
import signal
import sys
import time
import unittest

from program import *

sys.path.insert(0, str(SOURCE / "tests/app"))
import pool_break  # noqa: E402

MOTIONS = sorted(p.name for p in (SOURCE / "docs/scenes").glob("motion_*.json"))


def engine(trick):
    return f"exec:/usr/bin/python3 {SOURCE / 'tests/app/motion_engine.py'} {trick}"


def rows(text):
    """Lines of numbers: time, three energies, momentum, impacts."""
    found = [line.split() for line in text.splitlines() if re.match(r" +[0-9.]+ ", line)]
    return [[None if word == "-" else float(word) for word in row] for row in found]


class Simulate(Test):
    def drop(self, **flight):
        """A ball of 1 kg dropped from 1.25 m; energy 1 · 10 · 1.75 J."""
        falling = body(ball(0.5), (0, 0, 1.75), mass={"type": "given", "mass": 1, "p_BBcm": [0, 0, 0],
                                                      "I_BBcm_B": [[0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]})
        one = scene(falling, body(box(4, 4, 1), (0, 0, -1), mass={"type": "fixed"}))
        for each in one["bodies"]:
            each["material"] = {"restitution": 1, "friction": 0}
        one["gravity"] = [0, 0, -10]
        if flight:
            one["flight"] = flight
        return self.file("drop.json", one)

    def test_books_and_events(self):
        self.drop(times=[0.25, 0.75, 1.75, 3.0])
        out = self.succeeds("simulate", "drop.json", "--engine", engine("right"), "--out", "events.jsonl")
        found = rows(out)
        self.assertEqual([row[0] for row in found], [0, 0.25, 0.75, 1.75, 3])
        for row in found:
            self.assertTrue(near(row[3], 17.5, 1e-6), row)
        self.assertEqual(found[0][1:4], [0, 17.5, 17.5])
        self.assertTrue(near(found[1][1], 0.5 * 2.5 ** 2, 1e-6) and near(found[1][6], -2.5, 1e-6))
        self.assertEqual([row[7] for row in found], [0, 0, 1, 2, 3])
        self.assertIn("impact 3, micro_collision 0", out)
        events = [json.loads(line) for line in (self.folder / "events.jsonl").read_text().splitlines()]
        self.assertEqual([event["kind"] for event in events], ["impact"] * 3)
        self.assertTrue(near(events[2]["time"], 2.5, 1e-12))

    def test_until(self):
        self.drop()
        self.refused("simulate", "drop.json", "--engine", engine("right"), says="--until")
        found = rows(self.succeeds("simulate", "drop.json", "--engine", engine("right"), "--until", 2))
        self.assertEqual((len(found), found[-1][0]), (21, 2))
        self.drop(times=[0.25, 0.75, 1.75])
        found = rows(self.succeeds("simulate", "drop.json", "--engine", engine("right"), "--until", 1))
        self.assertEqual([row[0] for row in found], [0, 0.25, 0.75, 1])

    def test_a_known_scene_tells_the_error(self):
        out = self.succeeds("simulate", "bouncing_ball_forever", "--engine", engine("right"))
        self.assertLess(float(re.search(r"truth .* off by (\S+)", out)[1]), 1e-12)
        file = SOURCE / "docs/scenes/motion_bouncing_ball_forever.json"
        out = self.succeeds("simulate", file, "--engine", engine("right"), "--until", 5)
        self.assertLess(float(re.search(r"truth .* off by (\S+)", out)[1]), 1e-12)
        out = self.succeeds("simulate", "bouncing_ball", "--engine", engine("right"))  # whose e is 1/2
        self.assertGreater(float(re.search(r"truth .* off by (\S+)", out)[1]), 0.5)

    def test_an_engine_that_does_not_get_to_the_end(self):
        looks = [k / 16 for k in range(1, 65)]  # asked about until 1/16, 1/4, 1 and 4 s
        for trick, says in [("dies", "broke (exit status 3"), ("hangs", "broke (no answer within "),
                            ("short", "broke (answered 63 looks where there are 64)")]:
            with self.subTest(trick=trick):
                self.drop(times=looks)
                done = self.run_program("simulate", "drop.json", "--engine", engine(trick), "--time-limit", 0.5,
                                        "--out", "events.jsonl")
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(says, done.stderr)
                self.assertIn("until 1 s of 4 s", done.stderr)
                self.assertEqual(rows(done.stdout)[-1][0], 1)
                self.assertEqual(len((self.folder / "events.jsonl").read_text().splitlines()), 1)
        done = self.run_program("simulate", "drop.json", "--engine", engine("gives_up"))
        self.assertEqual(done.returncode, 0)
        self.assertIn("gave up at 1 s of 4 s", done.stderr)
        self.assertEqual(rows(done.stdout)[-1][0], 1)

    def test_an_engine_without_events(self):
        self.drop(times=[2])
        out = self.succeeds("simulate", "drop.json", "--engine", engine("silent"))
        self.assertIn("tells none", out)
        self.assertEqual([row[7] for row in rows(out)], [None, None])
        done = self.run_program("simulate", "drop.json", "--engine", engine("silent"), "--out", "events.jsonl")
        self.assertEqual(done.returncode, 2)
        self.assertIn("tells no events", done.stderr)
        self.assertFalse((self.folder / "events.jsonl").exists())

    def test_bad_input(self):
        name = self.drop(times=[1])
        self.refused("simulate", "no_such_scene", says=["no_such_scene", "list motions"])
        self.refused("simulate", name, "--engine", engine("abstains"), says="not on Sundays")
        self.refused("simulate", name, "--engine", "nobody", says="nobody")
        self.refused("simulate", name, "--out", "no_folder/x.jsonl", says="no_folder")
        self.refused("simulate", name, "--replay", "no_folder/x.html", says="no_folder")
        for until in ("-1", "0", "nan", "inf", "soon"):
            self.refused("simulate", name, f"--until={until}", says="--until")
        self.drop(times=[1, 0.5])
        self.refused("simulate", name, says="flight.times")
        one = json.loads((self.folder / self.drop(times=[1])).read_text())
        self.file("broken.json", {**one, "flight": {"times": []}})
        self.refused("simulate", "broken.json", says="broken.json")

    def test_ctrl_c_leaves_what_is_known(self):
        self.drop(times=[k / 16 for k in range(1, 65)])
        run = subprocess.Popen([PROGRAM, "simulate", "drop.json", "--engine", engine("hangs"), "--out", "events.jsonl"],
                               cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
        time.sleep(1.5)
        run.send_signal(signal.SIGINT)
        out, errors = run.communicate(timeout=30)
        self.assertEqual(run.returncode, 130, errors)
        self.assertIn("interrupted", errors)
        self.assertEqual(rows(out)[-1][0], 1)
        self.assertEqual(len((self.folder / "events.jsonl").read_text().splitlines()), 1)

    def test_a_bar_on_a_terminal_alone(self):
        self.drop(times=[1])
        words = [PROGRAM, "simulate", "drop.json", "--engine", engine("right")]
        self.assertEqual(self.run_program(*words[1:]).stderr, "")
        ours, theirs = pty.openpty()
        run = subprocess.Popen(words, cwd=self.folder, stdout=subprocess.PIPE, stderr=theirs)
        os.close(theirs)
        seen = b""
        try:
            while some := os.read(ours, 4096):
                seen += some
        except OSError:  # the terminal's other side is closed
            pass
        run.communicate(timeout=60)
        os.close(ours)
        self.assertIn("right [", seen.decode())
        self.assertTrue(seen.endswith(b"\r\x1b[K"))


class Scenes(Test):
    def test_the_list_names_the_files(self):
        named = re.findall(r"(?m)^(\w+) ", self.succeeds("list", "motions"))
        self.assertEqual([f"motion_{name}.json" for name in named], MOTIONS)

    def test_fast_is_near_the_truth(self):
        # An impact may come an envelope too soon, 2^-30 of a size; balls are met closer than that.
        for name in ("bouncing_ball", "rough_ball", "slide_to_roll", "ball_rolls_down_ramp", "newtons_cradle", "pool_break",
                     "gas", "balls_49", "ramp_sticks", "top_middle_axis"):
            with self.subTest(name=name):
                out = self.succeeds("simulate", name, "--engine", "inproc:fast")
                self.assertLess(float(re.search(r"truth .* off by (\S+)", out)[1]), 2 ** -30)

    def test_the_pool_break_is_what_60_digits_say(self):
        told = (SOURCE / "app/motion_scenes/pool_break_truth.h").read_text()
        made = subprocess.run(["/usr/bin/python3", SOURCE / "tests/app/pool_break.py"], capture_output=True, text=True, check=True)
        self.assertEqual(made.stdout, told)
        looks, _ = pool_break.run()
        bodies = json.loads((SOURCE / "docs/scenes/motion_pool_break.json").read_text())["bodies"]
        self.assertEqual([b["X_WB"]["p"][:2] for b in bodies], [[float(x), float(y)] for (x, y), _ in pool_break.start()])
        self.assertEqual(len(looks), 16)


if __name__ == "__main__":
    unittest.main()
