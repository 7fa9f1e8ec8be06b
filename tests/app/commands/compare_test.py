"""compare: what changed between two reports of one subject, or of two."""

import json
import unittest

from program import *

RIGHT, A_BIT, MUCH = "1", "1.000000001", "1.5"


class Compare(Test):
    def report(self, folder, *words):
        self.succeeds("report", "--properties", "distance.value,distance.symmetric", "--cases", 4, "--jobs", 1, "--meshes",
                      "meshes", "--out", folder, *words)

    def setUp(self):
        super().setUp()
        write_meshes(self.folder / "meshes")
        for folder, factor in (("right", RIGHT), ("near", A_BIT), ("far", MUCH)):
            self.report(folder, "--subjects", altered(factor))

    def compare(self, old, new, *words, code):
        return self.succeeds("compare", f"{old}/report.json", f"{new}/report.json", *words, code=code)

    def test_nothing_changes(self):
        said = self.compare("far", "far", code=0)
        self.assertRegex(said, r"^mine \S+ -> mine \S+: 1 rows hold in both, 1 fail alike, 0 are answered by neither, 0 changed\n$")

    def test_new_and_fixed(self):
        said = self.compare("right", "near", code=1)
        self.assertRegex(said, r"  new +distance\.value\n    before   holds on \d+\n    now      (\d+) of \d+ fail, grade C, \1 too_far, ")
        self.assertIn("replay   touchstone replay near/cases/distance.value.mine.json\n", said)
        said = self.compare("near", "right", code=0)
        self.assertRegex(said, r"  fixed +distance\.value\n    before   \d+ of \d+ fail, .*\n    now      holds on \d+\n")

    def test_worse_and_better(self):
        self.assertRegex(self.compare("near", "far", code=1), r"  worse +distance\.value\n    before   .*grade C.*\n    now      .*grade [DF]")
        self.assertRegex(self.compare("far", "near", code=0), r"  better +distance\.value\n")

    def test_no_answer_any_more(self):
        self.report("silent", "--subjects", altered("silent"))
        said = self.compare("right", "silent", code=1)
        self.assertRegex(said, r"  unanswered distance\.value\n    before   holds on \d+\n    now      not answered\n")
        self.assertRegex(self.compare("silent", "right", code=0), r"  answered +distance\.value\n")

    def test_of_equal_grades_the_number_of_failures_counts_if_the_scenes_are_the_same(self):
        def change(report):
            [row] = [row for row in report["rows"] if row["property"] == "distance.value"]
            row["fails"] -= 1
            row["holds"] += 1
            return report
        self.file("fewer.json", change(self.json("far/report.json")))
        self.assertRegex(self.succeeds("compare", "far/report.json", "fewer.json"), r"  better +distance\.value\n")
        self.file("other.json", change(self.json("far/report.json")) | {"seed": 2})
        said = self.succeeds("compare", "far/report.json", "other.json")
        self.assertRegex(said, r"^The reports asked different scenes \(effort quick, seed 1, 4 a query; effort quick, seed 2, 4 a query\)")
        self.assertIn("1 fail alike", said)

    def test_two_subjects_of_one_report(self):
        self.report("both", "--subjects", altered(A_BIT), "--subjects", "inproc:fast")
        self.succeeds("compare", "both/report.json", "both/report.json")
        said = json.loads(self.succeeds("compare", "both/report.json", "both/report.json", "--subjects", "mine=fast", "--json"))
        [subject] = said["subjects"]
        self.assertEqual((subject["before"]["name"], subject["after"]["name"]), ("mine", "fast"))
        self.assertEqual([(one["change"], one["property"]) for one in subject["changes"]], [("fixed", "distance.value")])

    def test_bad_input(self):
        self.refused("compare", "gone.json", "far/report.json", says="gone.json")
        self.refused("compare", "far/cases/distance.value.mine.json", "far/report.json", says='expected "report/1"')
        self.refused("compare", "far/report.json", "far/report.json", "--subjects", "mein", says='has no subject "mein"; did you mean mine')
        self.file("cut.json", (self.folder / "far/report.json").read_text()[:500])
        self.refused("compare", "cut.json", "far/report.json", says="cut.json")
        self.file("interrupted.json", self.json("far/report.json") | {"interrupted": True})
        self.refused("compare", "interrupted.json", "far/report.json", says="interrupted")

    def test_a_summary_in_markdown(self):
        said = self.succeeds("summary", "far/report.json").splitlines()
        self.assertEqual(said[:2], ["| properties that hold; wrong answers, worst grade | distance |", "|---|---|"])
        self.assertRegex(said[2], r"^\| `mine` \S+ \| 1 of 2; \d+(\.\d+)? % [DF] \|$")
        self.assertEqual(said[4], "`touchstone report --effort quick --seed 1`: 4 drawn scenes a query")
        self.assertRegex(self.succeeds("summary", "right/report.json"), r"(?m)^\| `mine` \S+ \| 2 of 2 \|$")
        self.assertEqual(self.succeeds("summary", "far/report.json", "--subjects", "mine").splitlines(), said)
        self.refused("summary", "far/report.json", "--subjects", "yours", says="has no subject yours")
        self.refused("summary", "absent.json", says="absent.json")


if __name__ == "__main__":
    unittest.main()
