"""The published test vectors: true, proved without the program, readable in two languages, and added to by the command."""

import collections
import json
import random
import shutil
import subprocess
import sys
import unittest
from fractions import Fraction

from program import *

FOLDER = SOURCE / "vectors"
QUERIES = ("mass bounds broad_phase distance penetration pixel impulse time_of_impact simulation constraint").split()


def tests_of(query, folder=FOLDER):
    return json.loads((folder / f"{query}.json").read_text())["tests"]


class Published(Test):
    def test_there_are_1000_over_all_queries(self):
        counts = {query: len(tests_of(query)) for query in QUERIES}
        self.assertGreaterEqual(min(counts.values()), 30, counts)
        self.assertGreaterEqual(sum(counts.values()), 1000, counts)

    def test_they_are_what_the_reference_answers(self):
        self.assertEqual(self.succeeds("vectors", FOLDER, "--check"), "")

    def test_they_fit_the_schema(self):
        import jsonschema

        schema = json.loads((FOLDER / "schema.json").read_text())
        scene = json.loads((SOURCE / "docs/scene.schema.json").read_text())
        schema["$defs"]["test"]["properties"]["scene"] = {"type": "object"}
        of_file, of_scene = (jsonschema.Draft202012Validator(s) for s in (schema, scene))
        for query in QUERIES:
            file = json.loads((FOLDER / f"{query}.json").read_text())
            of_file.validate(file)
            self.assertEqual(file["query"], query)
            for test in file["tests"]:
                of_scene.validate(test["scene"])
            ids = collections.Counter(test["id"] for test in file["tests"])
            self.assertEqual(max(ids.values()), 1)

    def test_both_readers_read_all(self):
        words = [f"{query:<16}{len(tests_of(query)):5} vectors" for query in QUERIES]
        commands = [[sys.executable, "-B", "read_vectors.py"]]
        if shutil.which("node"):
            commands.append(["node", "read_vectors.mjs"])
        for command in commands:
            done = subprocess.run(command, cwd=FOLDER, capture_output=True, text=True, timeout=60)
            self.assertEqual((done.stdout.splitlines(), done.stderr), (words, ""))


def prove(folder, *queries):
    done = subprocess.run([sys.executable, "-B", folder / "check_vectors.py", *queries], capture_output=True, text=True,
                          timeout=300)
    return done.returncode, done.stdout + done.stderr


def with_other_ends(interval):
    """Neither overflows nor underflows to the same."""
    return [end / 4 if abs(end) > 1 else end + 3 for end in interval]


def altered(query, answer):
    """Changes one thing of an answer that the proofs look at. Returns whether there was one."""
    if query == "mass":
        body = next((b for b in answer["bodies"] if "mass" in b), None)
        if body is None or None in body["mass"]:
            return False
        body["mass"] = with_other_ends(body["mass"])
    elif query == "bounds":
        answer["boxes"][0]["hi"]["exact"][2] += "1"
    elif query == "broad_phase":
        pairs = answer["frames"][-1]["pairs"] if "frames" in answer else answer["overlapping_boxes"]
        pairs.pop() if pairs else pairs.append([0, 1])
    elif query == "distance":
        answer["verdict"] = "touching" if answer["verdict"] != "touching" else "separated"
    elif query == "penetration":
        if answer["verdict"] != "overlapping" or None in answer["depth_enclosure"]:
            return False
        answer["depth_enclosure"] = with_other_ends(answer["depth_enclosure"])
    elif query == "pixel":
        row = answer["sampled"][0][0]
        answer["sampled"][0][0] = "10"[int(row[0])] + row[1:]
    elif query == "impulse":
        nearest = [v["nearest"] if isinstance(v, dict) else v
                   for after in ("after_A", "after_B") for v in answer[after].values()]
        more = 1 + int(max(abs(x) for v in nearest for x in v))  # an error that is not lost beside any speed
        speed = answer["after_A"]["v_WBcm"]
        speed = speed["exact"] if isinstance(speed, dict) else speed
        speed[0] = str(Fraction(speed[0]) + more) if isinstance(speed[0], str) else speed[0] + more
    elif query == "time_of_impact":
        if answer["status"] != "hit" or answer["at_start"] == "yes":
            return False
        answer["met_by"] = 2 * answer["met_by"] + 1
    elif query == "constraint":
        answer["states"][-1]["w_WB"][1] = with_other_ends(answer["states"][-1]["w_WB"][1])
    else:
        answer["states"][0][0]["X_WB"]["p"][1] += 1
    return True


