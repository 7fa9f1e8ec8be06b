"""Bad input gives exit code 2, a message that names the place, nothing on stdout, and no new file."""

import copy
import json
import pathlib
import unittest

from program import *

TWO_BOXES = scene(body(box(1, 1, 1)), body(box(1, 1, 1), (3, 0, 0)))


def bytes_read():
    """By this process, and by those that it started and that have ended."""
    return int(pathlib.Path("/proc/self/io").read_text().split()[1])


class BadUsage(Test):
    def test_words_that_are_not_known(self):
        self.refused("reprot", says=["\"reprot\": unknown", "report"])
        self.refused("ask", "depth", "a.json", says=["depth", "distance", "penetration"])
        self.refused("list", "engines", says=["engines", "subjects", "properties", "clauses"])
        self.refused("report", "--colour", says="--colour")
        self.refused("check", "--effort", "huge", says=["huge", "quick", "standard", "soak"])
        self.refused("check", "--queries", "distanse", says=["distanse", "unknown", "distance"])
        self.refused("check", "--properties", "distance.valeu", says=["distance.valeu", "distance.value"])
        self.refused("check", "--subjects", "bullet.dubble", says=["bullet.dubble", "bullet.double", "reference"])
        self.refused("check", "--subjects", "inproc:bullet", says=["inproc:bullet", "inproc:reference"])
        self.refused("check", "--subjects", "exec:", says="exec:")
        self.refused("check", "--subjects", "exec:no_such_program_at_all", says="no_such_program_at_all")
        self.refused("check", "--queries", "mass", "--properties", "distance.value", says="--properties")

    def test_numbers_that_make_no_sense(self):
        for option, value in [("--cases", "0"), ("--cases", "-3"), ("--cases", "many"), ("--seed", "-1"), ("--jobs", "0"),
                              ("--time-limit", "0"), ("--time-limit", "-1"), ("--time-limit", "nan")]:
            self.refused("check", "--subjects", "inproc:fast", "--queries", "mass", option, value, says=option)

    def test_no_command_at_all(self):
        self.refused(says="Examples:")
        self.refused("replay", says="CASE")
        self.refused("ask", "distance", says="SCENE")

    def test_places_that_cannot_be_written(self):
        self.file("a_file", "mine")
        self.refused("report", "--cases", 1, "--out", "a_file", says="a_file")
        self.refused("check", "--cases", 1, "--json", "no/such/folder.json", says="no/such/folder.json")
        self.refused("check", "--cases", 1, "--junit", "no/such/folder.xml", says="no/such/folder.xml")
        self.refused("check", "--cases", 1, "--json", ".", says="a folder")
        self.assertEqual((self.folder / "a_file").read_text(), "mine")

    @unittest.skipIf(is_root(), "root may write everywhere")
    def test_a_folder_that_is_not_ours(self):
        (self.folder / "locked").mkdir(mode=0o500)
        self.refused("report", "--cases", 1, "--out", "locked/report", says="locked/report")

    def test_a_file_system_that_takes_nothing(self):
        self.refused("report", "--cases", 1, "--out", "/proc/touchstone", says="/proc/touchstone")

    def test_two_subjects_of_one_name(self):
        self.refused("check", "--cases", 1, "--subjects", f"{ENGINE} none", "--subjects", f"{ENGINE} none",
                     says="trickster")
        self.refused("check", "--cases", 1, "--subjects", "reference,inproc:reference", says="reference")

    def test_a_folder_of_meshes_that_holds_none(self):
        self.refused("check", "--cases", 1, "--meshes", "nowhere", says="nowhere")
        (self.folder / "empty").mkdir()
        self.refused("check", "--cases", 1, "--meshes", "empty", says="empty")
        (self.folder / "words").mkdir()
        self.file("words/words.obj", "to whom it may concern")
        self.refused("check", "--cases", 1, "--meshes", "words", says="words.obj")


