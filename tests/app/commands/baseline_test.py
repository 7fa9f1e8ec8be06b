"""check --baseline: green on the state that it was written of, red on what is new, worse, gone, or no longer waived."""

import json
import unittest
import xml.etree.ElementTree as xml

from program import *

RIGHT, A_BIT, LESS, MUCH = "1", "1.000000001", "0.999999999", "1.5"
WAIVER = {"reason": "an old compiler", "link": "https://example.org/7", "expires": "2027-03-31"}


class Baseline(Test):
    """A subject whose distances are a bit too long, and what the same subject says on a later day."""

    def check(self, factor, *words, code, property="distance.value"):
        return self.succeeds("check", "--subjects", altered(factor), "--properties", property, "--cases", 4, "--jobs", 1, *words,
                             code=code)

    def setUp(self):
        super().setUp()
        self.check(A_BIT, "--write-baseline", "known.json", code=0)

    def waive(self, **changes):
        known = self.json("known.json")
        known["failures"][0]["waiver"] = WAIVER | changes
        self.file("known.json", known)

    def test_it_holds_the_failures_by_property_cause_and_grade(self):
        known = self.json("known.json")
        self.assertEqual(known["failures"], [{"subject": "mine", "property": "distance.value", "cause": "too_far", "grade": "C"}])
        self.assertEqual((known["touchstone"], known["seed"], known["effort"], known["cases_per_query"]),
                         ("baseline/1", 1, "quick", 4))

    def test_green_on_its_own_state(self):
        said = self.check(A_BIT, "--baseline", "known.json", "--junit", "j.xml", "--sarif", "s.json", code=0)
        self.assertIn("known.json: 1 known (0 waived), 0 new, 0 worse", said)
        self.assertNotIn("1 of ", said)
        suite = xml.parse(self.folder / "j.xml").getroot()[0]
        self.assertEqual((suite.get("failures"), suite.get("skipped")), ("0", "1"))
        self.assertEqual(suite[0][0].get("message"), "known: too_far, grade C, in the baseline")
        [suppression] = self.json("s.json")["runs"][0]["results"][0]["suppressions"]
        self.assertEqual(suppression["status"], "accepted")

    def test_red_on_a_new_failure(self):
        self.file("none.json", self.json("known.json") | {"failures": []})
        said = self.check(A_BIT, "--baseline", "none.json", "--junit", "j.xml", code=1)
        self.assertIn("mine distance.value: new: too_far, grade C", said)
        self.assertIn("fails: too_far", said)
        self.assertEqual(xml.parse(self.folder / "j.xml").getroot()[0].get("failures"), "1")

    def test_red_on_a_worse_grade(self):
        said = self.check(MUCH, "--baseline", "known.json", code=1)
        self.assertRegex(said, r"mine distance\.value: worse: too_far, grade [DF]; in the baseline C")

    def test_green_on_a_better_grade(self):
        self.check(MUCH, "--write-baseline", "bad.json", code=0)
        self.check(A_BIT, "--baseline", "bad.json", code=0)

    def test_red_on_another_cause(self):
        said = self.check(LESS, "--baseline", "known.json", code=1)
        self.assertIn("mine distance.value: new: too_near, grade C", said)
        self.assertIn("mine distance.value: passes, though a failure is expected: too_far, grade C", said)

    def test_red_on_a_pass(self):
        said = self.check(RIGHT, "--baseline", "known.json", "--junit", "j.xml", code=1)
        self.assertIn("mine distance.value: passes, though a failure is expected: too_far, grade C", said)
        [failure] = xml.parse(self.folder / "j.xml").getroot()[0][0]
        self.assertEqual((failure.tag, failure.get("type")), ("failure", "passes"))

    def test_a_waiver_counts_until_it_expires(self):
        self.waive()
        on_the_day = self.check(A_BIT, "--baseline", "known.json", "--today", "2027-03-31", "--sarif", "s.json", code=0)
        self.assertIn("known.json: 1 known (1 waived), 0 new", on_the_day)
        self.assertIn("waived until 2027-03-31: an old compiler", self.json("s.json")["runs"][0]["results"][0]["suppressions"][0]["justification"])
        said = self.check(A_BIT, "--baseline", "known.json", "--today", "2027-04-01", code=1)
        self.assertIn("mine distance.value: the waiver for too_far expired on 2027-03-31: an old compiler (https://example.org/7)", said)
        self.waive(expires="2020-02-29")
        self.assertIn("expired on 2020-02-29", self.check(A_BIT, "--baseline", "known.json", code=1))  # of the machine's date

    def test_red_on_a_waived_pass(self):
        self.waive()
        said = self.check(RIGHT, "--baseline", "known.json", "--today", "2027-01-01", code=1)
        self.assertIn("passes, though a failure is expected: too_far, grade C, waived: an old compiler (https://example.org/7)", said)

    def test_writing_again_keeps_waivers(self):
        self.waive()
        self.check(MUCH, "--write-baseline", "known.json", code=0)
        [failure] = self.json("known.json")["failures"]
        self.assertEqual(failure["waiver"], WAIVER)
        self.assertGreater(failure["grade"], "C")
        self.check(RIGHT, "--write-baseline", "known.json", code=0)
        self.assertEqual(self.json("known.json")["failures"], [])

    def test_what_was_not_asked_or_not_answered_is_no_pass(self):
        for factor, property in [(A_BIT, "distance.symmetric"), ("silent", "distance.value")]:
            said = self.check(factor, "--baseline", "known.json", code=0, property=property)
            self.assertIn("known.json: 1 not asked or not answered", said)

    def test_other_scenes_are_mentioned(self):
        done = self.run_program("check", "--subjects", altered(A_BIT), "--properties", "distance.value", "--cases", 4, "--seed", 2,
                                "--baseline", "known.json")
        self.assertIn("known.json: written of other scenes: --seed 1, --effort quick, 4 scenes of each query; now --seed 2", done.stderr)

    def test_a_bad_file_is_named_with_its_place(self):
        good = self.json("known.json")
        entry = good["failures"][0]

        def with_entry(**changes):
            return good | {"failures": [{k: v for k, v in (entry | changes).items() if v is not None}]}

        for content, says in [
            ("{", "bad.json:1:2: "),
            (good | {"touchstone": "case/1"}, 'touchstone: expected "baseline/1", found "case/1"'),
            (good | {"more": 1}, "more"),
            (good | {"seed": -1}, "seed: expected an integer from 0 to 2^64 - 1"),
            (with_entry(grade="A"), 'failures[0].grade: "A" is unknown'),
            (with_entry(grade=None), "failures[0]"),
            (with_entry(cause="none"), 'failures[0].cause: "none" is unknown'),
            (with_entry(property="distance.valu"), 'failures[0].property: no property is called "distance.valu"; did you mean distance.value'),
            (with_entry(subject=""), "failures[0].subject: is empty"),
            (with_entry(waiver=WAIVER | {"expires": "2027-02-29"}), 'failures[0].waiver.expires: expected a date as "2027-03-31"'),
            (with_entry(waiver=WAIVER | {"reason": ""}), "failures[0].waiver.reason: is empty"),
            (with_entry(waiver={"reason": "x", "expires": "2027-02-28"}), "failures[0].waiver"),
            (good | {"failures": [entry, entry | {"grade": "D"}]}, "failures[1]: a second entry for the same subject"),
        ]:
            self.file("bad.json", content)
            for option in ("--baseline", "--write-baseline"):
                self.refused("check", "--subjects", altered(A_BIT), "--properties", "distance.value", option, "bad.json",
                             says=["bad.json:", says])
        self.refused("check", "--baseline", "gone.json", says="gone.json")
        self.refused("check", "--write-baseline", "gone/known.json", says="gone/known.json")

    def test_options_that_do_not_go_together(self):
        self.refused("check", "--baseline", "known.json", "--first-failure", says="--first-failure")
        self.refused("check", "--write-baseline", "new.json", "--first-failure", says="--first-failure")
        self.refused("check", "--today", "2027-01-01", says="--baseline")
        for day in ("2027-13-01", "2027-02-29", "1.4.2027", "2027-1-1", "tomorrow"):
            self.refused("check", "--baseline", "known.json", "--today", day, says=["--today: expected a date", day])


if __name__ == "__main__":
    unittest.main()
