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
        subprocess.run([PROGRAM, "report", "--cases", "10", "--meshes", "meshes", "--queries", "mass,distance,penetration",
                        "--out", "R", "--subjects", "reference,fast,bullet.float,fcl.indep,libccd.gjk"], cwd=cls.runs, check=True, capture_output=True)
        cls.page = (cls.runs / "R/index.html").as_uri()

    def test_phone_and_desk_in_light_and_dark(self):
        for width in (390, 1300):
            for dark in (False, True):
                with self.subTest(width=width, dark=dark):
                    self.browser.open(self.page, width, dark=dark)
                    self.assertEqual(self.browser.complaints(), [])
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
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

    def test_pictures_are_drawn(self):
        self.browser.open(self.page, 1300)
        self.assertGreater(self.browser.value("document.querySelectorAll('svg').length"), 0)
        self.assertEqual(self.browser.value("[...document.querySelectorAll('svg *')].filter(e => [...e.attributes]"
                                            ".some(a => /nan|inf/i.test(a.value))).length"), 0)


if __name__ == "__main__":
    unittest.main()
