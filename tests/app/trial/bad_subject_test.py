"""A subject that dies, hangs, prints garbage or answers NaN affects only its own rows."""

import json
import unittest
import xml.etree.ElementTree

from program import *

TWO_BALLS = scene(body(ball(1)), body(ball(1), (3, 0, 0)))


class AtItsStart(Test):
    def test_a_program_that_never_introduces_itself(self):
        for trick, says in [("start_exit", ("did not introduce itself", "no licence found")),
                            ("start_words", ("introduction:1:", f"{MISBEHAVING} start_words", "found the line: Welcome!")), ("start_deaf", ("did not introduce itself",))]:
            # The last takes ten seconds, which a program has to start.
            for command in ("report", "check") if trick != "start_deaf" else ("check",):
                self.refused(command, "--cases", 1, "--time-limit", 0.2, "--json", "r.json", "--out", "R",
                             "--subjects", f"exec:{MISBEHAVING} {trick}", says=["touchstone: subject", *says])


class OnAQuestion(Test):
    def replayed(self, trick):
        case = {"touchstone": "case/1", "property": "distance.survives", "seed": 1, "index": 0,
                "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0},
                "scene": {**TWO_BALLS, "name": "trap"}}
        self.file("case.json", case)
        code = 0 if trick in ("none", "print", "flood", "nap", "fast_math") else 1
        # What ends by itself has time enough on a busy machine too.
        limit = 0.2 if trick in ("spin", "sleep") else 20
        return json.loads(self.succeeds("replay", "case.json", "--json", "--time-limit", limit, "--subject",
                                        f"exec:{MISBEHAVING} {trick}", code=code))

    def test_each_trick_has_its_name(self):
        for trick, defect in {"none": "none", "print": "none", "flood": "none", "abort": "crashed", "exit": "crashed",
                              "orphan": "crashed", "spin": "hung", "sleep": "hung", "throw": "threw", "throw_int": "threw",
                              "wire_words": "garbage", "wire_empty": "garbage", "wire_bytes": "garbage",
                              "wire_truncated": "crashed", "wire_huge": "garbage", "wire_wrong_seq": "garbage",
                              "wire_null": "garbage", "wire_unknown_key": "garbage"}.items():
            with self.subTest(trick):
                self.assertEqual(self.replayed(trick)["defect"], defect)
        for trick in ("nan", "inf"):
            self.assertIn(self.replayed(trick)["defect"], ("garbage", "not_finite"))

    def test_a_whole_run_goes_on(self):
        write_meshes(self.folder / "meshes")
        for trick, defect in {"dies": "crashed", "hangs": "hung", "garbles": "garbage", "nan": "garbage"}.items():
            with self.subTest(trick):
                self.succeeds("check", "--subjects", f"{ENGINE} {trick}", "--subjects", "inproc:reference", "--json", "r.json",
                              "--junit", "r.xml", "--cases", 2, "--meshes", "meshes", "--time-limit", 0.5,
                              "--properties", "distance.repeats", code=1)
                rows = {row["subject"]: row for row in self.json("r.json")["rows"]}
                self.assertEqual((rows["reference"]["fails"], rows["reference"]["breaks"]), (0, 0))
                self.assertGreater(rows["reference"]["holds"], 0)
                self.assertGreater(rows["trickster"]["breaks"], 0)
                self.assertEqual(set(rows["trickster"]["defects"]), {defect})
                suites = xml.etree.ElementTree.parse(self.folder / "r.xml").getroot()
                self.assertEqual([suite.get("failures") for suite in suites], ["1", "0"])

    def test_three_hangs_end_a_query_and_the_search_for_a_smaller_scene(self):
        hangs = self.folder / "hangs.log"
        for jobs, most in ((1, 3 + 3), (3, 3 * 3 + 3)):
            hangs.unlink(missing_ok=True)
            self.succeeds("check", "--subjects", f"{ENGINE} always_hangs trickster {hangs}", "--cases", 200,
                          "--time-limit", 0.2, "--properties", "distance.survives,distance.repeats", "--jobs", jobs,
                          "--json", f"{jobs}.json", code=1)
            self.assertLessEqual(len(hangs.read_text().splitlines()), most)
        self.assertEqual(self.json("1.json"), self.json("3.json"))
        rows = self.json("1.json")["rows"]
        # What asks a question again is not asked about a scene on which the first answer did not come.
        self.assertEqual({row["property"]: (row["breaks"], row.get("defects")) for row in rows},
                         {"distance.survives": (3, {"hung": 3}), "distance.repeats": (0, None)})
        for row in rows:
            self.assertGreater(row["not_asked"], 200)

    def test_a_trajectory_may_take_longer_and_its_replay_has_the_same_limit(self):
        engine = self.file("sleepy.py", """
import json, sys
for line in sys.stdin:
    message = json.loads(line)
    while message["op"] == "ask":
        pass
    if message["op"] == "stop":
        break
    card = {"name": "sleepy", "version": "0", "precision": "binary64", "answers": ["simulation"]}
    print(json.dumps({"seq": message["seq"], "protocol": 1, "card": card}), flush=True)
""")
        said = self.succeeds("check", "--subjects", f"exec:/usr/bin/python3 {self.folder / engine}", "--time-limit", 0.08,
                             "--properties", "simulation.survives", "--cases", 1, "--out", "R", code=1)
        self.assertIn("no answer within 0.4 s of its own CPU time", said)  # quick: five times as long
        self.assertRegex(said, r" replay .* --time-limit 0\.04\b")  # replay: ten times

    def test_the_first_failure_ends_a_run(self):
        for jobs in (1, 3):
            self.succeeds("check", "--first-failure", "--subjects", f"{ENGINE} none", "--properties", "distance.value",
                          "--cases", 200, "--jobs", jobs, "--json", f"{jobs}.json", code=1)
        self.assertEqual(self.json("1.json"), self.json("3.json"))
        [row] = self.json("1.json")["rows"]
        self.assertEqual((row["fails"], row["size"]), (1, row["size_found"]))
        self.assertLess(self.json("1.json")["scenes"]["distance"], 100)

    def test_a_name_is_no_path_and_no_markup(self):
        name = "../../a<b>&'x y\u00e9"
        write_meshes(self.folder / "meshes")
        self.succeeds("report", "--subjects", f"{ENGINE} none \"{name}\"", "--properties", "distance.value", "--cases", 3,
                      "--meshes", "meshes", "--out", "R")
        cases = [p.name for p in (self.folder / "R/cases").iterdir()]
        self.assertEqual(len(cases), 1)
        self.assertRegex(cases[0], r"^distance\.value\.[A-Za-z0-9._-]+\.json$")
        self.assertEqual(self.json("R/report.json")["rows"][0]["subject"], name)
        self.assertEqual(xml.etree.ElementTree.parse(self.folder / "R/junit.xml").getroot()[0].get("name"), name)
        page = (self.folder / "R/index.html").read_text()
        self.assertNotIn("<b>&'", page)
        self.assertIn("a&lt;b&gt;&amp;", page)
        self.succeeds("replay", f"R/cases/{cases[0]}", "--subject", f"{ENGINE} none \"{name}\"", code=1)


if __name__ == "__main__":
    unittest.main()
