"""Runs the built program as a process with arguments, files, an exit code and two streams."""

import json
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["TOUCHSTONE_PROGRAM"]
SOURCE = pathlib.Path(os.environ["TOUCHSTONE_SOURCE"])
MISBEHAVING = os.environ["TOUCHSTONE_MISBEHAVING"]
CANARY = os.environ["TOUCHSTONE_CANARY"]
ENGINE = f"exec:/usr/bin/python3 {SOURCE / 'tests/app/engine.py'}"


def altered(factor):
    """A subject named mine: its distances are those of fast times the factor."""
    return f"exec:/usr/bin/python3 {SOURCE / 'tests/app/altered.py'} {factor}"


NO_TURN = {"w": 1, "x": 0, "y": 0, "z": 0}
TETRAHEDRON = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]


def body(shape, p=(0, 0, 0), q=None, **rest):
    return {"shape": shape, "X_WB": {"p": list(p), "q": q or NO_TURN}, **rest}


def box(x, y, z):
    return {"type": "box", "half_extents": [x, y, z]}


def ball(radius):
    return {"type": "sphere", "radius": radius}


def hull(vertices, faces=None):
    return {"type": "polytope", "vertices": vertices, **({"faces": faces} if faces else {})}


def scene(*bodies):
    return {"touchstone": "scene/1", "bodies": list(bodies)}


def write_meshes(folder):
    """Two solids and one flat mesh: real meshes for a run that has no time for many."""
    folder.mkdir()
    for name, height in [("low", 1), ("high", 5), ("flat", 0)]:
        (folder / f"{name}.obj").write_text(f"v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 1 1 {height}\nf 1 2 3 4\nf 1 2 5\n")


def as_asked(words):
    """The words of a command. Most engines of tests are wrong on purpose, so their adapters do not pass. The judge's own
    answers have tests of their own."""
    words = [word if isinstance(word, bytes) else str(word) for word in words]
    if words[:1] in (["check"], ["report"]):
        words.append("--skip-self-test")
        if any(str(word).startswith("exec:") for word in words):
            words.append("--skip-adapter-check")
    return words


def without_times(files):
    """A report's files as bytes by name, without what differs from run to run: report.timing.json, and the page's section
    on speed."""
    speed = re.compile(rb'<section aria-labelledby="speed">.*?(?=<section aria-labelledby="atlas">)', re.DOTALL)
    page = files["index.html"]
    assert len(speed.findall(page)) == 1
    return {name: speed.sub(b"", content) if name == "index.html" else content
            for name, content in files.items() if name != "report.timing.json"}


class Test(unittest.TestCase):
    """Each test runs in an empty folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="touchstone_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *words, **options):
        return subprocess.run([PROGRAM, *as_asked(words)], cwd=self.folder, capture_output=True, text=True, timeout=300,
                              stdin=subprocess.DEVNULL, **options)

    def succeeds(self, *words, code=0):
        done = self.run_program(*words)
        self.assertEqual(done.returncode, code, f"{words}\n{done.stdout}{done.stderr}")
        return done.stdout

    def refused(self, *words, says):
        """Requires exit code 2, the reason on stderr, nothing on stdout, and no new file."""
        before = self.files()
        done = self.run_program(*words)
        self.assertEqual((done.returncode, done.stdout), (2, ""), f"{words}\n{done.stderr}")
        for text in [says] if isinstance(says, str) else says:
            self.assertIn(text, done.stderr, words)
        self.assertEqual(self.files(), before, words)
        return done.stderr

    def files(self):
        return sorted(p for p in self.folder.rglob("*") if p.is_file())

    def file(self, name, content):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content))
        return name

    def json(self, name):
        return json.loads((self.folder / name).read_text())


def is_root():
    return os.geteuid() == 0


def near(a, b, allowed):
    return math.isclose(a, b, rel_tol=0, abs_tol=allowed)
