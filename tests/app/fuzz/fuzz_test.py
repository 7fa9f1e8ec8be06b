"""fuzz finds what is wrong on purpose, writes cases that replay takes, repeats itself, and accuses no right subject."""

import json
import unittest

from program import *

LYING = f"exec:{CANARY} canary.near_means_touching"


class Fuzz(Test):
    def fuzz(self, *words, code=0):
        done = self.run_program("fuzz", *words, "--json")
        self.assertEqual((done.returncode, done.stderr), (code, ""), done.stdout)
        return json.loads(done.stdout)

    def test_a_wrong_subject_is_found_and_its_case_replays(self):
        found = self.fuzz("distance", "--subject", LYING, "--executions", 200, "--skip-adapter-check", code=1)
        verdict = next(f for f in found["findings"] if f["property"] == "distance.verdict")
        self.assertEqual((verdict["defect"], verdict["bodies"]), ("phantom", 2))
        self.assertLessEqual(verdict["first_execution"], 200)
        again = self.run_program("replay", verdict["case"], "--subject", LYING)
        self.assertEqual(again.returncode, 1, again.stderr)
        self.assertIn("phantom", again.stdout)

    def test_a_larger_error_is_looked_for_and_its_case_replays(self):
        lying = f"exec:{CANARY} canary.edges_not_clipped"
        words = ["distance", "--subject", lying, "--properties", "distance.value", "--executions", 60, "--skip-adapter-check"]
        found = self.fuzz(*words, "--enlarge", 300, code=1)["findings"][0]
        self.assertGreater(found["largest"]["finding"]["error"], found["largest_error"])
        again = self.run_program("replay", found["largest"]["case"], "--subject", lying)
        self.assertEqual(again.returncode, 1, again.stderr)
        self.assertNotIn("largest", self.fuzz(*words, code=1)["findings"][0])

    def test_each_cause_is_reported_once(self):
        found = self.fuzz("distance", "--subject", LYING, "--executions", 200, "--skip-adapter-check", code=1)
        causes = [(f["property"], f["defect"]) for f in found["findings"]]
        self.assertEqual(len(causes), len(set(causes)))
        self.assertEqual(len({f["case"] for f in found["findings"]}), len(causes))

    def test_a_right_subject_is_not_accused(self):
        for words in [[], ["--subject", "fast"], ["--subject", "inproc:reference"]]:
            found = self.fuzz("distance", "--executions", 100, *words)
            self.assertEqual((found["executions"], found["findings"]), (100, []))
            self.assertEqual(found["marks_reached"] > 0, not words)
        self.assertEqual(list((self.folder / "findings").iterdir()), [])

    def test_the_same_seed_gives_the_same_result(self):
        def result(seed, folder):
            found = self.fuzz("bounds", "--executions", 150, "--seed", seed, "--out", folder)
            return {key: value for key, value in found.items() if key != "seconds" and "_per_second" not in key}
        self.assertEqual(result(5, "a"), result(5, "b"))
        self.assertNotEqual(result(5, "a"), {**result(6, "c"), "seed": 5})

    def test_most_answers_about_distances_are_screened(self):
        found = self.fuzz("distance", "--executions", 1000)
        self.assertEqual((found["executions"], found["contradictions"]), (1000, []))
        self.assertLess(found["judged"], 1000)
        self.assertEqual(found["verdicts"], 16 * found["judged"])

    def test_from_a_single_scene_a_fault_is_found(self):
        lying = f"exec:{CANARY} canary.box_one_ulp_inward"
        found = self.fuzz("bounds", "--subject", lying, "--empty-corpus", "--executions", 200, "--skip-adapter-check", code=1)
        self.assertEqual(found["findings"][0]["property"], "bounds.holds_body")

    def test_it_ends_with_the_first_failure_if_asked_to(self):
        words = ["distance", "--subject", LYING, "--executions", 300, "--skip-adapter-check"]
        found = self.fuzz(*words, "--first-failure", code=1)
        self.assertEqual(found["executions"], found["findings"][0]["first_execution"])
        self.assertEqual(found["findings"][0]["first_execution"], self.fuzz(*words, code=1)["findings"][0]["first_execution"])

    def test_it_ends_in_time(self):
        found = self.fuzz("mass", "--time", 0.5)
        self.assertGreater(found["executions"], 0)
        self.assertLess(found["seconds"], 10)

    def test_the_words_say_what_was_done(self):
        said = self.succeeds("fuzz", "penetration", "--subject", "inproc:reference", "--executions", 60)
        self.assertRegex(said, r"^penetration of reference .*, seed 1: 60 executions; \d+ a second\n"
                               r"asked under all properties: 60 of them, 780 verdicts; \d+ a second\n"
                               r"coverage: 0 of \d+ marks of fast, \d+ signals, \d+ scenes kept\n")
        self.assertIn("findings: 0\n", said)

    def test_only_the_named_properties_are_tested(self):
        found = self.fuzz("distance", "--executions", 50, "--properties", "distance.value,distance.verdict")
        self.assertEqual(found["verdicts"], 100)

    def test_bad_input_is_refused(self):
        self.refused("fuzz", says="QUERY")
        self.refused("fuzz", "distances", says="distance")
        self.refused("fuzz", "distance", "--executions", 0, says="--executions")
        self.refused("fuzz", "distance", "--time", 0, says="--time")
        self.refused("fuzz", "distance", "--subject", "nothing", says="nothing")
        self.refused("fuzz", "distance", "--properties", "mass.mass", says="is no property of distance")
        (self.folder / "file").write_text("")
        self.refused("fuzz", "distance", "--out", "file", says="file")


if __name__ == "__main__":
    unittest.main()
