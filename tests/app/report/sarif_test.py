"""SARIF 2.1.0: what code scanning needs of it, and the scene in it and in the JUnit XML."""

import json
import subprocess
import unittest
import urllib.parse
import xml.etree.ElementTree as xml

from program import *

SUBJECT = altered(1.5)


class Sarif(Test):
    def checked(self, out, *words):
        self.succeeds("check", "--subjects", SUBJECT, "--properties", "distance.value,distance.symmetric", "--cases", 4, "--sarif",
                      "s.json", *words, *(["--out", out] if out else []), code=1)
        [run] = self.json("s.json")["runs"]
        return run

    def test_rules_and_results(self):
        run = self.checked("a report")
        self.assertEqual(self.json("s.json")["version"], "2.1.0")
        driver = run["tool"]["driver"]
        self.assertEqual(driver["name"], "touchstone")
        self.assertEqual({rule["id"] for rule in driver["rules"]}, {"distance.value", "distance.symmetric"})
        self.assertTrue(all(rule["shortDescription"]["text"] and rule["fullDescription"]["text"] for rule in driver["rules"]))
        [result] = run["results"]  # the distance is symmetric
        self.assertEqual(result["ruleId"], "distance.value")
        self.assertEqual(driver["rules"][result["ruleIndex"]]["id"], "distance.value")
        self.assertEqual(result["level"], "error")
        self.assertIn("fails: too_far", result["message"]["text"])
        self.assertEqual(result["partialFingerprints"], {"touchstone/1": "mine/distance.value/too_far"})
        self.assertNotIn("suppressions", result)

    def test_the_place_is_the_case(self):
        [result] = self.checked("a report")["results"]
        uri = result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        self.assertEqual(uri, "a%20report/cases/distance.value.mine.json")
        self.assertEqual(result["properties"]["scene"], self.json(urllib.parse.unquote(uri))["scene"])

    def test_a_place_outside_the_folder_is_absolute(self):
        (self.folder / "inner").mkdir()
        out = self.folder / "outer"
        words = ["check", "--subjects", SUBJECT, "--properties", "distance.value", "--cases", "4", "--sarif", "s.json",
                 "--out", "../outer"]
        done = subprocess.run([PROGRAM, *as_asked(words)], cwd=self.folder / "inner", capture_output=True, text=True)
        self.assertEqual(done.returncode, 1, done.stderr)
        [result] = self.json("inner/s.json")["runs"][0]["results"]
        self.assertEqual(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"],
                         f"file://{out}/cases/distance.value.mine.json")

    def test_without_a_report_the_scene_is_all(self):
        run = self.checked(None, "--junit", "j.xml")
        [result] = run["results"]
        self.assertNotIn("physicalLocation", result["locations"][0])
        words = xml.parse(self.folder / "j.xml").getroot()[0][0][0].text
        [line] = [line for line in words.splitlines() if line.startswith("scene: ")]
        self.assertEqual(json.loads(line.removeprefix("scene: ")), result["properties"]["scene"])
        self.file("scene.json", result["properties"]["scene"])
        self.succeeds("ask", "distance", "scene.json")


if __name__ == "__main__":
    unittest.main()
