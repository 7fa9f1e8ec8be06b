"""`touchstone serve` and its client for Python: scenes whose truth is computed by hand, and what goes wrong."""

import array
import doctest
import io
import os
import re
import sys
import threading
import unittest
from fractions import Fraction

from program import *

sys.path.insert(0, str(SOURCE / "adapters/python"))
import touchstone_exact
from touchstone_exact import Exact, Refused, box, compound, polytope, sphere

PAGE = SOURCE / "docs/how_to/ask_from_python.md"
TETRAHEDRON_AND_BALL = polytope(TETRAHEDRON), sphere(1, p=(4, 0, 0))


STAND_IN = """
from touchstone_exact import *
DIRECT, GEOM_SPHERE, GEOM_BOX = range(3)
connect = disconnect = lambda world: None
def createCollisionShape(kind, radius=None, halfExtents=None):
    return sphere(radius) if kind == GEOM_SPHERE else box(*[FACTOR * h for h in halfExtents])
def createMultiBody(baseCollisionShapeIndex, basePosition, baseOrientation):
    x, y, z, w = baseOrientation
    return body(baseCollisionShapeIndex["shape"], p=basePosition, q=(w, x, y, z))
def getClosestPoints(a, b, distance):
    return [[0] * 8 + [exact.distance(a, b).distance]]
"""


def ended(exact):
    exact.process.stdin.close()
    exact.process.stdout.read()
    exact.process.stdout.close()
    return exact.process.wait(60)


class Service(Test):
    """One process for all tests: each question is answered whatever was asked before."""

    @classmethod
    def setUpClass(cls):
        cls.exact = Exact([PROGRAM])

    @classmethod
    def tearDownClass(cls):
        assert ended(cls.exact) == 0, "it ends with its stdin"


