"""The report in a browser: no errors, no word cut off on a phone, and every link has a target."""

import sys
import unittest

from browser import SHOTS, folder_and_browser
from program import *


class Page(Test):
    @classmethod
    def setUpClass(cls):
        cls.runs, cls.browser = folder_and_browser(cls)
        write_meshes(cls.runs / "meshes")
        words = ["report", "--cases", "10", "--meshes", "meshes", "--queries", "mass,distance,penetration", "--out", "R",
                 "--subjects", "reference,fast,bullet.float,fcl.indep,libccd.gjk"]
        subprocess.run([PROGRAM, *as_asked(words)], cwd=cls.runs, check=True, capture_output=True)
        cls.page = (cls.runs / "R/index.html").as_uri()

    def test_phone_and_desk_in_light_and_dark(self):
        for width in (390, 400, 1400):
            for dark in (False, True):
                with self.subTest(width=width, dark=dark):
                    self.browser.open(self.page, width, dark=dark)
                    self.assertEqual(self.browser.complaints(), [])
                    self.browser.value("document.querySelectorAll('details').forEach(e => { e.open = true })")
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
                    self.browser.value("document.querySelectorAll('details').forEach(e => { e.open = false })")
                    if SHOTS:
                        for top in (0, 900, 2400):
                            self.browser.screenshot(f"{SHOTS}/{width}{'dark' if dark else ''}{top}.png", top)

    def test_dark_is_dark(self):
        brightness = []
        for dark in (False, True):
            self.browser.open(self.page, 390, dark=dark)
            paper = self.browser.value("getComputedStyle(document.body).backgroundColor")
            brightness.append(sum(map(int, paper.strip("rgb()").split(","))))
        self.assertGreater(brightness[0], 600)
        self.assertLess(brightness[1], 200)

    def test_links(self):
        self.browser.open(self.page, 1300)
        broken = "[...document.querySelectorAll('a[href^=\"#\"]')].map(a => a.getAttribute('href')).filter(" \
                 "h => h != '#' && !document.getElementById(decodeURIComponent(h.slice(1))))"
        self.assertEqual(self.browser.value(broken), [])
        self.assertEqual(self.browser.value("[...document.querySelectorAll('[id]')].length - "
                                            "new Set([...document.querySelectorAll('[id]')].map(e => e.id)).size"), 0)
        files = self.browser.value("[...document.querySelectorAll('a')].map(a => a.getAttribute('href'))"
                                   ".filter(h => !/^(#|https?:)/.test(h))")
        for file in files:
            self.assertTrue((self.runs / "R" / file).is_file(), file)
        linked = {file for file in files if file.startswith("cases/")}
        self.assertEqual(linked, {"cases/" + p.name for p in (self.runs / "R/cases").iterdir()})
        self.assertGreater(len(linked), 5)

    def test_begins_with_subjects_and_queries(self):
        self.browser.open(self.page, 1300)
        self.assertEqual(self.browser.value("[...document.querySelectorAll('h2')].map(e => e.id)")[:3],
                         ["matrix", "plainest", "table"])
        cells = self.browser.value("[...document.querySelectorAll('.matrix tr')].map(r => [...r.cells].map("
                                   "c => c.innerText.trim().replace(/\\s+/g, ' ')))")
        self.assertEqual(cells[0], ["subject", "all", "mass", "distance", "penetration"])
        table = {row[0]: row[1:] for row in cells[1:]}
        self.assertEqual(table["libccd.gjk"][1], "–")
        rows = json.loads((self.runs / "R/report.json").read_text())["rows"]
        for subject, shown in table.items():
            own = [r for r in rows if r["subject"] == subject and r["property"].startswith("penetration.")
                   and r["holds"] + r["fails"] + r["breaks"] + r["refused"]]
            hold = [r for r in own if not r["fails"] + r["breaks"] + r["refused"]]
            self.assertIn(f"{len(hold)} of {len(own)}", shown[3], subject)

    def test_tables_leave_out_who_does_not_answer(self):
        self.browser.open(self.page, 1300)
        columns = "[...document.getElementById('table.{}').querySelectorAll('thead th')].map(e => e.textContent.trim())"
        self.assertEqual(self.browser.value(columns.format("distance")),
                         ["property", "reference", "fast", "bullet.float", "fcl.indep", "libccd.gjk"])
        self.assertNotIn("libccd.gjk", self.browser.value(columns.format("mass")))
        self.assertIn("libccd.gjk", self.browser.value("document.getElementById('table.mass').textContent"))

    def test_heads_stay(self):
        self.browser.open(self.page, 390, height=300)
        top_and_left = "(h => [h.top, h.left])(document.querySelector('.matrix thead th').getBoundingClientRect())"
        before = self.browser.value(top_and_left)
        self.browser.value("document.querySelector('.matrix').parentElement.scrollBy(200, 100)")
        self.assertEqual(self.browser.value("document.querySelector('.matrix').parentElement.scrollLeft > 0"), True)
        self.assertEqual(self.browser.value(top_and_left), before)

    def test_filter(self):
        visible = "[...document.querySelectorAll('{}')].filter(e => e.offsetParent).map(e => e.dataset.{})"
        self.browser.open(self.page, 1300)
        self.browser.value("(f => { f.value = 'fcl LIBCCD'; f.dispatchEvent(new Event('input', {bubbles: true})) })"
                           "(document.querySelector('[name=subjects]'))")
        self.assertEqual(self.browser.value(visible.format(".matrix tr[data-subject]", "subject")), ["fcl.indep", "libccd.gjk"])
        self.assertEqual(self.browser.value("location.search"), "?subjects=fcl+LIBCCD")
        self.browser.open(self.page + "?subjects=indep&properties=mass.", 1300)  # a link to what was filtered
        self.assertEqual(self.browser.value(visible.format(".matrix tr[data-subject]", "subject")), ["fcl.indep"])
        shown = self.browser.value(visible.format(".by-subject tr[data-property]", "property"))
        self.assertGreater(len(shown), 5)
        self.assertTrue(all(name.startswith("mass.") for name in shown), shown)
        self.assertEqual(set(self.browser.value(visible.format(".by-subject th[data-subject]", "subject"))), {"fcl.indep"})

    def test_a_link_opens_its_row(self):
        self.browser.open(self.page, 1300)
        rows = self.browser.value("[...document.querySelectorAll('details.row')].map(e => e.id)")
        self.browser.open(f"{self.page}?#{rows[0]}", 1300)
        self.assertEqual(self.browser.value("[...document.querySelectorAll('details.row')].map(e => e.open)"),
                         [True] + [False] * (len(rows) - 1))

    def test_pictures_are_drawn(self):
        self.browser.open(self.page, 1300)
        self.assertGreater(self.browser.value("document.querySelectorAll('svg').length"), 0)
        self.assertEqual(self.browser.value("[...document.querySelectorAll('svg *')].filter(e => [...e.attributes]"
                                            ".some(a => /nan|inf/i.test(a.value))).length"), 0)

    def test_a_picture_turns(self):
        self.browser.open(self.page, 1300)
        self.browser.value("picture = document.querySelector('.card svg.turns'); picture.scrollIntoView()")
        left, top, width = self.browser.value("(b => [b.left, b.top, b.width])(picture.getBoundingClientRect())")
        drawn = lambda: self.browser.value("picture.querySelector('.front').innerHTML")
        front = drawn()

        def drag(kinds, send):
            for kind, x, y in zip(kinds, (0.7, 0.8, 0.8), (40, 60, 60)):
                send(kind, left + x * width, top + y)

        drag(["mousePressed", "mouseMoved", "mouseReleased"], lambda kind, x, y: self.browser.call(
            "Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=int(kind != "mouseReleased"), clickCount=1))
        by_mouse = drawn()
        self.assertNotEqual(by_mouse, front)
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=left + 0.6 * width, y=top + 40)
        self.assertEqual(drawn(), by_mouse)  # the button is up

        def key(name):
            self.browser.call("Input.dispatchKeyEvent", type="keyDown", key=name)

        self.browser.value("picture.focus()")
        key("Home")
        at_home = drawn()
        for name in ("ArrowRight", "ArrowDown"):
            key(name)
        self.assertEqual(self.browser.value("picture.lastElementChild.textContent"), "turned by -10°, 10°")
        key("Home")
        self.assertEqual(drawn(), at_home)

        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=True)
        drag(["touchStart", "touchMove", "touchEnd"], lambda kind, x, y: self.browser.call(
            "Input.dispatchTouchEvent", type=kind, touchPoints=[] if kind == "touchEnd" else [{"x": x, "y": y}]))
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=False)
        self.assertNotEqual(drawn(), at_home)

    def test_turned_by_a_right_angle_it_is_the_view_from_above(self):
        self.browser.open(self.page, 1300)
        corners = "[...{}.querySelectorAll('path')].flatMap(e => e.getAttribute('d').match(/-?[\\d.]+/g).map(Number))"
        for picture in range(self.browser.value("document.querySelectorAll('svg.turns').length")):
            self.browser.value(f"picture = document.querySelectorAll('svg.turns')[{picture}]; turn(picture, 0, 90)")
            above, turned = (self.browser.value(corners.format(f"picture.querySelector('{view}')"))
                             for view in ("g", ".front"))
            self.assertEqual(len(above), len(turned))
            self.assertTrue(all(near(a, b, 0.11) for a, b in zip(above, turned)), (picture, above, turned))


if __name__ == "__main__":
    unittest.main()
