"""A small whole run: its output is complete and repeats byte for byte, and every case replays."""

import html
import pathlib
import re
import shutil
import tempfile
import unittest
import xml.etree.ElementTree

from program import *


def files(folder):
    """The content of the files, without the folder's own path, which commands contain."""
    return {str(p.relative_to(folder)): p.read_bytes().replace(bytes(folder), b"HERE") for p in sorted(folder.rglob("*"))
            if p.is_file()}


class Report(Test):
    @classmethod
    def setUpClass(cls):
        cls.runs = pathlib.Path(tempfile.mkdtemp(prefix="touchstone_")).resolve()
        cls.addClassCleanup(shutil.rmtree, cls.runs)
        write_meshes(cls.runs / "meshes")
        cls.told = {}
        for name, jobs, seed in [("once", 1, 7), ("again", 2, 7), ("other", 2, 8)]:
            words = ["report", "--queries", "bounds,distance,penetration", "--subjects", "reference,fast,bullet.float,fcl.indep",
                     "--meshes", "meshes", "--cases", 12, "--seed", seed, "--jobs", jobs, "--out", name]
            cls.told[name] = subprocess.run([PROGRAM, *as_asked(words)], cwd=cls.runs, capture_output=True, text=True,
                                            timeout=600)

    def setUp(self):
        self.folder = self.runs
        self.report = self.json("once/report.json")

    def test_exit_code_and_streams(self):
        for name, done in self.told.items():
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(done.stdout.endswith(f"{name}/index.html\n"), done.stdout)
            self.assertEqual(done.stderr, "")

    def test_meshes_are_counted_and_so_are_those_left_out(self):
        meshes = self.report["meshes"]
        self.assertEqual((meshes["read"], meshes["left_out"]), (2, 1))
        self.assertGreater(sum(meshes["scenes"].values()), 0)

    def test_the_same_seed_gives_the_same_bytes(self):
        once, again, other = (files(self.runs / name) for name in ("once", "again", "other"))
        self.assertEqual(sorted(once), sorted(again))
        self.assertIn("report.timing.json", once)
        for name, content in without_times(once).items():
            self.assertEqual(content, without_times(again)[name], name)
        self.assertNotEqual(once["report.json"], other["report.json"])
        self.assertNotIn(b"HERE", once["report.json"])  # a file to compare across machines

    def test_one_row_a_property_and_subject(self):
        pairs = [(row["property"], row["subject"]) for row in self.report["rows"]]
        self.assertEqual(len(pairs), len(set(pairs)))
        self.assertEqual(len(pairs), len({p for p, _ in pairs}) * len({s for _, s in pairs}))
        self.assertFalse(self.report["interrupted"])
        for row in self.report["rows"]:
            for count in ("holds", "fails", "abstains", "breaks"):
                self.assertIsInstance(row[count], int)
            failing = row["fails"] + row["breaks"] > 0
            self.assertEqual("case" in row and bool(row["case"]), failing, row)
            if failing:
                self.assertTrue((self.runs / "once" / row["case"]).is_file(), row)
            if row["subject"] in ("reference", "fast"):
                self.assertFalse(failing, row)
        named = {row["case"] for row in [*self.report["rows"], *self.report["beyond"]] if row.get("case")}
        self.assertEqual(named, {"cases/" + p.name for p in (self.runs / "once/cases").iterdir()})
        self.assertGreater(len(named), 5)

    def test_junit_says_what_the_rows_say(self):
        suites = xml.etree.ElementTree.parse(self.runs / "once/junit.xml").getroot()
        rows = {(row["subject"], row["property"]): row for row in self.report["rows"]}
        for suite in suites:
            cases = suite.findall("testcase")
            self.assertEqual(int(suite.get("tests")), len(cases))
            self.assertEqual(int(suite.get("failures")), len(suite.findall("testcase/failure")))
            self.assertEqual(int(suite.get("skipped")), len(suite.findall("testcase/skipped")))
            for case in cases:
                row = rows.pop((case.get("classname"), case.get("name")))
                self.assertEqual(case.find("failure") is not None, row["fails"] + row["breaks"] > 0, row)
                self.assertEqual(case.find("skipped") is not None, row["holds"] + row["fails"] + row["breaks"] == 0, row)
        self.assertFalse(rows)

    def test_every_case_replays(self):
        for row in filter(lambda row: row.get("case"), self.report["rows"]):
            said = self.succeeds("replay", "once/" + row["case"], code=1)
            for label in ("property", "clause", "subject"):
                self.assertRegex(said, rf"(?m)^{label} +\S")
            self.assertRegex(said, rf"TS-[A-Z-]+-\d+ ")
            self.assertIn(row["property"], said)
            case = self.json("once/" + row["case"])
            if row["property"].startswith(("distance.", "penetration.")):
                self.assertRegex(said, r"(?m)^truth +(separated|touching|overlapping); distance .*\|d\*\|² = \d")
            for label in ("observed", "expected"):
                if case["finding"].get(label):
                    self.assertRegex(said, rf"(?m)^{label} +\S")
            self.assertTrue(re.search(r"(?m)^(observed|because) +\S", said), said)

    def test_a_second_report_leaves_nothing_of_the_first(self):
        shutil.copytree(self.runs / "once", self.runs / "twice")
        (self.runs / "twice/cases/mine.txt").write_text("mine")
        self.succeeds("report", "--subjects", "inproc:reference", "--queries", "bounds", "--cases", 1, "--out", "twice")
        self.assertEqual([p.name for p in (self.runs / "twice/cases").iterdir()], ["mine.txt"])


