"""replay repeats a failing case, and minimise makes it smaller."""

import json
import unittest

from program import *

# A hull of eight irregular corners, far from a box: much more complex than a wrong distance needs.
ODD = [[a * 1.125 + 0.0625, b * 0.875 - 0.03125, c * 1.375] for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
SCENE = scene(body(hull(ODD), (0.1875, -0.3125, 0.40625), {"w": 3, "x": 1, "y": -2, "z": 1}), body(box(1.5, 0.75, 1.25), (7, 5, 3)))
LIAR = f"exec:{CANARY} canary.nan"


def a_case(subject):
    return {"touchstone": "case/1", "property": "distance.survives", "subject": subject, "seed": 1, "index": 0,
            "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}, "scene": SCENE}


def extent_of(a_scene):
    """Counts the digits other than 0 in all coordinates, half extents and quaternions."""
    bare = [[b["X_WB"], b["shape"].get("vertices"), b["shape"].get("half_extents")] for b in a_scene["bodies"]]
    return sum(c.isdigit() and c != "0" for c in json.dumps(bare))


class Case(Test):
    def setUp(self):
        super().setUp()
        self.file("case.json", a_case(LIAR))

    def test_a_case_runs_no_command(self):
        self.file("trap.json", a_case("exec:/usr/bin/touch ran"))
        for verb in ("replay", "minimise"):
            told = self.refused(verb, "trap.json", says=["trap.json: ", "not run: \"exec:/usr/bin/touch ran\"",
                                                         f"{verb} trap.json --subject 'exec:/usr/bin/touch ran'"])
            self.assertEqual(len(told.splitlines()), 1)
        # The printed command runs it.
        subprocess.run(["sh", "-c", told.split("to run it: ")[1]], cwd=self.folder, capture_output=True)
        self.assertTrue((self.folder / "ran").exists())

    def test_what_was_not_run_is_escaped(self):
        self.file("trap.json", a_case("exec:a 'b' \u001b[2J\u202e\n c"))
        told = self.refused("replay", "trap.json", says=["\\u001b[2J\\u202e\\n c", "name it with --subject"])
        self.assertNotRegex(told[:-1], "[^ -~]")

    def test_a_name_is_that_of_an_engine_beside_the_program(self):
        program = self.folder / "touchstone-subject-mine"
        program.write_text("#!/bin/sh\ntouch ran\n")
        program.chmod(0o755)
        for name in ("mine", "./mine", str(program), "../../" + str(program), " exec:/usr/bin/touch ran", "EXEC:/usr/bin/touch ran"):
            self.file("trap.json", a_case(name))
            self.refused("replay", "trap.json", says="unknown")

    def test_replay_prints_clause_truth_and_answer(self):
        said = self.succeeds("replay", "case.json", "--subject", LIAR, code=1)
        self.assertIn("TS-DISTANCE-11", said)
        self.assertRegex(said, r"(?m)^truth +separated; distance ")
        self.assertRegex(said, r"(?m)^proof +\S")
        self.assertIn("nan", said.lower())

    def test_the_faces_of_a_hull_may_be_left_out(self):
        self.file("mass.json", a_case("reference") | {"property": "mass.mass", "scene": scene(body(hull(ODD)))})
        self.succeeds("replay", "mass.json", "--subject", "inproc:reference")

    def test_replay_asks_whom_we_name(self):
        self.assertRegex(self.succeeds("replay", "case.json", "--subject", "inproc:reference"), r"(?m)^subject +reference")
        self.assertEqual(json.loads(self.succeeds("replay", "case.json", "--subject", "reference", "--json"))["outcome"],
                         "holds")

    def test_minimise_writes_a_smaller_case_that_fails(self):
        self.succeeds("minimise", "case.json", "--subject", LIAR, "--out", "small.json")
        self.succeeds("minimise", "case.json", "--subject", LIAR)
        self.assertEqual((self.folder / "small.json").read_bytes(), (self.folder / "case.smaller.json").read_bytes())
        small = self.json("small.json")
        self.assertLess(extent_of(small["scene"]), extent_of(SCENE) / 2)
        self.assertEqual(small["subject"], LIAR)
        self.succeeds("replay", "small.json", "--subject", LIAR, code=1)

    def test_minimise_has_nothing_to_do(self):
        self.assertIn("nothing to reduce", self.succeeds("minimise", "case.json", "--subject", "inproc:reference", code=1))
        self.assertEqual([p.name for p in self.folder.iterdir()], ["case.json"])


if __name__ == "__main__":
    unittest.main()
