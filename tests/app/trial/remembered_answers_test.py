"""A subject is asked once about a scene, whatever the number of properties, but for the one that compares two answers."""

import collections
import unittest

from program import *

ENGINE_THAT_KEEPS_A_LIST = """
import json, os, sys
for line in sys.stdin:
    message = json.loads(line)
    if message["op"] == "stop":
        break
    said = {"result": {"verdict": "separated", "distance": 1.0}}
    if message["op"] == "start":
        card = {"name": "keeps_a_list", "version": "0", "precision": "binary64", "answers": ["distance"]}
        said = {"protocol": 1, "card": card}
    else:
        asked = open("asked.txt", "a")
        asked.write(json.dumps([os.getpid(), message["scene"]], sort_keys=True) + "\\n")
        asked.close()
        if "wavers" in sys.argv:
            said["result"]["distance"] += sum(1 for _ in open("asked.txt")) / 1024
    print(json.dumps({"seq": message["seq"], **said}), flush=True)
"""


class RememberedAnswers(Test):
    def check(self, *words, code):
        self.file("engine.py", ENGINE_THAT_KEEPS_A_LIST)
        subject = "exec:/usr/bin/python3 engine.py" + words[0]
        return self.succeeds("check", "--subjects", subject, "--jobs", 1, "--first-failure", *words[1:], code=code)

    def test_a_scene_is_asked_once_and_again_only_to_compare(self):
        self.check("", "--queries", "distance", "--cases", 20, code=1)
        asked = [json.loads(line) for line in (self.folder / "asked.txt").read_text().splitlines()]
        in_the_trial = [scene for process, scene in asked if process == asked[0][0]]  # the minimiser starts another
        times = collections.Counter(json.dumps(scene) for scene in in_the_trial)
        self.assertEqual(times[json.dumps(in_the_trial[0])], 4, "once for 14 properties, and thrice for distance.repeats")
        self.assertEqual(max(times.values()), 4)
        self.assertGreaterEqual(len(times), 5, "the laws ask about images of it")

    def test_an_engine_that_does_not_repeat_itself_is_seen(self):
        self.assertIn("distance.repeats: 1 of 1 fail", self.check(" wavers", "--properties", "distance.repeats", code=1))


if __name__ == "__main__":
    unittest.main()
