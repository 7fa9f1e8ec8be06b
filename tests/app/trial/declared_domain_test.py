"""A card declares a domain and a tolerance of distances: inside it is judged by them, outside it is asked too, and counted
apart. An adapter's snippets are in the cases and on the page."""

import json
import os
import pathlib
import shlex
import unittest

from program import *

FAST = pathlib.Path(os.environ["TOUCHSTONE_SUBJECTS"]) / "touchstone-subject-fast"
LARGER_DISTANCES = SOURCE / "tests/app/larger_distances.py"


def most_vertices(scene):
    return max(len(body["shape"].get("vertices", [])) for body in scene["bodies"])


class DeclaredDomain(Test):
    def engine(self, declared, factor=1):
        words = ["/usr/bin/python3", str(LARGER_DISTANCES), str(FAST), json.dumps(declared), str(factor)]
        return "exec:" + shlex.join(words)

    def checked(self, declared, factor=1, code=0):
        said = self.succeeds("check", "--subjects", self.engine(declared, factor), "--properties", "distance.value", "--cases", 60,
                             "--json", "r.json", code=code)
        return said, self.json("r.json")["rows"][0]

    def test_outside_is_asked_too_and_counted_apart(self):
        said, row = self.checked({"domain": {"vertices": 6}})
        self.assertEqual(row["fails"], 0)
        self.assertGreater(row["holds"], 0)
        self.assertRegex(said, r"outside its declared domain, counted apart: \d+ answers hold, [1-9]\d* fail")
        apart = self.json("r.json")["beyond"]
        self.assertEqual([row["property"] for row in apart], ["distance.value"])
        self.assertEqual(row["beyond"], apart[0]["holds"] + apart[0]["fails"] + apart[0]["abstains"] + apart[0]["outside"])
        self.assertIn("a number of vertices", apart[0]["worst"]["beyond"])

    def test_without_a_declaration_nothing_is_apart(self):
        said, row = self.checked({}, code=1)
        self.assertGreater(row["fails"], 0)
        self.assertNotIn("beyond", row)
        self.assertNotIn("apart", said)

    def test_impacts_that_depend_on_declared_dynamics_are_counted_apart(self):
        declared = {"dynamics": {"friction": "pyramid"}, "stepping": {"step": 0.25, "order": 1}}
        self.succeeds("report", "--subjects", self.engine({"answers": ["impulse"], **declared}), "--properties", "impulse.cone",
                      "--cases", 60, "--out", "R")
        report = self.json("R/report.json")
        self.assertGreater(report["beyond"][0]["holds"], report["rows"][0]["holds"])  # most contacts have friction
        page = (self.folder / "R/index.html").read_text()
        self.assertIn("Declared dynamics", page)
        self.assertIn("Steps of 0.25 s, order 1", page)

    def test_a_declared_tolerance_is_granted(self):
        declared = {"domain": {"vertices": 6}}
        self.assertGreater(self.checked(declared, 1.0005, code=1)[1]["fails"], 0)
        self.assertEqual(self.checked({**declared, "distance_tolerance": {"relative": 0.001}}, 1.0005)[1]["fails"], 0)

    def test_a_case_outside_stays_outside_and_has_its_snippet(self):
        write_meshes(self.folder / "meshes")
        self.succeeds("report", "--subjects", self.engine({"domain": {"vertices": 6}}, 1.5), "--properties",
                      "distance.value,distance.scaled", "--cases", 60, "--meshes", "meshes", "--out", "R")
        inside = self.json("R/cases/distance.value.mine.json")
        outside = self.json("R/cases/distance.value.mine.beyond.json")
        self.assertLessEqual(most_vertices(inside["scene"]), 6)
        self.assertGreater(most_vertices(outside["scene"]), 6)
        self.assertEqual(inside["snippet"], "ask <me> about 2 bodies")
        page = (self.folder / "R/index.html").read_text()
        self.assertIn("<pre>ask &lt;me&gt; about 2 bodies</pre>", page)
        self.assertIn("outside its declared domain", page)
        self.succeeds("replay", "R/cases/distance.value.mine.json", "--subject", self.engine({}, 1.5), code=1)

    def test_a_limit_is_a_number_of_at_least_zero(self):
        for domain, place in [({"reach": -1}, "domain.reach"), ({"lengths": [1]}, "domain.lengths"), ({"size": 1}, "domain"),
                              ({"vertices": 1.5}, "domain.vertices")]:
            self.refused("check", "--subjects", self.engine({"domain": domain}), says="introduction.card." + place)


if __name__ == "__main__":
    unittest.main()
