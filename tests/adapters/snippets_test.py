"""Usage: snippets_test.py FOLDER. The programs that our adapters of Bullet, FCL and libccd write, in the engines' own API:
each is built by the command in its first line, prints what the judge expects, and says bit for bit what its adapter
answers. FOLDER has the subjects. Without any of them, or without g++, says so and exits with code 77, which CTest reports
as skipped."""

import concurrent.futures
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(sys.argv[1])
SKIPPED = 77
QUESTIONS = [("bullet.double", "distance"), ("bullet.float", "penetration"), ("fcl.libccd", "distance"),
             ("fcl.indep", "penetration"), ("fcl.libccd", "mass"), ("libccd.gjk", "penetration"), ("libccd.mpr", "distance")]
EXPECTED = "100 % \"exact\" \\ not"  # printed as it is
TURN = {"w": 0.3, "x": -0.7, "y": 1.1, "z": 0.2}
HULL = {"type": "polytope", "vertices": [[0, 0, 0], [1, 0, 0], [0.1, 1.3, 0], [0, 0.2, 0.7]],
        "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]}


def scene(place):
    bodies = [{"shape": HULL, "X_WB": {"p": [0.1, 0, -0.3], "q": TURN}, "mass": {"type": "density", "density": 1}},
              {"shape": {"type": "box", "half_extents": [0.5, 0.25, 1 / 3]}, "X_WB": {"p": place, "q": {**TURN, "z": -2}}}]
    return {"touchstone": "scene/1", "bodies": bodies}


SCENES = {"distance": scene([0, 2.1, 1e-5]), "penetration": scene([0.15, 0.02, -0.28]), "mass": scene([0, 2.1, 0])}


def program(subject):
    return FOLDER / f"touchstone-subject-{subject}"


def numbers(label, text):
    found = re.search(label + r": *(.*)", text)
    return [float(word) for word in found[1].split()] if found else None


def said_and_printed(question):
    """The adapter's answer, and what its snippet prints."""
    subject, query = question
    asked = {"query": query, "scene": SCENES[query]}
    lines = [{"op": "start", "seq": 1, "protocol": 1}, {**asked, "op": "ask", "seq": 2},
             {**asked, "op": "reproduce", "seq": 3, "expected": EXPECTED}]
    done = subprocess.run([program(subject)], input="".join(json.dumps(line) + "\n" for line in lines), capture_output=True,
                          text=True, timeout=60, check=True)
    _, answer, snippet = map(json.loads, done.stdout.splitlines())
    with tempfile.TemporaryDirectory(prefix="touchstone_") as folder:
        command = snippet["snippet"].splitlines()[0].removeprefix("// ")
        source, = re.findall(r"\w+\.cpp", command)
        (pathlib.Path(folder) / source).write_text(snippet["snippet"])
        ran = subprocess.run(["bash", "-c", command], cwd=folder, capture_output=True, text=True, timeout=120)
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.startswith(f"expected: {EXPECTED}\n"), ran.stdout
    return answer["result"], ran.stdout


class Snippets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        asked = [question for question in QUESTIONS if program(question[0]).exists()]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            cls.said = dict(zip(asked, pool.map(said_and_printed, asked), strict=True))

    def test_distances(self):
        for (subject, query), (answer, printed) in self.said.items():
            if query == "distance" and "distance" in answer:
                self.assertGreater(answer["distance"], 0)
                self.assertEqual(numbers("distance", printed), [answer["distance"]], subject)
            elif query == "distance":
                self.assertEqual(numbers("intersect", printed), [answer["verdict"] == "overlapping"], subject)

    def test_depths(self):
        for (subject, query), (answer, printed) in self.said.items():
            if query != "penetration":
                continue
            self.assertEqual(answer["verdict"], "overlapping", subject)
            depth = numbers("depth", printed) or [-d for d in numbers("distance", printed)]
            self.assertEqual(depth, [answer["depth"]], subject)

    def test_masses(self):
        for (subject, query), (answer, printed) in self.said.items():
            if query == "mass":
                self.assertEqual(numbers("volume", printed), [answer[0]["mass"]], subject)
                self.assertEqual(numbers("centre", printed), answer[0]["p_BBcm"], subject)


if __name__ == "__main__":
    missing = not shutil.which("g++") or not any(program(subject).exists() for subject, _ in QUESTIONS)
    if missing:
        print("Skipped: no g++, or none of the subjects is built")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
