"""The pages have no violation that axe-core finds, at 400 and 1400 px, light and dark, with all that can be opened
open. axe-core is the file that TOUCHSTONE_AXE names, or the one below node_modules beside this file (`npm ci` there makes
it). Without it, says so and exits with code 77, which CTest reports as skipped."""

import lzma
import os
import pathlib
import sys
import unittest

from browser import folder_and_browser
from program import *

SKIPPED = 77
HERE = pathlib.Path(__file__).resolve().parent
AXE = pathlib.Path(os.environ.get("TOUCHSTONE_AXE", HERE / "node_modules/axe-core/axe.min.js"))
VIOLATIONS = """axe.run().then(found => found.violations.map(v =>
    `${v.impact} ${v.id}: ${v.help}, ${v.nodes.length} times: ${v.nodes[0].html.slice(0, 200)}`))"""


class Accessibility(Test):
    @classmethod
    def setUpClass(cls):
        cls.runs, cls.browser = folder_and_browser(cls, webgl=True)

    def make(self, *words):
        subprocess.run([PROGRAM, *as_asked(words)], cwd=self.runs, check=True, capture_output=True)

    def violations(self, page, width, dark):
        self.browser.open((self.runs / page).as_uri(), width, dark=dark)
        self.browser.value("document.querySelectorAll('details').forEach(e => { e.open = true })")
        self.browser.value(AXE.read_text() + "; 0")
        return self.browser.value(VIOLATIONS)

    def has_none(self, page, looks=((400, False), (400, True), (1400, False), (1400, True))):
        for width, dark in looks:
            with self.subTest(page=page, width=width, dark=dark):
                self.assertEqual(self.violations(page, width, dark), [])

    def test_report(self):
        self.make("report", "--cases", "10", "--queries", "mass,distance,impulse", "--out", "R", "--subjects",
                  "fast,bullet.float,bullet.impulse")
        self.has_none("R/index.html")

    def test_replay(self):
        self.make("simulate", "bouncing_ball", "--beside", "constraint", "--replay", "replay.html")
        self.has_none("replay.html")

    def test_the_published_report(self):
        published = HERE.parents[2] / "docs/reports/engines/index.html.xz"
        (self.runs / "published.html").write_bytes(lzma.decompress(published.read_bytes()))
        # Minutes each: it shows some 400 findings.
        self.has_none("published.html", looks=((400, False), (1400, True)))

    def test_a_bad_page_is_seen(self):
        (self.runs / "bad.html").write_text("<!doctype html><title>x</title><img src='data:,'><button></button>")
        found = " ".join(self.violations("bad.html", 400, False))
        for violation in ("image-alt", "button-name", "html-has-lang"):
            self.assertIn(violation, found)


if __name__ == "__main__":
    if not AXE.exists():
        print(f"Skipped: there is no {AXE}; npm ci --prefix {HERE} installs it")
        sys.exit(SKIPPED)
    unittest.main()
