"""judge: one's own scene, by all properties that apply; and replay --trace, and replay from another folder."""

import json
import subprocess
import unittest

from program import *

BALLS = scene(body(ball(1)), body(ball(2), (3, 4, 0)))
RIGHT = "inproc:reference"


def a_case(a_scene, subject=""):
    return {"touchstone": "case/1", "property": "distance.value", "subject": subject, "seed": 1, "index": 0, "scene": a_scene,
            "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}}


class Judge(Test):
    def setUp(self):
        super().setUp()
        self.file("balls.json", BALLS)

    def test_truth_answer_and_verdict(self):
        said = self.succeeds("judge", "balls.json", "--subjects", RIGHT, "--subjects", altered(1.5), "--queries", "distance", code=1)
        self.assertRegex(said, r"(?m)^distance\n  truth\n    verdict +separated\n    distance +2$")
        self.assertRegex(said, r'(?m)^  mine .*\n    result +\{"distance":3\.0\}$')
        self.assertRegex(said, r"(?m)^    fails +distance\.value: .*\n      outcome +fails: too_far\n      observed +3\n      expected +2")
        self.assertRegex(said, r"(?m)^    holds +distance\.symmetric")
        self.assertRegex(said, r"(?m)^    holds +distance\.value: error 0 ulps of the scene's scale; allowed")

    def test_the_exit_code_is_of_the_properties(self):
        self.succeeds("judge", "balls.json", "--subjects", RIGHT, "--queries", "distance")
        self.succeeds("judge", "balls.json", "--subjects", altered(1), "--queries", "distance")
        self.succeeds("judge", "balls.json", "--subjects", altered("silent"), "--queries", "distance")

    def test_what_the_scene_has_the_parts_for_is_asked(self):
        queries = [one["query"] for one in json.loads(self.succeeds("judge", "balls.json", "--subjects", RIGHT, "--json"))["queries"]]
        self.assertEqual(queries, ["mass", "bounds", "broad_phase", "distance", "penetration"])
        painleve = SOURCE / "docs/scenes/impact/painleve.json"
        queries = [one["query"] for one in json.loads(self.succeeds("judge", painleve, "--subjects", RIGHT, "--json"))["queries"]]
        self.assertIn("impulse", queries)

    def test_laws_judge_where_no_exact_answer_is_known(self):
        block = body({"type": "box", "half_extents": [1, 1, 1]}, (0, 0, 1))
        table = body({"type": "box", "half_extents": [4, 4, 1]}, (0, 0, -1)) | {"mass": {"type": "fixed"}}
        self.file("block.json", scene(block, table) | {"gravity": [0, 0, -8], "motion": {"sample_times": [0.5, 1]}})
        said = self.succeeds("judge", "block.json", "--subjects", "inproc:fast", "--queries", "constraint")
        self.assertRegex(said, r"(?m)^constraint\n  truth +not known: bodies\[0\]\.shape: a moving body that is no ball$")
        self.assertRegex(said, r"(?m)^    holds +constraint\.rests: error")
        [query] = json.loads(self.succeeds("judge", "block.json", "--subjects", "inproc:fast", "--queries", "constraint", "--json"))["queries"]
        self.assertIn("no ball", query["no_truth"])

    def test_json_has_the_findings(self):
        said = json.loads(self.succeeds("judge", "balls.json", "--subjects", altered(1.5), "--queries", "distance", "--json", code=1))
        [query] = said["queries"]
        self.assertEqual((query["query"], query["truth"]["distance"]), ("distance", 2.0))
        [subject] = query["subjects"]
        self.assertEqual((subject["subject"], subject["answer"]), ("mine", {"result": {"distance": 3.0}}))
        findings = {one["property"]: one["finding"] for one in subject["properties"]}
        self.assertEqual(findings["distance.value"]["defect"], "too_far")
        self.assertEqual(findings["distance.symmetric"]["outcome"], "holds")

    def test_bad_input(self):
        self.refused("judge", "gone.json", says="gone.json")
        self.refused("judge", "balls.json", "--queries", "distanc", says="did you mean distance")
        self.refused("judge", "balls.json", "--queries", "impulse", says='balls.json: has no "contact", which the query impulse needs')
        self.file("one.json", scene(body(ball(1))))
        self.refused("judge", "one.json", "--queries", "distance", says="one.json: the query distance needs two bodies")


class Trace(Test):
    def setUp(self):
        super().setUp()
        self.file("case.json", a_case(BALLS))

    def test_the_lines_are_those_of_the_protocol(self):
        said = self.succeeds("replay", "case.json", "--subject", altered(1.5), "--trace", code=1).splitlines()
        lines = [(line[0], json.loads(line[2:])) for line in said if line[:2] in ("> ", "< ")]
        self.assertEqual([way for way, _ in lines], [">", "<", ">", "<", ">"])
        self.assertEqual(said[0], '> {"op":"start","seq":1,"protocol":1}')
        self.assertEqual(lines[1][1]["card"]["name"], "mine")
        self.assertEqual(lines[2][1] | {"scene": 0}, {"op": "ask", "seq": 2, "query": "distance", "scene": 0})
        self.assertEqual(lines[3][1], {"seq": 2, "result": {"distance": 3.0}})
        self.assertEqual(lines[4][1], {"op": "stop", "seq": 3})
        self.assertTrue(said[5].startswith("property "))

    def test_no_lines_within_the_process(self):
        self.refused("replay", "case.json", "--subject", RIGHT, "--trace", says="--trace: inproc:reference answers within this process")
        self.refused("replay", "case.json", "--subject", RIGHT, "--trace", "--json", says="--trace")


class RelativeCommand(Test):
    """The words of a command are relative to the folder in which it ran."""

    def test_the_command_that_a_case_names_runs_from_anywhere(self):
        (self.folder / "my engine").mkdir()
        (self.folder / "my engine/mine.py").write_text((SOURCE / "tests/app/altered.py").read_text())
        subject = "exec:/usr/bin/python3 mine.py 1.5"
        there = self.folder / "my engine"
        words = ["check", "--subjects", subject, "--properties", "distance.value", "--cases", "4", "--out", "R"]
        subprocess.run([PROGRAM, *as_asked(words)], cwd=there, capture_output=True)
        case = "my engine/R/cases/distance.value.mine.json"
        self.assertEqual(self.json(case)["folder"], str(there))
        for verb, code in [("replay", 1), ("minimise", 0)]:
            told = self.refused(verb, case, says=["not run: ", f"(cd '{there}' && "])
            done = subprocess.run(["sh", "-c", told.split("to run it: ")[1]], cwd="/", capture_output=True, text=True)
            self.assertEqual(done.returncode, code, done.stderr)


if __name__ == "__main__":
    unittest.main()
