"""No text from outside reaches a terminal unescaped: no control characters, no change of the writing direction."""

import os
import re
import unittest
import xml.etree.ElementTree

from program import *

EVIL = "evil\x1b[31m\x07\r\x9b2J\u202e\u200b\ntouchstone: forged"
HARMFUL = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff]")
RIGHT = {"touchstone": "case/1", "property": "distance.value", "subject": "inproc:reference", "seed": 1, "index": 0,
         "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}}


class Terminal(Test):
    def harmless(self, *words, code):
        """Runs the command. Its output is printable UTF-8, no line is forged, and the name is still visible."""
        done = subprocess.run([PROGRAM, *as_asked(words)], cwd=self.folder,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=300)
        printed = done.stdout + done.stderr
        self.assertEqual(done.returncode, code, printed)
        text = printed.decode()
        self.assertIsNone(HARMFUL.search(text), repr(text))
        self.assertNotRegex(text, "(?m)^touchstone: forged")
        return text

    def shows_evil(self, *words, code):
        self.assertIn("evil\\u001b[31m", self.harmless(*words, code=code))

    def named_scene(self, bodies=3, **rest):
        return {**scene(*[body(ball(1), (3 * k, 0, 0), name=EVIL) for k in range(bodies)]), "name": EVIL, **rest}

    def test_all_printing_goes_through_one_place(self):
        """app/system/terminal.h escapes text from outside, and notices a stdout that accepts no more."""
        prints = re.compile(r"fmt::print\(|std::(cout|cerr|puts|fputs|printf|fprintf|fwrite)\b|\bperror\(")
        found = [path.name for path in (SOURCE / "app").rglob("*.cpp") if prints.search(path.read_text())]
        self.assertEqual(sorted(found), ["progress.cpp", "terminal.cpp"])

    def test_words_on_the_command_line(self):
        for words in ([EVIL], ["ask", EVIL, "a.json"], ["list", EVIL], ["check", "--queries", EVIL],
                      ["check", "--subjects", EVIL], ["check", "--properties", EVIL], ["check", "--effort", EVIL],
                      ["check", "--" + EVIL], ["check", "--cases", EVIL], ["check", "--seed", EVIL], ["check", "--jobs", EVIL],
                      ["check", "--subjects", "exec:" + EVIL.replace("\n", " ")], ["check", "--time-limit", EVIL],
                      ["simulate", EVIL], ["simulate", "bouncing_ball", "--engine", EVIL],
                      ["simulate", "bouncing_ball", "--until", EVIL], ["bench", EVIL], ["bench", "distance", "--sizes", EVIL],
                      ["ask", "mass", "a.json", EVIL]):
            with self.subTest(words):
                self.shows_evil(*words, code=2)

    def test_bytes_that_are_no_text(self):
        for words in (["replay", b"\xff\xc0.json"], ["ask", "mass", b"\xff.json"], [b"\xff"], ["check", b"--\xff"],
                      ["import", b"\xff.obj"], ["check", "--subjects", b"\xff"]):
            with self.subTest(words):
                self.assertIn("\\xff", self.harmless(*words, code=2))

    def test_names_of_files(self):
        name = EVIL.replace("/", "")
        for command in (["ask", "mass"], ["replay"], ["minimise"], ["plan"], ["simulate"], ["import"]):
            with self.subTest(command):
                self.shows_evil(*command, name, code=2)
        self.file(name + ".json", "{")
        self.shows_evil("ask", "mass", name + ".json", code=2)
        self.file(name + ".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n")
        self.shows_evil("import", name + ".obj", code=0)
        self.shows_evil("import", name + ".obj", "--out", name, code=0)
        self.shows_evil("check", "--subjects", "inproc:fast", "--properties", "mass.mass", "--cases", 1, "--json",
                        name + "/no/r.json", code=2)
        (self.folder / "meshes").mkdir()
        self.file("meshes/" + name + ".obj", "no mesh")
        self.shows_evil("check", "--cases", 1, "--meshes", "meshes", code=2)

    def test_scenes(self):
        two = scene(body(ball(1)), body(ball(1), (3, 0, 0)))
        self.file("key.json", {**two, EVIL: 1})
        self.file("type.json", scene(body({"type": EVIL})))
        self.file("named.json", self.named_scene())
        self.file("flies.json", self.named_scene(motion={"sample_times": [0.5]}))
        self.file("twice.json", '{"' + "\x7f\u202e" + '": 1, "' + "\x7f\u202e" + '": 2}')
        self.shows_evil("ask", "mass", "key.json", code=2)
        self.harmless("ask", "mass", "type.json", code=2)
        self.harmless("ask", "mass", "twice.json", code=2)
        self.shows_evil("ask", "distance", "named.json", code=0)
        self.shows_evil("ask", "distance", "named.json", "--json", code=0)
        self.shows_evil("plan", "named.json", "--json", code=0)
        self.shows_evil("simulate", "flies.json", "--engine", "inproc:fast", code=0)

    def test_json_stays_the_same(self):
        self.file("named.json", self.named_scene())
        self.assertEqual(json.loads(self.succeeds("plan", "named.json", "--json"))["scene"], EVIL)

    def test_cases(self):
        hostile = {**RIGHT, "scene": self.named_scene(), "note": EVIL, "family": EVIL}
        self.file("case.json", hostile)
        self.shows_evil("replay", "case.json", code=0)
        self.harmless("replay", "case.json", "--json", code=0)
        for change in ({"property": EVIL}, {"touchstone": EVIL}, {EVIL: 1}):
            self.file("bad.json", {**hostile, **change})
            self.shows_evil("replay", "bad.json", code=2)

    def test_what_an_engine_says(self):
        engine = self.folder / "engine.py"
        engine.write_text(f"""
import json, sys
evil = {EVIL!r}
for line in sys.stdin:
    seq = json.loads(line)["seq"]
    card = {{"name": evil, "version": evil, "precision": "binary64", "answers": ["distance", "simulation"], "about": evil,
            "deviations": [{{"what": evil, "clause": evil, "link": evil}}]}}
    says = {{"protocol": 1, "card": card}} if seq == 1 else {{"breaks": {{"kind": "threw", "how": evil}}}}
    if seq > 1 and "abstains" in sys.argv:
        says = {{"abstains": evil}}
    if seq == 1 and "mute" in sys.argv:
        says = {{evil: 1}}
    print(json.dumps({{"seq": seq, **says}}), flush=True)
""")
        subject = f"exec:/usr/bin/python3 {engine}"
        self.file("case.json", {**RIGHT, "scene": self.named_scene(bodies=2)})
        self.file("flies.json", self.named_scene(motion={"sample_times": [0.5]}))
        asked = ["--properties", "distance.value", "--cases", 1, "--jobs", 1]
        self.shows_evil("check", "--subjects", subject, *asked, code=1)
        self.shows_evil("check", "--subjects", subject + " abstains", *asked, "--junit", "a.xml", code=0)
        self.shows_evil("check", "--subjects", subject + " mute", *asked, code=2)
        self.shows_evil("check", "--subjects", subject, "--subjects", subject, *asked, code=2)
        self.shows_evil("replay", "case.json", "--subject", subject, code=1)
        self.harmless("minimise", "case.json", "--subject", subject + " abstains", code=1)
        self.shows_evil("simulate", "flies.json", "--engine", subject, code=1)
        self.shows_evil("simulate", "flies.json", "--engine", subject + " abstains", code=2)
        self.shows_evil("check", "--subjects", subject, *asked, "--out", "R", "--junit", "b.xml", code=1)
        for file in ("a.xml", "b.xml", "R/junit.xml"):
            told = (self.folder / file).read_bytes().decode()
            self.assertIsNone(re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f\ufffe\uffff]", told), repr(told))
            xml.etree.ElementTree.parse(self.folder / file)
        page = (self.folder / "R/index.html").read_text()
        self.assertIsNone(HARMFUL.search(page))


if __name__ == "__main__":
    unittest.main()
