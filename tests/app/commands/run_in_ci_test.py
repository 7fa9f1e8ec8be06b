"""The workflow of docs/how_to/run_in_ci.md, step by step, on a few scenes and with a build as its cache has it."""

import os
import re
import subprocess
import textwrap
import unittest

from program import *

PAGE = (SOURCE / "docs/how_to/run_in_ci.md").read_text()
[WORKFLOW] = re.findall(r"```yaml\n(# \.github/.*?)```\n", PAGE, re.DOTALL)
FEW = "--properties distance.value --cases 4 --skip-adapter-check"  # the engine is wrong on purpose


def scripts():
    """The text after each `run:`, by the name of its step: on the same line, or as an indented block."""
    steps = re.findall(r"(?m)^ +- name: (.*)\n((?:(?! +- ).*\n)*)", WORKFLOW)
    runs = {name: re.search(r"(?m)^ +run: (?:\|\n((?: {10}.*\n)+)|(.*)\n)", body) for name, body in steps}
    return {name: textwrap.dedent(run[1] or run[2]) for name, run in runs.items() if run}


def environment():
    return dict(re.findall(r"(?m)^  ([A-Z_]+): (.*)$", WORKFLOW))


class Workflow(Test):
    def setUp(self):
        super().setUp()
        (self.folder / "tools").mkdir()
        self.script("tools/apt-get", "")
        (self.folder / "touchstone").mkdir()
        self.script("touchstone/touchstone", f'exec {PROGRAM} "$@"')
        self.file("my_engine.py", (SOURCE / "tests/app/altered.py").read_text())

    def script(self, name, body):
        path = self.folder / self.file(name, f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)

    def run_step(self, script, factor):
        env = os.environ | environment() | {"SUBJECT": f"exec:/usr/bin/python3 my_engine.py {factor}", "SCENES": FEW,
                                            "PATH": f"{self.folder / 'tools'}:{os.environ['PATH']}"}
        return subprocess.run(["bash", "-e", "-c", script], cwd=self.folder, env=env, capture_output=True, text=True, timeout=300)

    def run_workflow(self, factor):
        codes = {}
        for name, script in scripts().items():
            done = self.run_step(script, factor)
            codes[name] = done.returncode
            if done.returncode != 0:
                break
        return codes

    def test_each_step(self):
        [first] = re.findall(r"```sh\n(\./touchstone check .*--write-baseline .*\n(?: .*\n)*)```", PAGE)
        done = self.run_step(first.replace("./touchstone ", "touchstone/touchstone "), 1.5)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(self.json("touchstone-baseline.json")["failures"]), 1)
        names = list(scripts())
        self.assertEqual(len(names), WORKFLOW.count(" run:"))
        self.assertEqual(self.run_workflow(1.5), dict.fromkeys(names, 0))
        for file in re.findall(r"(?m)^ +(?:path|sarif_file): (.*)$", WORKFLOW):
            self.assertTrue((self.folder / file).exists(), file)
        self.assertEqual(list(self.run_workflow(0.5).values())[-1], 1)


if __name__ == "__main__":
    unittest.main()
