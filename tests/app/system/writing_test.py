"""Output that cannot be written: a full disk, a closed stdout or one without a reader, names that no file can have."""

import os
import resource
import subprocess
import unittest

from program import *

PAIR = scene(body(ball(1)), body(ball(1), (3, 0, 0)))
RIGHT = {"touchstone": "case/1", "property": "distance.value", "subject": "inproc:reference", "seed": 1, "index": 0,
         "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}, "scene": PAIR}
TRIAL = ["--subjects", "inproc:fast", "--properties", "mass.mass", "--cases", 2, "--jobs", 1]
COMMANDS = {
    "ask": ["ask", "distance", "pair.json"],
    "ask --json": ["ask", "mass", "pair.json", "--json"],
    "check": ["check", *TRIAL],
    "--help": ["--help"],
    "ask --help": ["ask", "--help"],
    "import": ["import", "mesh.obj"],
    "import --out": ["import", "mesh.obj", "--out", "made.json"],
    "list": ["list", "properties"],
    "list motions": ["list", "motions"],
    "minimise": ["minimise", "case.json"],
    "plan": ["plan", "pool_break"],
    "plan --json": ["plan", "pool_break", "--json"],
    "replay": ["replay", "case.json"],
    "report": ["report", *TRIAL, "--meshes", "meshes", "--out", "R"],
    "simulate": ["simulate", "bouncing_ball", "--engine", "inproc:fast"],
    "soak": ["soak", "--pairs", 1, "--jobs", 1],
    "--version": ["--version"],
}


class Writing(Test):
    def setUp(self):
        super().setUp()
        self.file("pair.json", PAIR)
        self.file("case.json", RIGHT)
        self.file("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n")
        write_meshes(self.folder / "meshes")

    def run_into(self, stdout, words, **options):
        return subprocess.run([PROGRAM, *as_asked(words)], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=stdout,
                              stderr=subprocess.PIPE, text=True, timeout=300, **options)


class Stdout(Writing):
    def test_a_full_disk(self):
        for name, words in COMMANDS.items():
            with self.subTest(name), open("/dev/full", "w") as full:
                done = self.run_into(full, words)
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertIn("touchstone: stdout: cannot write: No space left on device", done.stderr)
                self.assertNotIn("our own fault", done.stderr)

    def test_closed(self):
        for name, words in COMMANDS.items():
            with self.subTest(name):
                done = self.run_into(None, words, preexec_fn=lambda: os.close(1))
                self.assertEqual((done.returncode, done.stderr),
                                 (3, "touchstone: stdout: is closed: there is no place for the answer\n"))

    def test_no_file_takes_the_place_of_a_closed_stderr(self):
        def close():
            os.close(0)
            os.close(2)

        self.file("bad.json", "{")
        done = subprocess.run([PROGRAM, *as_asked(["check", *TRIAL, "--json", "r.json", "--meshes", "none"])], cwd=self.folder,
                              stdout=subprocess.PIPE, timeout=300, preexec_fn=close)
        self.assertEqual(done.returncode, 2)
        done = subprocess.run([PROGRAM, "import", "mesh.obj", "--out", "made.json"], cwd=self.folder, stdout=subprocess.PIPE,
                              timeout=300, preexec_fn=close)
        self.assertEqual(done.returncode, 0)
        self.json("made.json")

    def test_nothing_reads_it(self):
        """As in `touchstone … | head -1`: the program ends quietly, and the files are complete."""
        for name, words in COMMANDS.items():
            with self.subTest(name):
                reads, writes = os.pipe()
                os.close(reads)
                done = self.run_into(writes, words)
                os.close(writes)
                self.assertEqual((done.returncode, done.stderr), (141, ""))
        self.json("R/report.json")
        self.json("made.json")


class Files(Writing):
    def test_a_device_that_is_full(self):
        for words in (["check", *TRIAL, "--json", "/dev/full"], ["check", *TRIAL, "--junit", "/dev/full"],
                      ["import", "mesh.obj", "--out", "/dev/full"],
                      ["simulate", "bouncing_ball", "--engine", "inproc:fast", "--out", "/dev/full"]):
            with self.subTest(words):
                done = self.run_into(subprocess.PIPE, words)
                self.assertEqual((done.returncode, done.stderr),
                                 (3, "touchstone: /dev/full: cannot write: No space left on device\n"))

    def test_a_disk_that_gets_full_leaves_the_old_file(self):
        self.file("old.json", "old")
        (self.folder / "R/cases").mkdir(parents=True)
        for words in (["check", *TRIAL, "--json", "old.json"], ["import", "mesh.obj", "--out", "old.json"],
                      ["simulate", "bouncing_ball", "--engine", "inproc:fast", "--replay", "old.json"],
                      ["simulate", "bouncing_ball", "--engine", "inproc:fast", "--out", "old.json"],
                      ["report", *TRIAL, "--meshes", "meshes", "--out", "R"]):
            before = self.files()
            with self.subTest(words):
                done = self.run_into(subprocess.PIPE, words,
                                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
                if "three.js" in done.stderr:
                    self.skipTest("no library for replay pages here")
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertIn("cannot write: File too large", done.stderr)
                self.assertEqual((self.folder / "old.json").read_text(), "old")
                self.assertEqual(self.files(), before)


class Names(Writing):
    def test_an_empty_word_is_no_name(self):
        for words in (["report", *TRIAL, "--out", ""], ["check", *TRIAL, "--out", ""], ["check", *TRIAL, "--json", ""],
                      ["check", *TRIAL, "--junit", ""], ["check", *TRIAL, "--meshes", ""], ["check", "--subjects", ""],
                      ["import", "mesh.obj", "--out", ""], ["minimise", "case.json", "--out", ""],
                      ["simulate", "bouncing_ball", "--out", ""], ["simulate", "bouncing_ball", "--replay", ""],
                      ["simulate", "bouncing_ball", "--engine", ""], ["simulate", ""], ["ask", "distance", ""],
                      ["bench", "broad_phase", "--out", ""], ["replay", ""], ["replay", "case.json", "--subject", ""]):
            self.refused(*words, says="is empty")

    def cases_of(self, *names):
        subjects = [word for name in names for word in ("--subjects", f"{ENGINE} none \"{name}\"")]
        self.succeeds("report", *subjects, "--properties", "distance.value", "--cases", 3, "--meshes", "meshes", "--out", "R")
        rows = self.json("R/report.json")["rows"]
        self.assertEqual([row["subject"] for row in rows], list(names))
        files = [row["case"] for row in rows]
        self.assertEqual(len({file.lower() for file in files}), len(names), files)
        self.assertEqual(sorted(files), sorted(str(p.relative_to(self.folder / "R")) for p in (self.folder / "R/cases").iterdir()))
        for name, file in zip(names, files):
            self.assertIn(name, self.json(f"R/{file}")["subject"])
        return files

    def test_a_name_that_is_too_long_for_a_file(self):
        long = "x" * 300
        self.cases_of(long, long + "y")

    def test_names_that_fold_to_one(self):
        self.cases_of("a/b", "a_b", "A_B", "a_b-2", "a b")


if __name__ == "__main__":
    unittest.main()
