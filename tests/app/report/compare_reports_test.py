"""Reports that differ in what is explained, and in what is not. This needs no built program."""

import contextlib
import copy
import io
import json
import pathlib
import tempfile
import unittest

import compare_reports

FINDING = {"outcome": "fails", "defect": "too_late", "observed": "met at 1.5", "error": 0.25, "allowed": 0.125}
SCENE = {"touchstone": "scene/1", "bodies": [{"shape": {"type": "sphere", "radius": 1}}],
         "flight": {"times": [1, 2], "since": [0, 0.5], "pushes": [{"time": 1, "body": 0}]}}
CASE = {"touchstone": "case/1", "property": "time_of_impact.agrees", "finding": FINDING, "scene": SCENE}
ROW = {"property": "time_of_impact.agrees", "subject": "engine", "holds": 3, "fails": 1, "grade": "B",
       "worst": {"family": "flights.thrown", "index": 7, "finding": FINDING}, "case": "cases/one.json"}
REPORT = {"touchstone": "report/1", "cases_per_stem": 4,
          "subjects": [{"name": "engine", "about": "a loop"}],
          "properties": [{"id": "time_of_impact.agrees", "stem": "time_of_impact", "says": "they meet"}],
          "rows": [ROW, {"property": "time_of_impact.mass", "subject": "engine", "holds": 4, "fails": 0}],
          "classes": {"time_of_impact": {"pushes": 1}}}
START_TIMES = "rows: time_of_impact.agrees of engine.case.scene.motion.start_times"


class CompareReports(unittest.TestCase):
    def setUp(self):
        self.old = (copy.deepcopy(REPORT), copy.deepcopy(CASE))
        self.new = (copy.deepcopy(REPORT), copy.deepcopy(CASE))
        report, case = self.new
        report["cases_per_query"] = report.pop("cases_per_stem")
        report["properties"][0]["query"] = report["properties"][0].pop("stem")
        motion = case["scene"]["motion"] = case["scene"].pop("flight")
        classes = report["classes"]["time_of_impact"]
        classes["applied forces"] = classes.pop("pushes")
        motion.update(sample_times=motion.pop("times"), start_times=motion.pop("since"), forces=motion.pop("pushes"))

    def compare(self):
        """Returns the exit code and the lines."""
        with tempfile.TemporaryDirectory(prefix="touchstone_") as folder:
            paths = []
            for name, (report, case) in (("old", self.old), ("new", self.new)):
                (pathlib.Path(folder) / name / "cases").mkdir(parents=True)
                paths.append(pathlib.Path(folder) / name / "report.json")
                paths[-1].write_text(json.dumps(report))
                (paths[-1].parent / "cases/one.json").write_text(json.dumps(case))
            with contextlib.redirect_stdout(io.StringIO()) as printed:
                code = compare_reports.main(*paths)
        return code, printed.getvalue().splitlines()

    def differs(self, line):
        code, lines = self.compare()
        self.assertEqual(code, 1)
        self.assertIn(line, lines)
        self.assertEqual(lines[-1], "1 differences are not explained")

    def test_renamed_keys_are_explained(self):
        code, lines = self.compare()
        self.assertEqual(code, 0, lines)
        self.assertIn("explained, 1 times: the key flight is motion", lines)
        self.assertIn("explained, 1 times: the key pushes is applied forces", lines)
        self.assertEqual(len(lines), 8)

    def test_a_class_keeps_its_count(self):
        self.new[0]["classes"]["time_of_impact"]["applied forces"] = 2
        self.differs("classes.time_of_impact.applied forces: 1 -> 2")

    def test_other_words_around_the_same_numbers_are_explained(self):
        self.new[0]["rows"][0]["worst"]["finding"]["observed"] = "contact at 1.5 s"
        code, lines = self.compare()
        self.assertEqual(code, 0, lines)
        self.assertIn('explained, 1 times: wording of observed: "met at #" -> "contact at # s"', lines)

    def test_other_numbers_in_a_sentence_are_not(self):
        self.new[0]["rows"][0]["worst"]["finding"]["observed"] = "met at 1.25"
        self.differs('rows: time_of_impact.agrees of engine.worst.finding.observed: "met at 1.5" -> "met at 1.25"')

    def test_an_outcome(self):
        self.new[1]["finding"]["outcome"] = "breaks"
        self.differs('rows: time_of_impact.agrees of engine.case.finding.outcome: "fails" -> "breaks"')

    def test_a_count(self):
        self.new[0]["rows"][1].update(holds=3)
        self.differs("rows: time_of_impact.mass of engine.holds: 4 -> 3")

    def test_a_missing_row(self):
        del self.new[0]["rows"][1]
        code, lines = self.compare()
        self.assertEqual(code, 1)
        self.assertTrue(lines[0].startswith("rows: time_of_impact.mass of engine: {"), lines)
        self.assertTrue(lines[0].endswith("-> absent"), lines)

    def test_the_order_of_rows(self):
        self.new[0]["rows"].reverse()
        self.differs("rows: in another order")

    def test_a_bit_of_a_minimised_scene(self):
        self.new[1]["scene"]["motion"]["start_times"][1] = 0.5000000000000001
        self.differs(f"{START_TIMES}[1]: 0.5 -> 0.5000000000000001")

    def test_the_sign_of_zero(self):
        self.new[1]["scene"]["motion"]["start_times"][0] = -0.0
        self.differs(f"{START_TIMES}[0]: 0 -> -0.0")

    def test_a_new_key(self):
        self.new[0]["rows"][1]["breaks"] = 1
        self.differs("rows: time_of_impact.mass of engine.breaks: absent -> 1")


if __name__ == "__main__":
    unittest.main()