class BadScene(Test):
    def refused_scene(self, content, says):
        self.file("scene.json", content)
        for query in ("distance", "mass"):
            self.assertIn("scene.json:", self.refused("ask", query, "scene.json", says=says))

    def spoilt(self, path, value, says, in_scene=TWO_BOXES):
        spoilt = copy.deepcopy(in_scene)
        holder = spoilt
        for key in path[:-1]:
            holder = holder[key]
        holder[path[-1]] = value
        self.refused_scene(spoilt, says)

    def test_no_scene_there(self):
        self.refused("ask", "distance", "no.json", says="no.json")
        self.refused("replay", "no.json", says="no.json")
        self.refused("minimise", "no.json", says="no.json")
        self.refused("ask", "distance", ".", says="touchstone: .: is a folder")
        self.refused("replay", ".", says=".: is a folder")

    def test_files_that_are_not_json(self):
        self.refused_scene("", "empty; expected JSON")
        self.refused_scene("{", "scene.json:1:")
        self.refused_scene(json.dumps(TWO_BOXES)[:-9], "scene.json:1:")
        self.refused_scene(json.dumps(TWO_BOXES) + "}", "scene.json:1:")
        self.refused_scene(b"\xff\xfe\x00", "UTF-16")
        self.refused_scene("[" * 100000, "scene.json:1:17: ")
        self.refused_scene("[]", "expected an object")
        self.refused_scene(json.dumps(TWO_BOXES).replace("[3,", "[NaN,"), "scene.json:1:")
        self.refused_scene(json.dumps(TWO_BOXES).replace("[3,", "[-Infinity,"), "scene.json:1:")
        self.refused_scene(json.dumps(TWO_BOXES).replace("[3,", "[1e999,"), "1e999")

    def test_keys_and_types(self):
        self.spoilt(["colour"], "red", 'unknown key "colour"')
        self.spoilt(["bodies", 1, "mas"], {"type": "density"}, ["bodies[1]", 'unknown key "mas"'])
        self.spoilt(["bodies"], 3, "bodies: expected an array, found 3")
        self.spoilt(["bodies", 0, "X_WB", "p", 1], "1", "bodies[0].X_WB.p[1]: expected a number, found a string")
        self.spoilt(["bodies", 0, "X_WB", "p", 1], None, "bodies[0].X_WB.p[1]")
        self.spoilt(["bodies", 0, "shape", "type"], "cone", ["bodies[0].shape", "cone"])
        self.spoilt(["touchstone"], "scene/2", "scene/2")

    def test_physics(self):
        self.spoilt(["bodies", 0, "X_WB", "q", "w"], 0, ["bodies[0].X_WB.q", "zero"])
        self.spoilt(["bodies", 1, "shape"], ball(0), "bodies[1].shape.radius")
        self.spoilt(["bodies", 1, "shape"], box(1, -1, 1), "bodies[1].shape.half_extents[1]")
        for e in (-0.1, 1.5):
            self.spoilt(["bodies", 0, "material"], {"restitution": e, "friction": 0}, "bodies[0].material.restitution")
        self.spoilt(["bodies", 0, "material"], {"restitution": 0, "friction": -1}, "bodies[0].material.friction")
        for density in (0, -2):
            self.spoilt(["bodies", 0, "mass"], {"type": "density", "density": density}, "bodies[0].mass.density")
        for mass in (0, -2):
            given = {"type": "given", "mass": mass, "p_BBcm": [0, 0, 0], "I_BBcm_B": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}
            self.spoilt(["bodies", 0, "mass"], given, "bodies[0].mass.mass")

    def test_polytopes(self):
        def refuse(vertices, faces, says):
            self.spoilt(["bodies", 1, "shape"], hull(vertices, faces), says)

        out = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
        self.file("right.json", scene(body(hull(TETRAHEDRON, out))))
        self.succeeds("ask", "mass", "right.json")
        refuse(TETRAHEDRON, [face[::-1] for face in out], ["bodies[1].shape.faces", "wound clockwise seen from outside"])
        refuse(TETRAHEDRON, out[:3], "bodies[1].shape.faces")
        refuse(TETRAHEDRON, [*out[:3], [1, 2, 4]], "bodies[1].shape.faces[3][2]")
        refuse(TETRAHEDRON[:3], None, "bodies[1].shape.vertices")
        refuse([*TETRAHEDRON[:3], [1, 1, 0], [5, 5, 0]], None, ["bodies[1].shape", "plane"])
        refuse([[0, 0, 0], [1, 1, 1], [2, 2, 2], [3, 3, 3]], None, "bodies[1].shape")
        refuse([*TETRAHEDRON, [1, 0, 0]], None, ["bodies[1].shape.vertices[4]", "equal"])
        refuse([*TETRAHEDRON, [0.1, 0.1, 0.1]], None, "bodies[1].shape.vertices[4]")

    def test_too_few_bodies(self):
        self.file("one.json", scene(body(ball(1))))
        for query in ("distance", "penetration"):
            self.refused("ask", query, "one.json", says=["one.json", "bodies"])

    def test_legal_however_odd(self):
        tiny = {"w": 5e-324, "x": 0, "y": 0, "z": 0}
        self.file("odd.json", scene(body(ball(5e-324), q=tiny), body(ball(1), (2, 0, 0), q={**NO_TURN, "w": 1e308})))
        self.assertIn("separated", self.succeeds("ask", "distance", "odd.json"))
        eighth_turn = {"w": 5e-324, "x": 0, "y": 0, "z": 5e-324}
        self.file("turned.json", scene(body(box(3, 1, 1), q=eighth_turn), body(box(1, 1, 1), (0, 5, 0))))
        self.assertEqual(json.loads(self.succeeds("ask", "distance", "turned.json", "--json"))["distance"], 1)


