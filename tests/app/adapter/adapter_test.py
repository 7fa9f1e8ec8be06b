"""The command adapter: skeletons that work, right adapters that pass, and wrong ones that are recognised."""

import json
import os
import pathlib
import shutil
import subprocess
import unittest

import wrong_adapter
from program import *

HERE = pathlib.Path(__file__).parent
SUBJECTS = pathlib.Path(os.environ["TOUCHSTONE_SUBJECTS"])
REFERENCE = SUBJECTS / "touchstone-subject-reference"
BUILDS = {"js": ["node"], "python": ["python3"], "rust": ["cargo"], "cpp": ["g++"]}


def wrong(mistake):
    return f"exec:/usr/bin/python3 '{HERE / 'wrong_adapter.py'}' '{mistake}' '{REFERENCE}'"


class Skeletons(Test):
    def check_skeleton(self, language):
        if not shutil.which(BUILDS[language][0]):
            self.skipTest(f"{BUILDS[language][0]} is not installed")
        printed = self.succeeds("adapter", "new", "--lang", language, "a_1")
        *builds, check = [line.removeprefix("Next: ") for line in printed.splitlines() if line.startswith("Next: ")]
        for build in builds:
            done = subprocess.run(build, shell=True, cwd=self.folder, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
        subject = check.split('"')[1]
        self.assertEqual(check, f'touchstone adapter check "{subject}"')
        said = json.loads(self.succeeds("adapter", "check", subject, "--json"))
        self.assertEqual((said["subject"], said["fault"]), ("a_1", False))
        (distance,) = said["queries"]
        self.assertEqual((distance["query"], distance["wrong"], distance["breaks"]), ("distance", 0, 0))
        self.assertGreaterEqual(distance["right"], 10)  # two balls apart and two that overlap, in five frames
        self.assertEqual(distance["right"] + distance["abstains"], distance["asked"])

    def test_python(self):
        self.check_skeleton("python")

    def test_javascript(self):
        self.check_skeleton("js")

    def test_cpp(self):
        self.check_skeleton("cpp")

    def test_rust(self):
        self.check_skeleton("rust")

    def test_it_never_overwrites(self):
        self.succeeds("adapter", "new", "--lang", "python")
        self.refused("adapter", "new", "--lang", "js", "my_engine", says="my_engine: exists; nothing was written")
        self.file("taken", "a file")
        self.refused("adapter", "new", "--lang", "cpp", "taken", says="taken: exists")

    def test_bad_usage(self):
        self.refused("adapter", says="ACTION is required")
        self.refused("adapter", "chek", "fast", says="did you mean check")
        self.refused("adapter", "new", says="--lang: expected one of js, python, rust, cpp")
        self.refused("adapter", "new", "--lang", "pyton", says="did you mean python")
        self.refused("adapter", "new", "--lang", "python", "../up", says='name "../up": expected')
        self.refused("adapter", "check", says="expected a subject")
        self.refused("adapter", "check", "refrence", says="did you mean reference")
        self.refused("adapter", "check", "inproc:fast", "--queries", "distanse", says="did you mean distance")
        self.refused("adapter", "check", "fast.bsp", "--queries", "penetration", says="claims none of the queries")


class RightAdapters(Test):
    def test_our_own_pass_everything(self):
        for subject in ("inproc:reference", "inproc:fast", wrong("none")):
            said = json.loads(self.succeeds("adapter", "check", subject, "--json"))
            self.assertFalse(said["fault"], said)
            for query in said["queries"]:
                self.assertEqual((query["wrong"], query["breaks"], query["hints"]), (0, 0, []), (subject, query))
                self.assertGreater(query["right"], 0, (subject, query))

    def test_the_table(self):
        printed = self.succeeds("adapter", "check", "inproc:reference", "--queries", "mass,distance")
        self.assertRegex(printed, r"(?m)^mass +39 +39 +0 +0 +0  ok$")
        self.assertRegex(printed, r"(?m)^distance +45 +45 +0 +0 +0  ok$")
        self.assertTrue(printed.endswith("No fault of the adapter was found.\n"), printed)


class WrongAdapters(Test):
    def test_each_mistake_is_called_by_its_name(self):
        self.assertGreaterEqual(len(wrong_adapter.MISTAKES), 12)
        for mistake, (query, _, _, part) in wrong_adapter.MISTAKES.items():
            with self.subTest(mistake):
                printed = self.succeeds("adapter", "check", wrong(mistake), "--json", code=1)
                said = json.loads(printed)
                self.assertTrue(said["fault"])
                if mistake == "single precision":
                    self.assertIn(part, said["precision"])
                    continue
                (found,) = said["queries"]
                self.assertEqual(found["query"], query)
                self.assertIn(part, found["hints"][0]["hint"])
                self.assertEqual(found["hints"][0]["explains"], found["wrong"], found)
                self.assertEqual(len(found["hints"]), 1, found)

    def test_two_mistakes_at_once_have_a_hint_each(self):
        """Every second answer of this adapter has the normal reversed, and the others its depth's sign."""
        script = self.file("two.py", f"""
import sys
sys.path.insert(0, {str(HERE)!r})
import wrong_adapter as wrong
engine, count = wrong.Engine(sys.argv[1]), 0
def penetration(scene):
    global count
    count += 1
    result = engine.ask("penetration", scene)
    (wrong.normal_reversed if count % 2 else wrong.depth_sign)(result, scene)
    return result
wrong.serve({{"name": "two", "version": "1", "precision": "binary64"}}, {{"penetration": penetration}})
""")
        said = json.loads(self.succeeds("adapter", "check", f"exec:/usr/bin/python3 {script} '{REFERENCE}'", "--json", code=1))
        hints = [hint["hint"].split(":")[0] for hint in said["queries"][0]["hints"]]
        self.assertEqual(sorted(hints), ["depth sign", "normal reversed"])

    def test_no_engine_is_judged_before_its_adapter_passes(self):
        subject = altered(1.5)
        words = ["--subjects", subject, "--properties", "distance.value", "--cases", "4", "--json", "r.json"]
        for command in (["check"], ["report", "--out", "R"]):
            done = subprocess.run([PROGRAM, *command, *words], cwd=self.folder, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            self.assertRegex(done.stderr, r"distance: \d+ of \d+ plain questions answered wrongly; e.g. ")
            self.assertIn("--skip-adapter-check judges it as it is", done.stderr)
            self.assertEqual(self.files(), [])
        self.succeeds("check", *words, code=1)  # with --skip-adapter-check
        right = subprocess.run([PROGRAM, "check", "--skip-self-test", "--subjects", altered(1), *words[2:]], cwd=self.folder, capture_output=True,
                               text=True)
        self.assertEqual(right.returncode, 0, right.stderr)

    def test_an_adapter_that_throws(self):
        script = self.file("throws.py", f"""
import sys
sys.path.insert(0, {str(SOURCE / 'adapters/python')!r})
from touchstone_adapter import serve
serve({{"name": "throws", "version": "1", "precision": "binary64"}}, {{"mass": lambda scene: scene["masses"]}})
""")
        done = self.run_program("adapter", "check", f"exec:/usr/bin/python3 {script}")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("KeyError: 'masses'", done.stdout)
        self.assertIn("find out whether the adapter is at fault", done.stdout)


if __name__ == "__main__":
    unittest.main()
