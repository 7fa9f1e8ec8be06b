"""Usage: library_test.py ROOT LANGUAGE COMPILER. Holds conversations with an adapter that is built on a language's library
of adapters/: the skeleton, and one whose queries go wrong. If the language is not installed, says so and exits with code
77, which CTest reports as skipped."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT, LANGUAGE, COMPILER = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
SKIPPED = 77
FILES = {"js": "mjs", "python": "py", "rust": "rs", "cpp": "cpp"}
NEEDS = {"js": "node", "python": "python3", "rust": "rustc", "cpp": COMPILER}
NO_TURN = {"w": 1, "x": 0, "y": 0, "z": 0}
QUARTER_ABOUT_X = {"w": 3, "x": 3, "y": 0, "z": 0}
START = {"op": "start", "protocol": 1}


def ball(radius, p):
    return {"shape": {"type": "sphere", "radius": radius}, "X_WB": {"p": p, "q": NO_TURN}}


def ask(query, *bodies):
    return {"op": "ask", "query": query, "scene": {"touchstone": "scene/1", "bodies": bodies}}


def command_of(folder, name):
    """Builds what needs to be built; returns the words that run it."""
    source = folder / f"{name}.{FILES[LANGUAGE]}"
    if LANGUAGE in ("js", "python"):
        return [NEEDS[LANGUAGE], source]
    program = folder / name
    build = {"rust": ["rustc", "--edition", "2021", "-D", "warnings", source, "-o", program],
             "cpp": [COMPILER, "-std=c++17", "-Wall", "-Wextra", "-Werror", "-I", folder, source, "-o", program]}[LANGUAGE]
    done = subprocess.run(build, capture_output=True, text=True, cwd=folder)
    assert done.returncode == 0, done.stderr
    return [program]


class Library(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="touchstone_")
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        for file in (ROOT / "adapters" / LANGUAGE).iterdir():
            shutil.copy(file, cls.folder)
        shutil.copy(ROOT / f"tests/adapters/faulty/faulty.{FILES[LANGUAGE]}", cls.folder)
        cls.skeleton = command_of(cls.folder, "skeleton")
        cls.faulty = command_of(cls.folder, "faulty")

    def said(self, command, *messages):
        """The answers to messages, which get their numbers here unless they are texts; and stderr."""
        lines = [m if isinstance(m, str) else json.dumps({**m, "seq": i + 1}) for i, m in enumerate(messages)]
        done = subprocess.run([str(word) for word in command], input="\n".join(lines) + "\n", capture_output=True, text=True,
                              cwd=self.folder, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()], done.stderr

    def test_the_skeleton_answers_the_distance_of_two_balls_and_abstains_from_all_else(self):
        box = {"shape": {"type": "box", "half_extents": [1, 1, 1]}, "X_WB": {"p": [9, 0, 0], "q": NO_TURN}}
        (card, apart, deep, hull, mass), _ = self.said(
            self.skeleton, START, ask("distance", ball(1, [13, 24, 5]), ball(2, [10, 20, 5])),
            ask("distance", ball(1, [0, 0, 1]), ball(2, [0, 0, 0])), ask("distance", ball(1, [0, 0, 0]), box), ask("mass", box),
            {"op": "stop"}, START)
        self.assertEqual((card["seq"], card["protocol"]), (1, 1))
        self.assertEqual((card["card"]["name"], card["card"]["answers"]), ("NAME", ["distance"]))
        result = apart["result"]
        self.assertEqual((result["verdict"], result["distance"]), ("separated", 2))  # 5 apart, radii 1 and 2
        for point, known in [("p_WCa", [12.4, 23.2, 5]), ("p_WCb", [11.2, 21.6, 5])]:
            for found, expected in zip(result[point], known):
                self.assertAlmostEqual(found, expected, delta=1e-13)
        self.assertEqual(deep["result"], {"verdict": "overlapping", "distance": 0})
        self.assertEqual(hull, {"seq": 4, "abstains": "balls only"})
        self.assertEqual(mass, {"seq": 5, "abstains": "no mass query"})

    def test_snippets_are_written_for_what_the_card_says(self):
        bodies = [ball(1, [0, 0, 0]), ball(1, [3, 0, 0])]
        (card, snippet, none), _ = self.said(self.faulty, START, {**ask("mass", *bodies), "op": "reproduce"},
                                             {**ask("distance", *bodies), "op": "reproduce"})
        self.assertEqual(card["card"]["reproduces"], ["mass"])
        self.assertEqual(snippet, {"seq": 2, "snippet": 'ask about "2"'})
        self.assertEqual(none, {"seq": 3, "abstains": "no snippets of distance"})

    def test_what_goes_wrong_is_said_and_the_next_question_is_answered(self):
        (card, no, nan, threw, text, mute, refused), _ = self.said(
            self.faulty, START, ask("distance", ball(1, [0, 0, 0])), ask("mass", ball(1, [0, 0, 0])),
            ask("penetration", ball(1, [0, 0, 0])), "not json", {"op": "ask"},
            ask("pixel", ball(1, [0, 0, 0])))
        self.assertEqual(sorted(card["card"]["answers"]), ["bounds", "distance", "mass", "penetration", "pixel"])
        self.assertEqual(no, {"seq": 2, "abstains": "not today"})
        self.assertEqual(nan, {"seq": 3, "breaks": {"kind": "garbage", "how": "result[0].p_BBcm[1] is NaN"}})
        self.assertEqual((threw["seq"], threw["breaks"]["kind"]), (4, "threw"))
        self.assertIn("the engine failed", threw["breaks"]["how"])
        self.assertEqual((text["seq"], text["breaks"]["kind"]), (0, "threw"))
        self.assertEqual((mute["seq"], mute["breaks"]["kind"]), (6, "threw"))
        self.assertEqual(refused, {"seq": 7, "breaks": {"kind": "refused", "how": "no compounds"}})

    def test_what_an_engine_prints_spoils_no_answer(self):
        body = {**ball(1, [10, 20, 30]), "X_WB": {"p": [10, 20, 30], "q": QUARTER_ABOUT_X}}
        (_, answer), stderr = self.said(self.faulty, START, ask("bounds", body))
        self.assertIn("an engine that prints", stderr)
        box = answer["result"][0]
        if LANGUAGE != "rust":  # y goes to z, and z to -y; the library for Rust has no vectors
            for point, known in [("lo", [11, 17, 32]), ("hi", [1, 2, 3])]:
                for found, expected in zip(box[point], known):
                    self.assertAlmostEqual(found, expected, delta=1e-13)

    def test_numbers_survive_bit_for_bit(self):
        for distance in (2.0**-1074, 0.1, 2.0**69, 1.7976931348623157e308):
            (_, answer), _ = self.said(self.skeleton, START, ask("distance", ball(2.0**-1074, [0, 0, 0]), ball(1, [distance, 0, 0])))
            expected = abs(distance) - 2.0**-1074 - 1
            self.assertEqual(float(answer["result"]["distance"]), max(expected, 0), distance)

    def test_snippets_are_handed_over(self):
        if LANGUAGE != "js":
            self.skipTest("only the library for JavaScript hands over snippets")
        (self.folder / "snippets.mjs").write_text("""
            import { serve } from "./touchstone_adapter.mjs";
            const snippets = { distance: (scene) => `ask(${scene.bodies.length})` };
            serve({ name: "n", version: "0", precision: "binary64" }, { distance: () => ({}), mass: () => [] }, snippets);""")
        reproduce = [{**ask(query, ball(1, [0, 0, 0])), "op": "reproduce"} for query in ("distance", "mass")]
        reproduce.append({**reproduce[0], "expected": 'a "1"'})
        (card, snippet, none, telling), _ = self.said(["node", self.folder / "snippets.mjs"], START, *reproduce)
        self.assertEqual(card["card"]["reproduces"], ["distance"])
        self.assertEqual(snippet, {"seq": 2, "snippet": "ask(1)"})
        self.assertEqual(telling, {"seq": 4, "snippet": 'console.log("expected:", "a \\"1\\"");\nask(1)'})
        self.assertEqual(none, {"seq": 3, "abstains": "no snippets of mass"})

    def test_it_is_small(self):
        for file in (ROOT / "adapters" / LANGUAGE).glob("touchstone_adapter.*"):
            self.assertLess(len(file.read_text().splitlines()), 120, file)


if __name__ == "__main__":
    if not shutil.which(NEEDS[LANGUAGE]):
        print(f"Skipped: {NEEDS[LANGUAGE]} is not installed")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