class Answers(Service):
    def test_distance(self):
        # Corners (1, 1, 1) and (2, 3, 3): d² = 1 + 4 + 4.
        said = self.exact.distance(box(1, 1, 1), box(1, 1, 1, p=(3, 4, 4)))
        self.assertEqual((said.verdict, said.distance, said.squared_distance_of_cores), ("separated", 3, Fraction(9)))
        self.assertIsInstance(said.squared_distance_of_cores, Fraction)
        self.assertEqual((said.witness_A, said.certificate.checked), ([1, 1, 1], "by the independent checker: holds"))
        # No double is 2.1; what 2.1 reads as is less than 2 + 1/10 by 2^-52·0.4, so the gap has 52 bits of its own.
        gap = Fraction(2.1) - 2
        self.assertEqual(self.exact.distance(box(1, 1, 1), box(1, 1, 1, p=(2.1, 0, 0))).squared_distance_of_cores, gap**2)

    def test_a_turned_box_a_hull_and_a_union(self):
        # A quarter turn about z: the half extents become (1, 3, 1), and 4 - 1 - 1 = 2.
        quarter = box(3, 1, 1, q=(1, 0, 0, 1))
        self.assertEqual(self.exact.distance(quarter, box(1, 1, 1, p=(4, 0, 0))).distance, 2)
        self.assertEqual(self.exact.distance(*TETRAHEDRON_AND_BALL).distance, 2)  # 4 - 1 - 1
        # The second part's centre is at (0, 5, 0) + (0, 2, 0).
        union = compound(sphere(1), sphere(2, p=(0, 2, 0)), p=(0, 5, 0))
        self.assertEqual(self.exact.distance(union, box(1, 1, 1, p=(0, 12, 0))).distance, 2)  # 12 - 1 - (7 + 2)

    def test_penetration(self):
        said = self.exact.penetration(box(1, 1, 1), box(1, 1, 1, p=(1.5, 0, 0)))
        self.assertEqual((said.verdict, said.depth, said.squared_depth_of_cores), ("overlapping", 0.5, Fraction(1, 4)))

    def test_mass(self):
        (tetrahedron,) = self.exact.mass(polytope(TETRAHEDRON)).bodies
        least, most = map(Fraction, tetrahedron.mass)
        self.assertLess(least, Fraction(1, 6))  # a sixth of the cube, of density 1
        self.assertLess(Fraction(1, 6), most)
        self.assertEqual(math.nextafter(tetrahedron.mass[0], 1), tetrahedron.mass[1])

    def test_impulse(self):
        # Equal cubes, head on, e = 1: they exchange velocities.
        cubes = [box(1, 1, 1, velocity={"v_WBcm": [1, 0, 0], "w_WB": [0, 0, 0]}), box(1, 1, 1, p=(2, 0, 0))]
        contact = {"p_WC": [1, 0, 0], "nhat_BA_W": [-1, 0, 0], "restitution": 1, "friction": 0}
        said = self.exact.impulse({**scene(*cubes), "contact": contact})
        self.assertEqual((said.after_A.v_WBcm, said.after_B.v_WBcm), ((0, 0, 0), (1, 0, 0)))
        self.assertIsInstance(said.after_B.v_WBcm[0], Fraction)

    def test_time_of_impact(self):
        # A gap of 2 m at 1 m/s.
        balls = [sphere(1, velocity={"v_WBcm": [1, 0, 0], "w_WB": [0, 0, 0]}), sphere(1, p=(4, 0, 0))]
        said = self.exact.time_of_impact({**scene(*balls), "motion": {"sample_times": [5]}})
        self.assertEqual(said.status, "hit")
        self.assertLessEqual(said.apart_before, 2)
        self.assertGreaterEqual(said.met_by, 2)

    def test_bounds_and_broad_phase(self):
        (of_ball,) = self.exact.bounds(sphere(0.5, p=(1, 2, 3))).boxes
        self.assertEqual((of_ball.lo, of_ball.hi), ((0.5, 1.5, 2.5), (1.5, 2.5, 3.5)))
        self.assertEqual(self.exact.broad_phase(sphere(1), sphere(1, p=(1, 0, 0)), sphere(1, p=(9, 0, 0))).overlapping_boxes,
                         [[0, 1]])

    def test_each_query_that_ask_prints_has_a_function(self):
        listed = re.search(r"QUERY REQUIRED +([a-z_, \n]+)\n", self.succeeds("help", "ask"))
        for query in re.split(r",\s+", listed[1].strip()):
            self.assertTrue(callable(getattr(self.exact, query)), query)

    def test_numbers_of_arrays(self):
        self.assertEqual(self.exact.distance(sphere(1), sphere(1, p=array.array("f", [4, 0, 0]))).distance, 2)

    def test_threads_take_turns(self):
        def ask(k):
            said[k] = [self.exact.distance(sphere(1), sphere(1, p=(3 + k, 0, 0))).distance for _ in range(20)]

        said = {}
        threads = [threading.Thread(target=ask, args=(k,), daemon=True) for k in range(4)]
        [thread.start() for thread in threads]
        [thread.join(60) for thread in threads]
        self.assertEqual(said, {k: [1 + k] * 20 for k in range(4)})


class Refusals(Service):
    def test_the_place_is_named(self):
        for place, ask in {
            "scene.bodies[1].shape.radius: expected a number above 0": lambda e: e.distance(sphere(1), sphere(-1)),
            "scene.bodies[0].X_WB.q: zero": lambda e: e.mass(box(1, 1, 1, q=(0, 0, 0, 0))),
            "scene.bodies: the query distance is about bodies 0 and 1": lambda e: e.distance(sphere(1)),
            "scene.contact: missing": lambda e: e.impulse(sphere(1), sphere(1)),
            "scene.bodies[0].shape.radius: expected a finite number, found NaN": lambda e: e.mass(sphere(math.nan)),
            "simulation: no exact answer is printed": lambda e: e.ask(
                "simulation", {**scene(body(ball(1))), "motion": {"sample_times": [1]}}),
            "gravity: no gravity query": lambda e: e.ask("gravity", sphere(1)),
        }.items():
            with self.subTest(place):
                with self.assertRaises(Refused) as caught:
                    ask(self.exact)
                self.assertIn(place, str(caught.exception))
        self.assertEqual(self.exact.distance(sphere(1), sphere(1, p=(3, 0, 0))).distance, 1)

    def test_a_quaternion_has_four_numbers(self):
        with self.assertRaises(ValueError):
            box(1, 1, 1, q=(1, 0, 0))

    def test_a_program_that_ends(self):
        mute = Exact(["/bin/false"])
        with self.assertRaisesRegex(RuntimeError, "/bin/false serve ended with exit code 1"):
            mute.mass(sphere(1))
        self.exact.mass(sphere(1))
        self.exact.process.kill()
        ended(self.exact)
        self.assertEqual(self.exact.distance(sphere(1), sphere(1, p=(3, 0, 0))).distance, 1)

    def test_an_interrupted_question_leaves_no_answer_behind(self):
        self.exact.mass(sphere(1))
        self.exact.seq += 1
        self.exact.process.stdin.write(json.dumps({"op": "ask", "seq": self.exact.seq, "query": "mass",
                                                   "scene": scene(body(ball(1)))}) + "\n")
        self.assertEqual(self.exact.distance(sphere(1), sphere(1, p=(3, 0, 0))).distance, 1)


