"""The tables of README.md and of docs/reports/engines are those of the published report."""

import json
import lzma
import re
import unittest

from browser import folder_and_browser
from program import *

PUBLISHED = SOURCE / "docs/reports/engines"


class Published(Test):
    def setUp(self):
        super().setUp()
        self.file("report.json", lzma.decompress((PUBLISHED / "report.json.xz").read_bytes()))

    def table(self, *words):
        return self.succeeds("summary", "report.json", *words).split("\n\n")[0]

    def test_the_table_of_all(self):
        self.assertIn("\n\n" + self.table() + "\n\n", (PUBLISHED / "README.md").read_text())

    def test_the_table_of_the_readme(self):
        readme = (SOURCE / "README.md").read_text()
        table = next(block for block in readme.split("\n\n") if block.startswith("| properties that hold;"))
        subjects = re.findall(r"(?m)^\| `([\w.]+)` ", table)
        self.assertGreaterEqual(len(subjects), 14)
        self.assertEqual(table, self.table("--subjects", ",".join(subjects)))

    def test_the_page_is_of_the_same_run(self):
        page = lzma.decompress((PUBLISHED / "index.html.xz").read_bytes()).decode()
        self.assertLess(len(page), 8_000_000)
        for subject in self.json("report.json")["subjects"]:
            self.assertIn(f">{subject['name']}<", page)

    def test_the_page_opens_on_phone_and_desk(self):
        folder, browser = folder_and_browser(type(self))
        page = folder / "index.html"
        page.write_bytes(lzma.decompress((PUBLISHED / "index.html.xz").read_bytes()))
        for width in (400, 1400):
            for dark in (False, True):
                browser.open(page.as_uri(), width, dark=dark)
                self.assertEqual(browser.complaints(), [])
                self.assertLessEqual(browser.value("document.documentElement.scrollWidth"), width)
                seconds = browser.value("performance.getEntriesByType('navigation')[0].loadEventEnd / 1000")
                print(f"{page.stat().st_size / 1e6:.2f} MB from disk at {width} px: loaded after {seconds:.2f} s")


if __name__ == "__main__":
    unittest.main()
