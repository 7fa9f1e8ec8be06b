"""What is not an engine's fault is not charged to it: how numbers are written, what it does not offer, one cause in many rows."""

import json
import unittest

from program import *

# Answers each question with the value of an expression of the number of questions so far.
ENGINE_OF = """
import json, sys
asked = 0
for line in sys.stdin:
    message = json.loads(line)
    if message["op"] == "stop":
        break
    if message["op"] == "start":
        print('{"seq": %d, "protocol": 1, "card": {"name": "mine", "version": "0", "precision": "binary64", "answers": ["distance"]}}'
              % message["seq"], flush=True)
        continue
    asked += 1
    print('{"seq": %d, ' % message["seq"] + (ANSWER) + "}", flush=True)
"""


class FairVerdict(Test):
    def engine(self, answer):
        return "exec:/usr/bin/python3 " + str(self.folder / self.file("mine.py", ENGINE_OF.replace("ANSWER", answer)))

    def checked(self, answer, *words, code, cases=4):
        said = self.succeeds("check", "--subjects", self.engine(answer), "--queries", "distance", "--cases", cases, "--json", "r.json",
                             *words, code=code)
        return said, self.json("r.json")

    def test_an_integer_is_the_double_that_it_reads_as(self):
        """As JSON.stringify writes 2^69: its shortest digits, and zeros."""
        far = scene(body(ball(2**40)), body(ball(2**40), (2.0**69 + 2.0**41, 0, 0)))
        self.file("case.json", {"touchstone": "case/1", "property": "distance.value", "seed": 1, "index": 0, "scene": far,
                                "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}})
        subject = self.engine("""'"result": {"distance": 590295810358705700000}'""")
        self.succeeds("replay", "case.json", "--subject", subject)

    def test_a_query_that_is_never_answered_is_abstained_from(self):
        answer = """'"abstains": "no boxes"' if asked % 2 else '"breaks": {"kind": "threw", "how": "no hull %d"}' % asked"""
        said, report = self.checked(answer, code=0)
        self.assertRegex(said, r"mine +0 properties hold,   0 fail")
        for row in report["rows"]:
            self.assertEqual((row["fails"], row["breaks"], "grade" in row), (0, 0, False), row)
        self.assertTrue(any("it threw: no hull" in row.get("why_abstains", "") for row in report["rows"]))
        said, _ = self.checked(answer, "--require-answers", code=1)
        self.assertIn("mine distance: no answer, and answers are required", said)

    def test_a_required_answer_may_be_wrong_or_right(self):
        said, _ = self.checked("""'"result": {"verdict": "separated", "distance": 1}'""", "--require-answers", code=1)
        self.assertNotIn("answers are required", said)

    def test_a_scene_without_an_answer_is_one_failure(self):
        for answer in ("""'"breaks": {"kind": "threw", "how": "no hull %d"}' % asked""",
                       """'"result": {"verdict": "separated", "distance": NaN}'"""):
            said, report = self.checked(answer, code=1)
            for row in report["rows"]:
                survives = row["property"] == "distance.survives"
                self.assertEqual((row["breaks"] > 3, row["fails"]), (survives, 0), row)
                self.assertEqual(row["holds"] + row["not_asked"] + row["abstains"], 0, row)
                self.assertEqual(row.get("unanswered", 0) > 0, not survives and row["outside"] < 4, row)
            self.assertEqual([cause["rows"] for cause in report["causes"]], [["distance.survives"]])
            self.assertRegex(said, r"mine +0 properties hold,   1 fail, +\d+ not answered")

    def test_an_answer_to_one_question_of_a_law_and_none_to_the_other_is_a_failure_of_the_law(self):
        said, report = self.checked("""'"result": {"verdict": "separated", "distance": 1}' if asked == 1 else """
                                    """'"breaks": {"kind": "threw", "how": "no hull %d"}' % asked""", "--jobs", 1, code=1, cases=1)
        broken = [row["property"] for row in report["rows"] if row["breaks"] > 0 and row["property"] != "distance.repeats"]
        self.assertLessEqual({"distance.symmetric", "distance.turned"}, set(broken))
        self.assertEqual([row["holds"] for row in report["rows"] if row["property"] == "distance.survives"], [1])
        self.assertIn(broken, [cause["rows"] for cause in report["causes"]])
        self.assertEqual(said.count("for the same cause"), len(broken) - 1)

    def test_a_refusal_is_counted_apart(self):
        said, report = self.checked("""'"breaks": {"kind": "refused", "how": "a radius of %r"}' % (asked / 16)""",
                                    "--junit", "r.xml", "--sarif", "r.sarif", code=1)
        failing = [row for row in report["rows"] if row["refused"] > 0]
        self.assertEqual([row["property"] for row in failing], ["distance.survives"])
        row = failing[0]
        self.assertEqual((row["fails"], row["breaks"], row["grade"], list(row["defects"])), (0, 0, "D", ["refused"]))
        self.assertEqual([(cause["defect"], len(cause["rows"])) for cause in report["causes"]], [("refused", 1)])
        self.assertEqual(said.count("a radius of"), 1)
        self.assertRegex(said, r"mine distance.survives: (\d+) of \1 fail \(100 %\), \1 of them refused, grade D")
        self.assertRegex(said, r"mine +0 properties hold, +1 fail, +\d+ not answered; \d+ answers refused")
        self.assertIn('type="refused"', (self.folder / "r.xml").read_text())
        self.assertRegex((self.folder / "r.xml").read_text(), r"breaks 0, refused \d+, abstains")
        for result in self.json("r.sarif")["runs"][0]["results"]:
            self.assertEqual((result["properties"]["defect"], result["properties"]["refused"]), ("refused", result["properties"]["failures"]))

    def test_a_hang_is_one_break(self):
        self.checked("any(iter(int, 1))", "--jobs", 1, "--time-limit", "0.1", code=1)
        hung = {row["property"]: row["breaks"] for row in self.json("r.json")["rows"] if row["breaks"] > 0}
        self.assertEqual(list(hung.values()), [3], hung)  # by the first property that asks; then it is not asked

    def test_a_hang_is_not_another_answer(self):
        near = scene(body(ball(1)), body(ball(1), (3, 0, 0)))
        self.file("case.json", {"touchstone": "case/1", "property": "distance.repeats", "seed": 1, "index": 0, "scene": near,
                                "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}})
        for hangs_at in (2, 4):  # the same question again at once; or after another one
            said = self.succeeds("replay", "case.json", "--time-limit", "0.1", "--subject",
                                 self.engine(f"""'"result": {{"distance": 1}}' if asked < {hangs_at} else any(iter(int, 1))"""))
            self.assertNotIn("nondeterministic", said)
            self.assertIn("answered once, and once not within the time limit", said)

    def test_a_law_names_the_scene_that_broke_it(self):
        near = scene(body(ball(1)), body(ball(1), (3, 0, 0)))
        self.file("case.json", {"touchstone": "case/1", "property": "distance.scaled", "seed": 1, "index": 0, "scene": near,
                                "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}})
        x = 'message["scene"]["bodies"][1]["X_WB"]["p"][0]'
        threw = """'"breaks": {"kind": "threw", "how": "too small"}'"""
        subject = self.engine(f"""{threw} if {x} < 1e-3 else '"result": {{"distance": %r}}' % ({x} / 3)""")
        said = self.succeeds("replay", "case.json", "--subject", subject, code=1)
        self.assertRegex(said, r"(?m)^asked of +all lengths times 2\^-20$")
        self.succeeds("minimise", "case.json", "--budget", 1, "--subject", subject, "--out", "small.json")
        small = self.json("small.json")
        self.assertEqual(small["changed"]["how"], "all lengths times 2^-20")
        radii = [s["bodies"][0]["shape"]["radius"] for s in (small["scene"], small["changed"]["scene"])]
        self.assertEqual(radii[1], radii[0] * 2.0**-20)


if __name__ == "__main__":
    unittest.main()
