"""The plan of a scene, by file and by name, in words and as JSON."""

import unittest

from program import *


class Plan(Test):
    def test_a_file_and_a_name(self):
        for name in ("gas", "dominoes"):
            by_file = self.succeeds("plan", SOURCE / f"docs/scenes/motion/crowds/{name}.json")
            self.assertEqual(self.succeeds("plan", name), by_file)
        said = json.loads(self.succeeds("plan", "gas", "--json"))
        self.assertEqual((said["scene"], said["used"][0]["what"]), ("gas", "times of impact in closed form"))

    def test_time_steps_are_left_out_without_lasting_contact(self):
        left_out = "each body follows one ballistic trajectory from event to event"
        self.assertIn(f"time steps: {left_out}\n", self.succeeds("plan", "gas"))
        used, left = self.succeeds("plan", "dominoes").split("left out")
        self.assertIn("contact mode: 21 pairs may", used)
        self.assertIn(f"time steps: {left_out}, except in contact", left)

    def test_bad_input(self):
        self.refused("plan", "no_such_scene", says=["no_such_scene", "list motions"])
        error = self.refused("plan", self.file("spoilt.json", scene(body(ball(-1)))), says=["spoilt.json", "bodies[0]"])
        self.assertEqual(error.count("spoilt.json"), 1, error)


if __name__ == "__main__":
    unittest.main()