class Lines(Test):
    def served(self, text, **options):
        return subprocess.run([PROGRAM, "serve"], input=text, capture_output=True, text=True, timeout=60, **options)

    def test_the_lines_of_the_page(self):
        """In each block, lines with > are questions and lines with < are the answers."""
        blocks = re.findall(r"```session\n(.*?)```", PAGE.read_text(), re.DOTALL)
        self.assertTrue(blocks)
        for block in blocks:
            lines = block.splitlines()
            done = self.served("".join(line[2:] + "\n" for line in lines if line.startswith("> ")))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(["< " + line for line in done.stdout.splitlines()], [line for line in lines if line.startswith("< ")])

    def test_stdout_that_accepts_nothing(self):
        question = json.dumps({"op": "ask", "seq": 1, "query": "mass", "scene": scene(body(ball(1)))}) + "\n"
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "serve"], input=question, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (3, "touchstone: stdout: cannot write: No space left on device\n"))
        reads, writes = os.pipe()
        os.close(reads)
        done = subprocess.run([PROGRAM, "serve"], input=question, stdout=writes, stderr=subprocess.PIPE, text=True, timeout=60)
        os.close(writes)
        self.assertEqual((done.returncode, done.stderr), (141, ""))


class Page(Test):
    def test_the_examples_print_what_the_page_says(self):
        blocks = re.findall(r"```pycon\n(.*?)```", PAGE.read_text(), re.DOTALL)
        self.assertTrue(blocks)
        shown = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, PAGE.name, str(PAGE), 0)
        os.environ["TOUCHSTONE"] = PROGRAM
        failures = io.StringIO()
        result = doctest.DocTestRunner(verbose=False).run(shown, out=failures.write)
        self.assertEqual(result.failed, 0, failures.getvalue())
        self.assertGreater(result.attempted, 5)
        ended(touchstone_exact.exact)

    def test_the_example_for_pytest(self):
        """With a stand-in for PyBullet that is right, and with one that takes the half extents of a box for its extents.
        It forwards to the program: this tests the example, not an engine."""
        if subprocess.run(["/usr/bin/python3", "-c", "import pytest"], capture_output=True).returncode:
            self.skipTest("pytest is not installed")
        self.assertIn("1 skipped", self.run_example(code=5))
        self.file("pybullet.py", STAND_IN.replace("FACTOR", "1"))
        self.assertIn("81 passed", self.run_example(code=0))
        self.file("pybullet.py", STAND_IN.replace("FACTOR", "0.5"))
        self.assertIn("failed", self.run_example(code=1))

    def run_example(self, code):
        done = subprocess.run(["/usr/bin/python3", "-m", "pytest", "-q", "-p", "no:cacheprovider",
                               SOURCE / "docs/examples/pybullet_distance_test.py"], capture_output=True, text=True, timeout=60,
                              cwd=self.folder, env={**os.environ, "TOUCHSTONE": PROGRAM, "PYTHONDONTWRITEBYTECODE": "1",
                                                    "PYTHONPATH": f"{SOURCE}/adapters/python:{self.folder}"})
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout

    def test_the_client_is_as_short_as_the_page_says(self):
        text = (SOURCE / "adapters/python/touchstone_exact.py").read_text()
        self.assertLessEqual(len([line for line in re.sub(r'""".*?"""', "", text, flags=re.DOTALL).splitlines() if line.strip()]), 60)


if __name__ == "__main__":
    unittest.main()
