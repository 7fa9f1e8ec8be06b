"""report --shard and merge: the report of all shards is that of one run, byte for byte, and a lost one is named."""

import json
import shutil
import subprocess
import unittest

from program import *

SUBJECTS = ["--subjects", "fast", "--subjects", altered("1.5"), "--subjects", f"{ENGINE} always_hangs trickster /dev/null"]
PROPERTIES = "mass.mass,distance.value,distance.survives,distance.repeats"
RUN = [*SUBJECTS, "--properties", PROPERTIES, "--cases", 60, "--time-limit", "0.2", "--meshes", "meshes"]


class Shards(Test):
    def setUp(self):
        super().setUp()
        write_meshes(self.folder / "meshes")

    def shard(self, word, *words):
        return self.succeeds("report", *RUN, *words, "--shard", word, "--out", "shards")

    def all_shards(self, of):
        for number in range(1, of + 1):
            said = self.shard(f"{number}/{of}", "--jobs", number)
            self.assertRegex(said, rf"^shards/shard-{number}-of-{of}.jsonl: \d+ units\n$")

    def files_of(self, folder):
        return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}

    def test_the_report_of_all_shards_is_that_of_one_run(self):
        self.succeeds("report", *RUN, "--out", "report")
        whole = self.files_of(self.folder / "report")
        shutil.rmtree(self.folder / "report")
        self.all_shards(3)
        self.assertEqual(self.succeeds("merge", "shards").splitlines()[-1], "report/index.html")
        merged = self.files_of(self.folder / "report")
        self.assertEqual(without_times(merged), without_times(whole))
        # Shards carry their times in files of their own: as many questions were timed.
        timed = [{(entry["query"], entry["subject"]): entry["questions"] for entry in json.loads(files["report.timing.json"])["times"]}
                 for files in (merged, whole)]
        self.assertEqual(timed[0], timed[1])
        self.assertIn(("distance", "fast"), timed[0])

        # Times are no result: without them the report is the same.
        for file in (self.folder / "shards").glob("*.timing.json"):
            file.unlink()
        self.succeeds("merge", "shards")
        self.assertEqual(without_times(self.files_of(self.folder / "report")), without_times(whole))
        self.assertEqual(self.json("report/report.timing.json")["times"], [])
        rows = json.loads(whole["report.json"])["rows"]
        self.assertIn("hung", {defect for row in rows for defect in row.get("defects", {})})
        self.assertIn("too_far", {defect for row in rows for defect in row.get("defects", {})})

    def test_a_lost_shard_is_named_and_can_be_run_again(self):
        self.all_shards(3)
        lost = self.folder / "shards/shard-2-of-3.jsonl"
        text = lost.read_text()
        lost.unlink()
        said = self.refused("merge", "shards", says="shard 2 of 3 is missing; to run it: ")
        command = said.split("to run it: touchstone ")[1].strip()
        done = subprocess.run(f"{PROGRAM} {command} --skip-adapter-check", shell=True, cwd=self.folder,
                              capture_output=True, text=True, timeout=300)
        self.assertEqual((done.returncode, lost.read_text()), (0, text), done.stderr)

    def test_damaged_and_foreign_shards(self):
        self.all_shards(2)
        file = self.folder / "shards/shard-2-of-2.jsonl"
        text = file.read_text()
        lines = text.splitlines(keepends=True)
        unit = json.loads(lines[1])
        for content, says in [
            ("".join(lines[:-1]), "shard-2-of-2.jsonl: is cut off"),
            (text[:-200], "shard-2-of-2.jsonl:"),
            (text.replace('"seed":1', '"seed":2', 1), "is of another run"),
            (text.replace('"versions":["', '"versions":["old ', 1), "was asked of other versions"),
            (text.replace('"touchstone":"shard/3"', '"touchstone":"shard/1"'), 'expected "shard/3"'),
            (lines[0] + "".join(lines[2:]), f"unit {unit['unit']}: is in no shard"),
            ("".join(lines[:2]) + "".join(lines[1:]), "or is there twice"),
            (text.replace('"property":"distance.value"', '"property":"distance.worth"', 1), "is no property of distance"),
        ]:
            file.write_text(content)
            self.assertIn(says, self.run_program("merge", "shards").stderr)
        file.write_text(text)
        times = self.folder / "shards/shard-2-of-2.timing.json"
        for content, says in [("{", "timing.json"), (times.read_text().replace("-timing/1", "-timing/9"), 'expected "shard-timing/1"'),
                              (times.read_text().replace('"answers":[', '"answers":[[],'), "are of other subjects")]:
            kept = times.read_text()
            times.write_text(content)
            self.assertIn(says, self.run_program("merge", "shards").stderr)
            times.write_text(kept)
        (self.folder / "shards/shard-1-of-3.jsonl").write_text(text)
        self.refused("merge", "shards", says="there is another shard")

    def test_bad_words(self):
        for word in ["0/3", "4/3", "3", "a/b", "1/", "1/2/3"]:
            self.refused("report", *RUN, "--shard", word, says=f'expected NUMBER/OF as 3/8, found "{word}"')
        self.refused("merge", "absent", says="absent: is no folder")
        (self.folder / "empty").mkdir()
        self.refused("merge", "empty", says="has no file shard-NUMBER-of-OF.jsonl")
        self.refused("report", *RUN, "--shard", "1/2", "--json", "a.json", says="--json")


if __name__ == "__main__":
    unittest.main()
