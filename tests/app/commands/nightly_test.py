"""docs/examples/nightly.sh: two nights of an engine that becomes worse."""

import json
import os
import shutil
import subprocess
import unittest

from program import *

NIGHTLY = SOURCE / "docs/examples/nightly.sh"


# A night of a test is short.
FEW = f"""#!/bin/bash
[[ $1 != report ]] || set -- "$@" --cases 200 --skip-self-test
exec "{PROGRAM}" "$@"
"""


class Nightly(Test):
    def night(self, subject, code):
        few = self.folder / "few"
        few.write_text(FEW)
        few.chmod(0o755)
        done = subprocess.run([NIGHTLY, subject, "nights", "1"], cwd=self.folder, capture_output=True, text=True,
                              timeout=300, env={**os.environ, "TOUCHSTONE": few, "EFFORT": "quick"})
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        page = self.folder / done.stdout.strip()
        return page.parent, page.read_text()

    def test_two_nights(self):
        folder, page = self.night(altered("1"), 0)
        self.assertIn("the first night", page)
        self.assertRegex(page, r"\| `mine` \S+ \| .*8 of 8 \|")
        before = folder.with_name("2000-01-01")
        shutil.move(folder, before)
        folder, page = self.night(altered("1.000001"), 1)
        self.assertRegex(page, r"  new +distance\.value\n")
        self.assertIn("distance.value: too_far", page)
        vectors = json.loads((self.folder / "nights/vectors/distance.json").read_text())["tests"]
        self.assertIn("too_far", {test["source"].get("defect") for test in vectors})


if __name__ == "__main__":
    unittest.main()