class Proofs(Test):
    def setUp(self):
        super().setUp()
        shutil.copytree(FOLDER, self.folder / "vectors", ignore=shutil.ignore_patterns("__pycache__"))
        self.copy = self.folder / "vectors"

    def test_every_answer_is_proved_as_far_as_the_readme_says(self):
        code, said = prove(self.copy)
        self.assertEqual(code, 0, said)
        for line in said.splitlines():
            self.assertRegex(line, r"^[a-z_]+ +\d+ vectors: \d+ proved, \d+ in part, \d+ not, 0 wrong$")
        for query in ["mass", "bounds", "broad_phase", "distance", "penetration"]:
            self.assertRegex(said, rf"(?m)^{query} +(\d+) vectors: \1 proved")
        for query in ["pixel", "impulse", "constraint"]:
            self.assertRegex(said, rf"(?m)^{query} +(\d+) vectors: 0 proved, \1 in part")

    def test_a_wrong_answer_is_not_proved(self):
        choice = random.Random(1)
        for query in QUERIES:
            file = json.loads((self.copy / f"{query}.json").read_text())
            changed = []
            for test in choice.sample(file["tests"], 12):
                if altered(query, test["answer"]):
                    changed.append(test)
            file["tests"] = changed
            self.assertGreater(len(changed), 1, query)
            (self.copy / f"{query}.json").write_text(json.dumps(file))
            code, said = prove(self.copy, query)
            proved = int(said.split(" proved")[0].split()[-1])
            self.assertEqual((code, proved), (1, 0), said)
            if query in ("mass", "bounds", "broad_phase", "distance", "penetration", "pixel", "impulse", "constraint"):
                self.assertIn(f" {len(changed)} wrong", said)


class Command(Test):
    def setUp(self):
        super().setUp()
        (self.folder / "mine").mkdir()

    def test_draws_and_cases_are_added_once(self):
        case = SOURCE / "properties/corpus/distance/crossed_edges_2_40_apart.json"
        words = ["vectors", "mine", "--queries", "distance", "--draw", 1, "--add", case]
        first = self.succeeds(*words)
        self.assertEqual(self.succeeds(*words), first)
        tests = tests_of("distance", self.folder / "mine")
        self.assertIn("boxes.tiny_gap", {test["source"].get("family") for test in tests})
        added = next(test for test in tests if "property" in test["source"])
        self.assertEqual(added["answer"]["squared_distance_of_cores"]["exact"], f"1/{2**80}")
        self.assertEqual(self.succeeds("vectors", "mine", "--check"), "")

    def test_check_names_the_file_that_differs(self):
        self.succeeds("vectors", "mine", "--queries", "mass", "--draw", 1)
        file = self.folder / "mine/mass.json"
        file.write_text(file.read_text().replace('"fixed":true', '"fixed":false', 1).replace("[512.0", "[511.0", 1))
        done = self.run_program("vectors", "mine", "--check")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("mine/mass.json: differs", done.stderr)
        self.succeeds("vectors", "mine")
        self.succeeds("vectors", "mine", "--check")

    def test_an_extreme_scene_has_no_allowance(self):
        self.succeeds("vectors", "mine", "--queries", "distance", "--draw", 1)
        for test in tests_of("distance", self.folder / "mine"):
            self.assertEqual("allowed" in test, not test["source"]["family"].startswith("extreme."))

    def test_a_page_shows_each(self):
        self.succeeds("vectors", "mine", "--queries", "penetration", "--draw", 1, "--page", "page.html")
        page = (self.folder / "page.html").read_text()
        for test in tests_of("penetration", self.folder / "mine"):
            self.assertIn(f'id="{test["id"]}"', page)

    def test_bad_input(self):
        self.refused("vectors", "absent", says="absent: is no folder")
        self.refused("vectors", "mine", "--queries", "distances", says="distances")
        self.refused("vectors", "mine", "--add", "absent.json", says="absent.json")
        for text, place in [("{", "mine/mass.json:1:2"), ("[]", "touchstone"), ('{"touchstone":"vectors/1"}', "tests"),
                            ('{"touchstone":"vectors/1","tests":[{"source":{}}]}', "tests[0]")]:
            self.file("mine/mass.json", text)
            self.refused("vectors", "mine", says=place)


if __name__ == "__main__":
    unittest.main()