class BadMesh(Test):
    def test_what_is_no_mesh(self):
        self.refused("import", "no.obj", says="no.obj")
        (self.folder / "folder.obj").mkdir()
        self.refused("import", "folder.obj", says="folder.obj")
        for ending in ("obj", "off", "stl", "ply"):
            for content in (b"", b"hello world\n", bytes(range(256)) * 3):
                name = self.file("bad." + ending, content)
                self.refused("import", name, says=name)
                self.refused("import", name, "--out", "out.json", says=name)
        self.refused("import", self.file("robot.dae", "<COLLADA/>"), says=["robot.dae", ".stl"])
        self.refused("import", self.file("robot", "OFF"), says="robot")

    def test_meshes_without_volume(self):
        self.refused("import", self.file("few.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), says=["few.obj", "4"])
        flat = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n"
        self.refused("import", self.file("flat.obj", flat), says=["flat.obj", "plane"])
        self.refused("import", self.file("nan.obj", flat.replace("v 1 1 0", "v 1 1 nan")), says="nan.obj")

    def test_a_huge_mesh_is_refused_unread(self):
        for ending in ("obj", "off", "stl", "ply"):
            name = "huge." + ending
            with open(self.folder / name, "wb") as file:
                file.truncate(300_000_000)
            before = bytes_read()
            self.refused("import", name, says=[name, "300 MB"])
            self.assertLess(bytes_read() - before, 100_000_000)

    def test_out_cannot_be_written(self):
        mesh = self.file("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n")
        self.refused("import", mesh, "--out", "no/such/scene.json", says="no/such/scene.json")
        self.refused("import", mesh, "--out", ".", says=".")


class BadCase(Test):
    def test_cases(self):
        good = {"touchstone": "case/1", "property": "distance.value", "subject": "inproc:reference", "seed": 1, "index": 0,
                "finding": {"outcome": "holds", "defect": "none", "error": 0, "allowed": 0}, "scene": TWO_BOXES}
        self.assertIn("holds", self.succeeds("replay", self.file("good.json", good)))
        for change, says in [({"property": "distance.valeu"}, "distance.value"), ({"subject": ""}, "--subject"),
                             ({"subject": "bullet.dubble"}, "bullet.double"), ({"seed": -1}, "seed"),
                             ({"touchstone": "case/9"}, "case/9"), ({"colour": "red"}, "colour"),
                             ({"finding": {"outcome": "perhaps"}}, "finding"), ({"scene": {}}, "scene")]:
            for command in ("replay", "minimise"):
                self.refused(command, self.file("bad.json", {**good, **change}), says=says)
        self.refused("replay", self.file("scene.json", TWO_BOXES), says="scene.json")


if __name__ == "__main__":
    unittest.main()
