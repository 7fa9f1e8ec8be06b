"""The command simulate: energies, events, files, and engines that do not reach the end."""

import os
import pty
import re
import signal
import time
import unittest

import pool_break
from program import *


MOTIONS = sorted(path.stem for path in (SOURCE / "docs/scenes/motion").rglob("*.json"))


def engine(trick):
    return f"exec:/usr/bin/python3 {SOURCE / 'tests/app/motion/motion_engine.py'} {trick}"


def rows(text):
    """Parses the lines of numbers: time, three energies, momentum, impacts."""
    found = [line.split() for line in text.splitlines() if re.match(r" +[0-9.]+ ", line)]
    return [[None if word == "-" else float(word) for word in row] for row in found]


class Simulate(Test):
    def drop(self, **motion):
        """A ball of 1 kg dropped from 1.25 m; its energy is 1 · 10 · 1.75 J."""
        falling = body(ball(0.5), (0, 0, 1.75), mass={"type": "given", "mass": 1, "p_BBcm": [0, 0, 0],
                                                      "I_BBcm_B": [[0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]})
        one = scene(falling, body(box(4, 4, 1), (0, 0, -1), mass={"type": "fixed"}))
        for each in one["bodies"]:
            each["material"] = {"restitution": 1, "friction": 0}
        one["gravity"] = [0, 0, -10]
        if motion:
            one["motion"] = motion
        return self.file("drop.json", one)

    def test_books_and_events(self):
        self.drop(sample_times=[0.25, 0.75, 1.75, 3.0])
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

    def test_engines_beside_that_are_refused(self):
        self.drop(sample_times=[1])
        words = ["simulate", "drop.json", "--engine", engine("right"), "--beside"]
        self.refused(*words, "fast", says=["--beside", "--replay"])
        page = ["--replay", "replay.html"]
        self.refused(*words, "bulet", *page, says=["bulet", "unknown"])
        self.refused(*words, engine("right"), *page, says=["--beside", "shown already"])
        self.refused(*words, "inproc:fast,inproc:fast", *page, says=["--beside", "shown already"])
        self.refused(*words, engine("abstains"), *page, says="not on Sundays")
        five = [word for k in range(5) for word in ("--beside", engine(f"right {k}"))]
        self.refused(*words, "inproc:fast", *five, *page, says=["at most 5 engines, found 6"])

    def test_until(self):
        self.drop()
        self.refused("simulate", "drop.json", "--engine", engine("right"), says="--until")
        found = rows(self.succeeds("simulate", "drop.json", "--engine", engine("right"), "--until", 2))
        self.assertEqual((len(found), found[-1][0]), (21, 2))
        self.drop(sample_times=[0.25, 0.75, 1.75])
        found = rows(self.succeeds("simulate", "drop.json", "--engine", engine("right"), "--until", 1))
        self.assertEqual([row[0] for row in found], [0, 0.25, 0.75, 1])
        found = rows(self.succeeds("simulate", "drop.json", "--engine", engine("right"), "--until", 21.75))
        self.assertEqual([row[0] for row in found], [0, 0.25, 0.75, *(k + 0.75 for k in range(1, 22))])
        self.succeeds("simulate", "drop.json", "--engine", engine("right"), "--until", math.nextafter(1.75, 2))

    def test_a_known_scene_tells_the_error(self):
        out = self.succeeds("simulate", "bouncing_ball_forever", "--engine", engine("right"))
        self.assertLess(float(re.search(r"truth .* off by (\S+)", out)[1]), 1e-12)
        file = SOURCE / "docs/scenes/motion/bouncing/bouncing_ball_forever.json"
        out = self.succeeds("simulate", file, "--engine", engine("right"), "--until", 5)
        self.assertLess(float(re.search(r"truth .* off by (\S+)", out)[1]), 1e-12)
        out = self.succeeds("simulate", "bouncing_ball", "--engine", engine("right"))  # its e is 1/2
        self.assertGreater(float(re.search(r"truth .* off by (\S+)", out)[1]), 0.5)

    def test_the_error_is_told_with_its_time(self):
        looks = json.loads((SOURCE / "docs/scenes/motion/bouncing/bouncing_ball_forever.json").read_text())["motion"]["sample_times"]
        for until, known in ((looks[0], looks[0]), (2 * looks[-1], looks[-1])):
            out = self.succeeds("simulate", "bouncing_ball_forever", "--engine", engine("right"), "--until", until)
            self.assertEqual(float(re.search(r"truth .* off by \S+ until (\S+) s", out)[1]), known)

    def test_engines_by_the_names_that_bench_gives_them(self):
        self.drop(sample_times=[1])
        built = re.findall(r"(?m)^(\S+) +\S+ +answers .*simulation", self.succeeds("list", "subjects"))
        for name, subject in [("bullet", "bullet.simulation"), ("bullet.tuned", "bullet.simulation_tuned"),
                              ("ode", "ode.simulation"), ("ode.quick", "ode.simulation_quick"),
                              ("simbody", "simbody.simulation")]:
            if subject in built:
                self.assertIn(f"engine     {subject} ", self.succeeds("simulate", "newtons_cradle", "--engine", name))
                self.assertIn(f" {name},", self.refused("simulate", "drop.json", "--engine", "nobody", says=name))

    def test_constraint_says_where_its_steps_are_too_long(self):
        self.drop(sample_times=[1])
        self.assertEqual(self.run_program("simulate", "drop.json", "--engine", "constraint").stderr, "")
        self.drop(sample_times=[1e6])  # steps of 244 s
        done = self.run_program("simulate", "drop.json", "--engine", "constraint")
        self.assertEqual(done.returncode, 0)
        self.assertIn("gravity moves bodies[0] by", done.stderr)

    def test_an_engine_that_does_not_get_to_the_end(self):
        looks = [k / 16 for k in range(1, 65)]  # queried until 1/16, 1/4, 1 and 4 s
        for trick, says in [("dies", "broke (exit status 3"), ("hangs", "broke (no answer within "),
                            ("short", "broke (answered 63 samples where there are 64)")]:
            with self.subTest(trick=trick):
                self.drop(sample_times=looks)
                done = self.run_program("simulate", "drop.json", "--engine", engine(trick), "--time-limit", 0.5,
                                        "--out", "events.jsonl")
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(says, done.stderr)
                self.assertIn("until 1 s of 4 s", done.stderr)
                self.assertEqual(rows(done.stdout)[-1][0], 1)
                self.assertEqual(len((self.folder / "events.jsonl").read_text().splitlines()), 1)
        done = self.run_program("simulate", "drop.json", "--engine", engine("gives_up"), "--out", "events.jsonl")
        self.assertEqual(done.returncode, 1)
        self.assertTrue((self.folder / "events.jsonl").exists())
        self.assertIn("gave up at 1 s of 4 s", done.stderr)
        self.assertEqual(rows(done.stdout)[-1][0], 1)

    def test_an_engine_without_events(self):
        self.drop(sample_times=[2])
        out = self.succeeds("simulate", "drop.json", "--engine", engine("silent"))
        self.assertIn("reports none", out)
        self.assertEqual([row[7] for row in rows(out)], [None, None])
        done = self.run_program("simulate", "drop.json", "--engine", engine("silent"), "--out", "events.jsonl")
        self.assertEqual(done.returncode, 2)
        self.assertIn("reports no events", done.stderr)
        self.assertFalse((self.folder / "events.jsonl").exists())

    def test_an_engine_without_events_that_gives_up_says_so_first(self):
        self.drop(sample_times=[0.5, 4])
        done = self.run_program("simulate", "drop.json", "--engine", engine("silent_gives_up"), "--out", "events.jsonl",
                                "--replay", "replay.html")
        self.assertEqual(done.returncode, 2)
        self.assertLess(done.stderr.index("gave up at 1 s of 4 s"), done.stderr.index("reports no events"))
        self.assertEqual([path.name for path in self.files()], ["drop.json", "replay.html"])

    def test_places_that_cannot_be_written(self):
        name = self.drop(sample_times=[1])
        (self.folder / "place").mkdir()
        words = ["simulate", name, "--engine", engine("right")]
        for option in ("--out", "--replay"):
            self.refused(*words, option, "place", says=["place", "is a folder"])
            self.refused(*words, option, "no_folder/x", says="no_folder")
        self.refused(*words, "--out", "both.txt", "--replay", "place/../both.txt", says=["--replay", "--out"])
        self.succeeds(*words, "--out", "/dev/null")

    @unittest.skipIf(is_root(), "root may write everywhere")
    def test_a_folder_that_is_not_ours(self):
        (self.folder / "locked").mkdir(mode=0o500)
        self.refused("simulate", self.drop(sample_times=[1]), "--engine", engine("right"), "--out", "locked/x", says="locked")

    def overlapping(self, first, second, p=(0, 0, 0), **motion):
        """The second body is fixed at the origin."""
        one = scene(body(first, p), body(second, mass={"type": "fixed"}))
        one["motion"] = {"sample_times": [1], **motion}
        return one

    def test_overlap_at_the_start_is_bad_input(self):
        named = self.overlapping(ball(1), ball(2), (0, 2.5, 0))
        named["bodies"][0]["name"], named["bodies"][1]["name"] = "ball", "table"
        union = {"type": "compound", "parts": [{"shape": shape, "X_BP": {"p": [x, 0, 0], "q": NO_TURN}}
                                               for shape, x in ((ball(1), 0), (box(1, 1, 1), 5))]}
        for content, names, depth in [
                (named, ["bodies[0] (ball)", "bodies[1] (table)"], "0.5 m"),
                (self.overlapping(box(1, 1, 1), box(1, 1, 1), (0, 0, 1.75)), ["bodies[0]", "bodies[1]"], "0.25 m"),
                (self.overlapping(box(1, 1, 1), union, (6.5, 0, 0)), ["bodies[0]", "bodies[1]"], "0.5 m"),
                (self.overlapping(ball(1), ball(1), (0, 1, 0), start_times=[0.5, 0]), ["bodies[0]", "bodies[1]"], "1 m")]:
            self.file("overlap.json", content)
            for who in (engine("right"), "inproc:fast", "inproc:reference", "constraint"):
                with self.subTest(names=names, depth=depth, engine=who):
                    error = self.refused("simulate", "overlap.json", "--engine", who, "--out", "events.jsonl",
                                         says=["overlap.json", *names, "at the start by " + depth])
                    self.assertEqual(error.count("overlap.json"), 1, error)

    def test_what_touches_is_no_overlap(self):
        for first, second, p in [(ball(1), ball(2), (0, 3, 0)), (ball(0.1), ball(0.2), (0, 0, 0.3)),  # 0.1 + 0.2 > 0.3
                                 (box(1, 1, 1), box(1, 1, 1), (0, 0, 2))]:
            self.file("touching.json", self.overlapping(first, second, p))
            self.succeeds("simulate", "touching.json", "--engine", "inproc:fast")
        for first, mass in [(box(1, 1, 0.1), {"type": "fixed"}), (ball(0.1), {"type": "density", "density": 1})]:
            rounded = self.overlapping(first, box(1, 1, 0.2), (0, 0, 0.3))
            rounded["bodies"][1]["mass"] = mass
            self.file("rounded.json", rounded)
            self.refused("simulate", "rounded.json", says="at the start by 2.77556e-17 m")
        walls = [body(box(4, 4, 1), (0, 0, -1), mass={"type": "fixed"}), body(box(1, 4, 4), mass={"type": "fixed"})]
        self.file("walls.json", {**scene(*walls, body(ball(1), (5, 0, 1))), "motion": {"sample_times": [1]}})
        self.succeeds("simulate", "walls.json", "--engine", "inproc:fast")

    def test_bad_input(self):
        name = self.drop(sample_times=[1])
        self.refused("simulate", "no_such_scene", says=["no_such_scene", "list motions"])
        self.refused("simulate", name, "--engine", engine("abstains"), says="not on Sundays")
        error = self.refused("simulate", name, "--engine", "nobody", says=["nobody", "constraint", "fast", "reference"])
        self.assertNotIn("sweep_and_prune", error)  # a subject without simulation
        for until in ("-1", "0", "nan", "inf", "soon"):
            self.refused("simulate", name, f"--until={until}", says="--until")
        self.drop(sample_times=[1, 0.5])
        self.refused("simulate", name, says="motion.sample_times")
        one = json.loads((self.folder / self.drop(sample_times=[1])).read_text())
        self.file("broken.json", {**one, "motion": {"sample_times": []}})
        error = self.refused("simulate", "broken.json", says=["broken.json", "motion.sample_times"])
        self.assertEqual(error.count("broken.json"), 1, error)

    def test_ctrl_c_leaves_what_is_known(self):
        self.drop(sample_times=[k / 16 for k in range(1, 65)])
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
        self.drop(sample_times=[1])
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
        self.assertEqual(named, MOTIONS)

    def test_fast_is_near_the_truth(self):
        # An impact may come an envelope too early, 2^-30 of a size; the contacts of balls are found more exactly.
        for name in ("bouncing_ball", "rough_ball", "slide_to_roll", "ball_rolls_down_ramp", "newtons_cradle", "pool_break",
                     "gas", "balls_49", "ramp_sticks", "top_middle_axis"):
            with self.subTest(name=name):
                out = self.succeeds("simulate", name, "--engine", "inproc:fast")
                self.assertLess(float(re.search(r"truth .* off by (\S+)", out)[1]), 2 ** -30)

    def test_the_pool_break_is_what_60_digits_say(self):
        told = (SOURCE / "app/motion/scenes/pool_break_truth.h").read_text()
        made = subprocess.run(["/usr/bin/python3", SOURCE / "tests/app/motion/pool_break.py"], capture_output=True, text=True, check=True)
        self.assertEqual(made.stdout, told)
        looks, _ = pool_break.run()
        bodies = json.loads((SOURCE / "docs/scenes/motion/billiards/pool_break.json").read_text())["bodies"]
        self.assertEqual([b["X_WB"]["p"][:2] for b in bodies], [[float(x), float(y)] for (x, y), _ in pool_break.start()])
        self.assertEqual(len(looks), 16)


if __name__ == "__main__":
    unittest.main()
