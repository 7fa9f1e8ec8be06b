"""Usage: engines_test.py ROOT PROGRAM. The adapters of engines in adapters/engines: each passes `adapter check`, and its
snippets ask the engine by themselves; Rapier's show three of its faults. The engines are looked for in the folder node_modules that
TOUCHSTONE_NODE_MODULES names, or in adapters/engines/node_modules (made by `npm ci` there). Without them, or without
Node.js, says so and exits with code 77, which CTest reports as skipped."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
SKIPPED = 77
MODULES = pathlib.Path(os.environ.get("TOUCHSTONE_NODE_MODULES", ROOT / "adapters/engines/node_modules"))
PACKAGES = {"rapier": "@dimforge/rapier3d-compat", "mujoco": "mujoco-js", "cannon.tuned": "cannon-es",
            "jolt": "jolt-physics", "jolt.simulation": "jolt-physics", "jolt.tuned": "jolt-physics",
            "physx": "physx-js-webidl", "physx.simulation": "physx-js-webidl", "physx.tuned": "physx-js-webidl"}
NUMBER = r"(-?[\d.]+(?:e-?\d+)?)"


def numbers_after(words, text):
    return [float(number) for number in re.findall(words + " *" + NUMBER, text)]


class Engines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="touchstone_")
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        for part in ("engines", "js"):
            shutil.copytree(ROOT / "adapters" / part, cls.folder / part, ignore=shutil.ignore_patterns("node_modules"))
        (cls.folder / "engines/node_modules").symlink_to(MODULES)

    def run_program(self, *words):
        return subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True, timeout=300)

    def test_they_are_small_and_pass(self):
        for name in PACKAGES:
            self.assertLess(len((ROOT / f"adapters/engines/{name}.mjs").read_text().splitlines()), 80, name)
            done = self.run_program("adapter", "check", f"exec:node engines/{name}.mjs")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def fault(self, name):
        """The finding, and what each snippet of the case prints: a law about two answers has two."""
        done = self.run_program("minimise", ROOT / f"tests/adapters/faults/{name}.json", "--budget", 1, "--subject",
                                "exec:node engines/rapier.mjs", "--out", "case.json")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        case = json.loads((self.folder / "case.json").read_text())
        printed = [self.printed_by(said["snippet"]) for said in (case, case.get("changed")) if said]
        for text in printed:
            self.assertTrue(text.startswith(f"expected: {case['finding']['expected']}\n"), text)
        return case["finding"], printed

    def snippet(self, name, query, scene):
        lines = [{"op": "start", "seq": 1, "protocol": 1}, {"op": "reproduce", "seq": 2, "query": query, "scene": scene}]
        done = subprocess.run(["node", f"engines/{name}.mjs"], input="".join(json.dumps(line) + "\n" for line in lines),
                              cwd=self.folder, capture_output=True, text=True, timeout=60)
        return json.loads(done.stdout.splitlines()[1])["snippet"]

    def printed_by(self, snippet):
        done = subprocess.run(["node", "--input-type=module"], input=snippet, cwd=self.folder / "engines", capture_output=True,
                              text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_snippets_ask_what_their_adapter_asks(self):
        """A box of 8 m³ is 1 m from the corner (1, 0, 0) of a tetrahedron."""
        pose = {"q": {"w": 1, "x": 0, "y": 0, "z": 0}}
        box = {"shape": {"type": "box", "half_extents": [1, 1, 1]}, "X_WB": {"p": [3, 0, 0], **pose}}
        hull = {"shape": {"type": "polytope", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]},
                "X_WB": {"p": [0, 0, 0], **pose}}
        scene = {"touchstone": "scene/1", "bodies": [box, hull]}
        for query, words, expected in [("distance", "distance:", 1), ("penetration", "distance:", 1), ("mass", "mass:", 8)]:
            for name in ("mujoco", "jolt", "physx"):
                printed = self.printed_by(self.snippet(name, query, scene))
                self.assertAlmostEqual(numbers_after(words, printed)[0], expected, delta=1e-6, msg=name)
        for name in ("jolt", "physx"):
            boxes = numbers_after(r"[\[,]", self.printed_by(self.snippet(name, "bounds", scene)).replace(" ", ""))
            for number, expected in zip(boxes, [2, -1, -1, 4, 1, 1, 0, 0, 0, 1, 1, 1], strict=True):
                self.assertAlmostEqual(number, expected, delta=1e-6, msg=name)

    def test_snippets_of_casts(self):
        """The same box moves at 2 m/s and is there after half a second."""
        pose = {"q": {"w": 1, "x": 0, "y": 0, "z": 0}}
        box = {"shape": {"type": "box", "half_extents": [1, 1, 1]}, "X_WB": {"p": [3, 0, 0], **pose},
               "velocity": {"v_WBcm": [-2, 0, 0], "w_WB": [0, 0, 0]}}
        hull = {"shape": {"type": "polytope", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]},
                "X_WB": {"p": [0, 0, 0], **pose}}
        scene = {"touchstone": "scene/1", "bodies": [box, hull], "motion": {"sample_times": [4]}}
        for name in ("rapier", "jolt", "physx"):
            time, = numbers_after("time:", self.printed_by(self.snippet(name, "time_of_impact", scene)))
            self.assertAlmostEqual(time, 0.5, delta=1e-3, msg=name)

    def test_a_snippet_of_a_simulation(self):
        """It takes the adapter's steps, so it prints the adapter's numbers."""
        pose, fixed = {"q": {"w": 1, "x": 0, "y": 0, "z": 0}}, {"type": "fixed"}
        ball = {"shape": {"type": "sphere", "radius": 0.5}, "X_WB": {"p": [0, 0, 1], **pose},
                "velocity": {"v_WBcm": [0, 0, -2], "w_WB": [0, 1, 0]}, "material": {"restitution": 0.5, "friction": 0}}
        floor = {"shape": {"type": "box", "half_extents": [9, 9, 1]}, "X_WB": {"p": [0, 0, -1], **pose}, "mass": fixed,
                 "material": {"restitution": 0.75, "friction": 0}}
        motion = {"sample_times": [0.125, 0.5], "force_bound": 1,
                  "forces": [{"time": 0.25, "body": 0, "force_W": [1, 0, 0]}]}
        scene = {"touchstone": "scene/1", "gravity": [0, 0, -4], "bodies": [ball, floor], "motion": motion}
        lines = [{"op": "start", "seq": 1, "protocol": 1},
                 {"op": "ask", "seq": 2, "query": "simulation", "scene": scene}]
        done = subprocess.run(["node", "engines/rapier.mjs"], input="".join(json.dumps(line) + "\n" for line in lines),
                              cwd=self.folder, capture_output=True, text=True, timeout=60)
        states = json.loads(done.stdout.splitlines()[1])["result"]["states"]
        printed = numbers_after("[xyzw]:", self.printed_by(self.snippet("rapier", "simulation", scene)))
        said = [number for bodies in states for body in bodies for part in (body["X_WB"]["p"], body["X_WB"]["q"],
                body["velocity"]["v_WBcm"], body["velocity"]["w_WB"])
                for number in (part if isinstance(part, list) else [part[axis] for axis in "xyzw"])]
        self.assertEqual(printed, said)

    def test_cannon_as_shipped_differs_by_its_own_fault(self):
        """The same adapter, tuned, passes. As shipped the engine gives speed to a ball that should stay on the floor."""
        done = self.run_program("adapter", "check", "exec:node engines/cannon.mjs", "--json")
        wrong = {said["query"]: said["wrong"] for said in json.loads(done.stdout)["queries"]}
        self.assertGreater(wrong.pop("simulation"), 0)
        self.assertEqual(set(wrong.values()), {0})

    def test_a_snippet_of_cannon_asks_what_its_adapter_asks(self):
        scene = {"touchstone": "scene/1", "bodies": [{"shape": {"type": "box", "half_extents": [1, 2, 4]},
                 "X_WB": {"p": [8, 0, 0], "q": {"w": 1, "x": 0, "y": 0, "z": 1}}}]}  # a quarter turn about z
        printed = self.printed_by(self.snippet("cannon.tuned", "bounds", scene))
        self.assertEqual([round(x, 9) for x in numbers_after("[xyz]:", printed)], [6, -1, -4, 10, 1, 4])

    def test_inertia_depends_on_the_order_of_the_vertices(self):
        """A hull of 1 m x 2 m x 2 m and 4 kg has the moments 8/3, 5/3 and 5/3 kg m²."""
        finding, printed = self.fault("order_dependent_inertia")
        self.assertEqual((finding["outcome"], finding["defect"]), ("fails", "relabelled"))
        self.assertGreater(finding["relative"], 0.37)
        about_x = [numbers_after(r"about x gives DI \{ x:", said)[0] for said in printed]
        self.assertAlmostEqual(about_x[0], 3 / 5, delta=1e-6)  # 1/I: of a wrong axis
        self.assertAlmostEqual(about_x[1], 3 / 8, delta=1e-6)  # right

    def test_mass_vanishes(self):
        """A tetrahedron of 1/96 kg: a sixth of 4 m · 1 m · 1/64 m, at a density of 1 kg/m³."""
        finding, (printed,) = self.fault("vanishing_mass")
        self.assertEqual((finding["outcome"], finding["defect"]), ("fails", "wrong_mass"))
        self.assertGreater(finding["relative"], 0.999)
        mass, = numbers_after("mass:", printed)
        self.assertEqual(mass, float(finding["observed"]))
        self.assertLess(mass, 1e-8)

    def test_bodies_apart_overlap(self):
        """Two tetrahedra of 5 mm are 0.2 mm apart."""
        finding, (printed,) = self.fault("false_overlap")
        self.assertEqual((finding["outcome"], finding["defect"], finding["relative"]), ("fails", "too_near", 1))
        self.assertGreater(finding["of_body"], 0.03)
        self.assertAlmostEqual(finding["margin"][0], 0.0002, delta=1e-6)
        distance, = numbers_after("distance:", printed)
        self.assertLess(distance, 0)


if __name__ == "__main__":
    missing = [package for package in PACKAGES.values() if not (MODULES / package).exists()]
    if missing or not shutil.which("node"):
        print(f"Skipped: {'not installed in ' + str(MODULES) + ': ' + ', '.join(missing) if missing else 'no Node.js'}")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
