"""The commands of the how-to for one's own engine print what the page says."""

import re
import subprocess
import unittest

from program import *

PAGE = SOURCE / "docs/how_to/add_a_subject.md"


def commands_and_output():
    section = PAGE.read_text().split("\n## A program of your own\n")[1].split("\n## ")[0]
    return re.findall(r"```sh\n(.*?)```\n\n```\n(.*?)```\n", section, re.DOTALL)


class HowTo(Test):
    def test_each_command_prints_what_the_page_says(self):
        shown = commands_and_output()
        self.assertEqual(len(shown), 2)
        for command, output in shown:
            done = subprocess.run(["bash", "-e", "-c", command.replace("./touchstone ", f"'{PROGRAM}' ")], cwd=SOURCE,
                                  capture_output=True, text=True, timeout=300)
            self.assertEqual((done.returncode, done.stderr), (0, ""), command + done.stdout)
            pattern = ".*\n".join(re.escape(part) for part in output.split(" …\n"))  # … stands for omitted lines
            self.assertRegex(done.stdout, re.compile(rf"\A{pattern}\Z", re.DOTALL), command)


if __name__ == "__main__":
    unittest.main()
