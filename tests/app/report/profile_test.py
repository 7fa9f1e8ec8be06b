"""Error against CPU time, the atlas and what is left out: their numbers are those of the run, times are nowhere else, and
the page shows them on a phone and on a desk. No time is asserted."""

import csv
import io
import os
import pathlib
import shlex
import unittest

from browser import SHOTS, folder_and_browser
from program import *

FAST = pathlib.Path(os.environ["TOUCHSTONE_SUBJECTS"]) / "touchstone-subject-fast"
QUERIES = ["broad_phase", "distance", "impulse"]


class Profile(Test):
    @classmethod
    def setUpClass(cls):
        cls.runs, cls.browser = folder_and_browser(cls)
        # Twice the distance where a hull has more than 6 vertices, beyond what the card declares.
        mine = shlex.join(["/usr/bin/python3", str(SOURCE / "tests/app/larger_distances.py"), str(FAST),
                           json.dumps({"domain": {"vertices": 6}})])
        write_meshes(cls.runs / "meshes")
        words = ["report", "--cases", "100", "--meshes", "meshes", "--queries", ",".join(QUERIES), "--out", "R",
                 "--subjects", "fast,bullet.float,libccd.gjk", "--subjects", "inproc:reference", "--subjects", "exec:" + mine]
        subprocess.run([PROGRAM, *as_asked(words)], cwd=cls.runs, check=True, capture_output=True, timeout=300)
        cls.report, cls.timing = (json.loads((cls.runs / "R" / name).read_text())
                                  for name in ("report.json", "report.timing.json"))
        cls.atlas = list(csv.DictReader(io.StringIO((cls.runs / "R/atlas.csv").read_text())))
        cls.page = (cls.runs / "R/index.html").as_uri()

    def rows(self, subject, query):
        return [row for row in self.report["rows"] if row["subject"] == subject and row["property"].startswith(query + ".")]

    def cells(self, **wanted):
        return [cell for cell in self.atlas if all(cell[key] == value for key, value in wanted.items())]

    def table(self, selector):
        return self.browser.value(f"[...document.querySelector('{selector}').rows].map(r => [...r.cells].map("
                                  "c => c.textContent.trim()))")

    def test_who_answers_has_times(self):
        self.assertEqual(self.timing["unit"], "s")
        timed = {(entry["query"], entry["subject"]): entry for entry in self.timing["times"]}
        for query in QUERIES:
            for card in self.report["subjects"]:
                answered = sum(row["holds"] + row["fails"] for row in self.rows(card["name"], query))
                entry = timed.get((query, card["name"]))
                self.assertEqual(entry is not None, answered > 0, (query, card["name"]))
                if entry:
                    self.assertGreater(entry["questions"], 0)
                    self.assertLess(0, entry["tenth"])
                    self.assertLessEqual(entry["tenth"], entry["median"])
                    self.assertLessEqual(entry["median"], entry["ninetieth"])
                    self.assertEqual(entry["in_process"], card["name"] == "reference")
        self.assertEqual({(plan["query"], plan["plan"]) for plan in self.timing["plans"]},
                         {("broad_phase", "planned"), ("broad_phase", "all parts")})

    def test_errors_beside_times_are_those_of_the_rows(self):
        self.browser.open(self.page, 1400)
        rows = {row[0].replace(" in process", ""): row for row in self.table("#speed\\\\.distance table")[1:]}
        for subject, digits in [("fast", 53), ("bullet.float", 24), ("mine", 53)]:
            row = next(r for r in self.report["rows"] if (r["property"], r["subject"]) == ("distance.value", subject))
            largest = row["errors"]["largest"] * 2.0 ** -digits
            self.assertEqual(rows[subject][4], f"{largest:.2g}" if largest else "exact")
            self.assertEqual(int(rows[subject][5]), sum(row["errors"]["at_most"].values()))
        # Shares that are left out: the reference says nothing of impulse.stated, mine is asked beyond its domain.
        self.assertNotEqual(rows["mine"][9], "")
        self.assertEqual(rows["fast"][9], "")

    def test_plots_have_units_names_and_links(self):
        self.browser.open(self.page, 1400)
        drawn = "[...document.querySelectorAll('#speed\\\\.{} svg a')].map(a => a.dataset.subject)"
        self.assertEqual(set(self.browser.value(drawn.format("distance"))),
                         {"reference", "fast", "bullet.float", "mine"})
        self.assertIn("has an error with a size: libccd.gjk", self.browser.value(
            "document.querySelector('#speed\\\\.distance').textContent"))
        self.assertEqual(self.browser.value("document.querySelector('#speed\\\\.broad_phase svg')"), None)
        text = self.browser.value("document.querySelector('#speed\\\\.distance svg').textContent")
        for words in ["median, µs", "error, as a share of the scene's scale", "exact"]:
            self.assertIn(words, text)
        self.assertEqual(self.browser.value("[...document.querySelectorAll('svg.plot a')].filter(a => "
                                            "!a.querySelector('title') || a.tabIndex < 0).length"), 0)
        self.browser.open(self.page + "?subjects=bullet", 1400)
        shown = "[...document.querySelectorAll('svg.plot a')].filter(a => a.getBoundingClientRect().width)" \
                ".map(a => a.dataset.subject)"
        self.assertEqual(set(self.browser.value(shown)), {"bullet.float"})

    def test_the_atlas_finds_where_a_subject_fails(self):
        """Mine is wrong where a hull has more than 6 vertices, and nowhere else."""
        by_vertices = self.cells(query="distance", subject="mine", axis="vertices")
        self.assertGreater(sum(int(cell["failing"]) for cell in by_vertices), 5)
        for cell in by_vertices:
            sides = {"0": "inside", "4": "inside", "8": "across"}
            self.assertEqual(cell["declared"], sides.get(cell["up_to"], "outside"))
            if cell["declared"] == "inside":
                self.assertEqual(cell["failing"], "0")
        self.assertEqual(sum(int(cell["failing"]) for cell in self.cells(subject="fast")), 0)

    def test_each_axis_counts_each_scene_once(self):
        for query in QUERIES:
            for card in self.report["subjects"]:
                axes = {cell["axis"] for cell in self.cells(query=query, subject=card["name"])}
                sums = {axis: [sum(int(cell[of]) for cell in self.cells(query=query, subject=card["name"], axis=axis))
                               for of in ("scenes", "failing", "broken")] for axis in axes}
                self.assertLessEqual(len({tuple(found) for axis, found in sums.items() if axis != "gap"}), 1, sums)
                for scenes, failing, broken in sums.values():
                    self.assertLessEqual(scenes, self.report["scenes"][query])
                    self.assertLessEqual(failing, scenes)
                    self.assertLessEqual(broken, failing)
        self.assertEqual({cell["axis"] for cell in self.cells(query="impulse")},
                         {"length", "thickness", "reach", "aspect", "vertices", "mass ratio", "slip", "friction", "speed", "spin"})

    def test_the_atlas_on_the_page(self):
        self.browser.open(self.page, 1400)
        tables = self.browser.value("[...document.querySelectorAll('#atlas\\\\.distance details')].map(d => "
                                    "d.querySelector('summary').textContent.split(':')[0])")
        self.assertEqual(tables[:2], ["gap", "length, m"])
        vertices = tables.index("vertices")
        rows = self.browser.value("[...document.querySelectorAll('#atlas\\\\.distance details')]"
                                  f"[{vertices}].querySelectorAll('tbody tr').length")
        self.assertEqual(rows, 5)
        edges = self.browser.value("[...[...document.querySelectorAll('#atlas\\\\.distance details')]"
                                   f"[{vertices}].querySelector('[data-subject=mine]').cells].map(c => c.className.split(' ').pop())")
        self.assertIn("rim", edges)
        self.assertIn("out", edges)

    def test_left_out(self):
        self.browser.open(self.page, 1400)
        rows = {row[0]: row for row in self.table("table.left-out")}
        self.assertIn("broad_phase", rows)
        self.assertEqual(rows["broad_phase"][1], f"{self.report['scenes']['broad_phase']} scenes planned")
        self.assertIn("vertices", rows)

    def test_phone_and_desk(self):
        self.assertLess((self.runs / "R/index.html").stat().st_size, 8e6)
        for width in (400, 1400):
            for dark in (False, True):
                with self.subTest(width=width, dark=dark):
                    self.browser.open(self.page, width, dark=dark)
                    self.browser.value("document.querySelectorAll('details').forEach(d => d.open = true)")
                    self.assertEqual(self.browser.complaints(), [])
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
                    if SHOTS:
                        for part in ("speed", "atlas", "left-out"):
                            top = self.browser.value(f"document.getElementById('{part}').getBoundingClientRect().top")
                            self.browser.screenshot(f"{SHOTS}/{part}{width}{'dark' if dark else ''}.png", top)


if __name__ == "__main__":
    unittest.main()