class Commands(Test):
    """Replay commands run as printed, from the report's folder, from the clone and from any other folder."""

    def setUp(self):
        super().setUp()
        self.folder = self.folder.resolve() / "a clone's folder"
        (self.folder / "engines").mkdir(parents=True)
        engine = (SOURCE / "tests/app/engine.py").read_text()
        (self.folder / "engines/engine.py").write_text(engine.replace("else 5)", "else 1)"))
        write_meshes(self.folder / "meshes")

    def told_commands(self, *words, cases=3):
        """Runs the commands from the terminal, the page and the JUnit XML."""
        said = self.run_program(*words, "--properties", "distance.value,distance.repeats,distance.scaled",
                                "--cases", cases, "--meshes", "meshes", "--out", "R")
        page = (self.folder / "R/index.html").read_text()
        junit = "".join(xml.etree.ElementTree.parse(self.folder / "R/junit.xml").getroot().itertext())
        of = {"terminal": re.findall(r"(?m)^ +(.* replay .*)$", said.stdout),
              "page": [html.unescape(c) for c in re.findall(r"<code>([^<]* replay [^<]*cases/[^<]*)</code>", page)],
              "JUnit": re.findall(r"(?m)^replay: (.*)$", junit)}
        report = self.json("R/report.json")
        cases = [row["case"] for row in report["rows"] + report["beyond"] if row.get("case")]
        self.assertTrue(cases)
        self.assertEqual(len(of["page"]), len(cases))
        counted = [command for command in of["page"] if ".beyond.json" not in command]  # the others fail no test
        self.assertEqual(sorted(counted), sorted(of["JUnit"]))
        if words[0] == "check":
            # A cause is told in words once, with the replay of its first row.
            report = self.json("R/report.json")
            case_of = {(row["subject"], row["property"]): row.get("case") for row in report["rows"]}
            for cause in report["causes"]:
                first = case_of[cause["subject"], cause["rows"][0]]
                self.assertTrue([c for c in of["terminal"] if c in of["page"] and first in c], first)
        return set().union(*of.values())

    def same_finding_from(self, command, folder):
        done = subprocess.run(["sh", "-c", command], cwd=folder, capture_output=True, text=True)
        case = next(p for p in (self.folder / "R/cases").iterdir() if p.name in command)
        finding = json.loads(case.read_text())["finding"]
        self.assertEqual(done.returncode, 0 if ".closest." in case.name else 1, f"{command}\n{done.stdout}{done.stderr}")
        self.assertIn(f"outcome      {finding['outcome']}", done.stdout)
        for label in ("observed", "expected"):
            if finding.get(label):
                self.assertRegex(done.stdout, rf"(?m)^{label} +{re.escape(finding[label])}$")
        if finding.get("why") and finding["defect"] != "hung":  # which clock is named depends on the load
            self.assertIn(finding["why"], done.stdout)

    def test_they_run_from_anywhere(self):
        for subject, limit, cases in [("fcl.indep", 1, 30), ("exec:/usr/bin/python3 engines/engine.py none \"it's $HOME\"", 1, 3),
                                      ("exec:/usr/bin/python3 engines/engine.py hangs", 0.3, 1), (f"exec:'{CANARY}' canary.nan", 1, 3)]:
            if subject == "fcl.indep" and "fcl.indep" not in self.succeeds("list", "subjects"):
                continue
            with self.subTest(subject):
                for command in self.told_commands("check", "--subjects", subject, "--time-limit", limit, cases=cases):
                    for folder in (self.folder, self.folder / "R", "/"):
                        self.same_finding_from(command, folder)

    def test_report_prints_the_same(self):
        self.assertTrue(self.told_commands("report", "--subjects", f"exec:{CANARY} canary.nan"))


class Check(Test):
    def test_all_queries_are_asked_by_default(self):
        self.succeeds("check", "--subjects", "inproc:fast", "--cases", 1, "--json", "r.json")
        report = self.json("r.json")
        self.assertEqual({p["query"] for p in report["properties"]},
                         {"mass", "bounds", "broad_phase", "distance", "penetration", "pixel", "impulse", "time_of_impact",
                          "simulation", "constraint"})
        self.assertTrue(all(scenes > 0 for scenes in report["scenes"].values()))

    def test_quick_asks_the_exact_reference_for_trajectories_only_by_itself(self):
        words = ("check", "--properties", "simulation.survives", "--cases", 1, "--json", "r.json", "--subjects", "inproc:reference")
        self.succeeds(*words, "--subjects", "inproc:fast")
        asked = {row["subject"]: (row["holds"] > 0, row["not_asked"] > 0) for row in self.json("r.json")["rows"]}
        self.assertEqual(asked, {"fast": (True, False), "reference": (False, True)})
        self.succeeds(*words)
        self.assertEqual([(row["holds"] > 0, row["not_asked"]) for row in self.json("r.json")["rows"]], [(True, 0)])

    def test_exit_codes_and_files(self):
        words = ("check", "--queries", "distance", "--cases", 4, "--json", "r.json", "--junit", "r.xml", "--subjects")
        self.succeeds(*words, "inproc:reference")
        self.assertEqual({row["subject"] for row in self.json("r.json")["rows"]}, {"reference"})
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["r.json", "r.xml"])
        said = self.succeeds(*words, f"exec:{CANARY} canary.nan", code=1)
        self.assertRegex(said, r"(?m)^\S+ distance\.survives: \d+ of \d+ fail \(\d+ %\), grade F$")
        self.assertIn("breaks: garbage", said)
        xml.etree.ElementTree.parse(self.folder / "r.xml")

    def test_properties_and_stems_choose(self):
        self.succeeds("check", "--subjects", "inproc:reference", "--properties", "distance.value,mass.mass", "--cases", 2,
                      "--json", "r.json")
        self.assertEqual({row["property"] for row in self.json("r.json")["rows"]}, {"distance.value", "mass.mass"})


if __name__ == "__main__":
    unittest.main()
