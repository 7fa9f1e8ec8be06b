"""The command ask: scenes whose truth is computed by hand."""

import json
import re
import struct
import unittest

from program import *

ROOT = pathlib.Path(SOURCE)


class Ask(Test):
    def ask(self, query, *bodies):
        self.file("scene.json", scene(*bodies))
        return json.loads(self.succeeds("ask", query, "scene.json", "--json"))

    def words(self, query):
        """Parses the plain text: each line is a label and a value."""
        lines = self.succeeds("ask", query, "scene.json").splitlines()
        return {line.split()[0]: line.split(None, 1)[-1] for line in lines}

    def test_distance_of_two_boxes_corner_to_corner(self):
        # Corners (1, 1, 1) and (2, 3, 3): d² = 1 + 4 + 4, d = 3.
        said = self.ask("distance", body(box(1, 1, 1)), body(box(1, 1, 1), (3, 4, 4)))
        self.assertEqual((said["verdict"], said["distance"]), ("separated", 3))
        self.assertEqual(said["squared_distance_of_cores"]["exact"], "9")
        self.assertEqual((said["witness_A"], said["witness_B"]), ([1, 1, 1], [2, 3, 3]))
        self.assertEqual((said["feature_A"]["vertices"], said["feature_B"]["vertices"]), ([7], [0]))
        words = self.words("distance")
        self.assertEqual(words["verdict"], "separated")
        self.assertRegex(self.succeeds("ask", "distance", "scene.json"), r"squared_distance_of_cores +exact 9, nearest 9\n")
        self.assertEqual(words["checked"], "by the independent checker: holds")

    def test_constraint_of_a_ball_that_begins_to_roll(self):
        # A ball of radius 1 slides at 7 m/s without spin, mu g = 5: it rolls when v = 5/7 of 7 = 5 m/s, after 2/5 s.
        ball_on_table = scene(body(ball(1), (0, 0, 1), velocity={"v_WBcm": [7, 0, 0], "w_WB": [0, 0, 0]},
                                   material={"restitution": 0, "friction": 0.5}),
                              body(box(50, 50, 1), (0, 0, -1), material={"restitution": 0, "friction": 0.5},
                                   mass={"type": "fixed"}))
        self.file("scene.json", {**ball_on_table, "gravity": [0, 0, -10], "motion": {"sample_times": [1]}})
        said = json.loads(self.succeeds("ask", "constraint", "scene.json", "--json"))
        self.assertEqual((said["ball"], said["first"]), (0, "sliding"))
        rolls = said["changes"][-1]
        self.assertEqual((rolls["kind"], rolls["then"]), ("contact", "rolling"))
        self.assertLessEqual(rolls["time"][0], 0.4)
        self.assertGreaterEqual(rolls["time"][1], 0.4)
        (state,) = said["states"]
        self.assertLessEqual(state["v_WB"][0][0], 5)
        self.assertGreaterEqual(state["v_WB"][0][1], 5)

    def test_broad_phase_of_a_sequence(self):
        pose = {"p": [5, 0, 0], "q": {"w": 1, "x": 0, "y": 0, "z": 0}}
        near = {**pose, "p": [1, 0, 0]}
        self.file("scene.json", {**scene(body(ball(1)), body(ball(1))), "frames": [
            [{"body": 0, "X_WB": {**pose, "p": [0, 0, 0]}}, {"body": 1, "X_WB": pose}], [{"body": 1, "X_WB": near}],
            [{"body": 1, "X_WB": None}]]})
        said = json.loads(self.succeeds("ask", "broad_phase", "scene.json", "--json"))
        self.assertEqual([frame["pairs"] for frame in said["frames"]], [[], [[0, 1]], []])

    def test_distance_that_is_no_double(self):
        said = self.ask("distance", body(box(1, 1, 1)), body(box(1, 1, 1), (2.1, 0, 0)))
        gap = 2.1 - 2  # exact, by Sterbenz
        numerator, denominator = gap.as_integer_ratio()
        self.assertEqual(said["squared_distance_of_cores"]["exact"], f"{numerator**2}/{denominator**2}")
        self.assertEqual(said["distance"], gap)

    def test_distance_is_the_nearest_double(self):
        # Gaps of 1 and 2 make sqrt(5), and its nearest double is above it.
        said = self.ask("distance", body(box(1, 1, 1)), body(box(1, 1, 1), (3, 4, 0)))
        self.assertEqual(said["distance"], math.sqrt(5))
        self.assertEqual(said["distance_enclosure"], [math.nextafter(said["distance"], 0), said["distance"]])

    def test_a_turned_box(self):
        # A quarter turn about z by a quaternion of length √2: the half extents become (1, 3, 1), and 4 - 1 - 1 = 2.
        quarter = {"w": 1, "x": 0, "y": 0, "z": 1}
        said = self.ask("distance", body(box(3, 1, 1), q=quarter), body(box(1, 1, 1), (4, 0, 0)))
        self.assertEqual((said["distance"], said["squared_distance_of_cores"]["exact"]), (2, "4"))

    def test_touching_and_overlapping(self):
        self.assertEqual(self.ask("distance", body(ball(1)), body(ball(2), (3, 0, 0)))["verdict"], "touching")
        self.assertEqual(self.ask("distance", body(ball(1)), body(ball(2), (0, 2.5, 0)))["verdict"], "overlapping")
        said = self.ask("distance", body(hull(TETRAHEDRON)), body(box(1, 1, 1), (-1, 0, 0)))
        self.assertEqual((said["verdict"], said["distance"]), ("touching", 0))

    def test_penetration(self):
        # Two cubes of edge 2, centres 1.5 apart along x: a translation by 0.5 m along x separates them.
        said = self.ask("penetration", body(box(1, 1, 1)), body(box(1, 1, 1), (1.5, 0, 0)))
        self.assertEqual((said["verdict"], said["depth"]), ("overlapping", 0.5))
        self.assertEqual(said["squared_depth_of_cores"]["exact"], "1/4")
        self.assertEqual([abs(x) for x in said["direction_unit"]], [1, 0, 0])
        # Spheres of radius 1 and 2, centres 2 apart: depth 1.
        self.assertEqual(self.ask("penetration", body(ball(1)), body(ball(2), (2, 0, 0)))["depth"], 1)
        self.assertIn("depth", self.words("penetration"))

    def test_mass(self):
        # A tetrahedron with legs of length 1: volume 1/6, centroid at 1/4; at 6 kg/m³ the mass is 1.
        # About the centroid, with coordinates x, y, z: ∫x² = 1/10 - 1/16 = 3/80 and ∫xy = 1/20 - 1/16 = -1/80, so
        # I_xx = ∫y² + z² = 3/40 and I_xy = -∫xy = 1/80.
        said = self.ask("mass", body(hull(TETRAHEDRON), mass={"type": "density", "density": 6}))["bodies"][0]
        self.assertEqual((said["mass"], said["centre_of_mass"]), ([1, 1], dict.fromkeys("xyz", [0.25, 0.25])))
        self.assertEqual(list(said["inertia"]), ["xx", "yy", "zz", "xy", "xz", "yz"])
        for (lo, hi), value in zip(said["inertia"].values(), [3 / 40] * 3 + [1 / 80] * 3):
            self.assertTrue(lo <= value <= hi or near(lo, value, 2e-17), (lo, value, hi))
        self.assertEqual(self.ask("mass", body(box(1, 1, 1), mass={"type": "fixed"}))["bodies"], [{"body": 0, "fixed": True}])
        self.words("mass")

    def test_bounds(self):
        # q = (2, 0, 0, 1) rotates about z with cosine 3/5 and sine 4/5: half extents 3/5 + 4/5 in x and y.
        said = self.ask("bounds", body(box(1, 1, 1), (10, 0, 0), {"w": 2, "x": 0, "y": 0, "z": 1}), body(ball(2)))
        exact = [(box["lo"]["exact"], box["hi"]["exact"]) for box in said["boxes"]]
        self.assertEqual(exact, [(["43/5", "-7/5", "-1"], ["57/5", "7/5", "1"]), (["-2"] * 3, ["2"] * 3)])
        self.assertEqual(said["boxes"][0]["lo"]["nearest"], [8.6, -1.4, -1])
        self.words("bounds")

    def test_broad_phase(self):
        # Boxes 0 and 1 touch at x = 1; box 2 is one ulp beyond box 1.
        said = self.ask("broad_phase", body(box(1, 1, 1)), body(box(1, 1, 1), (2, 0, 0)),
                        body(box(1, 1, 1), (math.nextafter(4, 5), 0, 0)))
        self.assertEqual(said["overlapping_boxes"], [[0, 1]])
        self.words("broad_phase")

    def test_time_of_impact(self):
        # Unit cubes, faces 2 apart, closing at 2 m/s and then 0.5: contact at t = 1, and none within 3 s.
        def said(speed):
            scene_of_two = scene(body(box(1, 1, 1)), body(box(1, 1, 1), (0, 0, 4), velocity={"v_WBcm": [0, 0, -speed], "w_WB": [0, 0, 0]}))
            self.file("scene.json", {**scene_of_two, "gravity": [0, 0, -10], "motion": {"sample_times": [3]}})
            return json.loads(self.succeeds("ask", "time_of_impact", "scene.json", "--json"))

        hit = said(2)
        self.assertEqual(hit["status"], "hit")
        self.assertTrue(hit["apart_before"] <= 1 <= hit["met_by"] <= hit["apart_before"] + 1e-14, hit)
        self.words("time_of_impact")
        self.assertEqual(said(0.5), {"status": "miss", "apart_before": 3})


    def test_of_many_bodies_the_pair_is_named(self):
        near_far = [body(ball(1), name="near"), body(ball(1), (3, 0, 0)), body(ball(1), (9, 0, 0))]
        for query in ("distance", "penetration"):
            said = self.ask(query, *near_far)
            self.assertEqual(said["pair"], "bodies[0] (near) and bodies[1], of 3 bodies")
            self.assertNotIn("pair", self.ask(query, *near_far[:2]))
        self.file("scene.json", {**scene(*near_far), "motion": {"sample_times": [3]}})
        self.assertRegex(self.succeeds("ask", "time_of_impact", "scene.json"), r"^pair +bodies\[0\] \(near\) and bodies\[1\]")


def stl_text(triangles):
    facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in t) +
                     "endloop\nendfacet\n" for t in triangles)
    return f"solid t\n{facets}endsolid t\n"


def stl_binary(triangles):
    return b"t".ljust(80) + struct.pack("<I", len(triangles)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for p in t for x in p), 0) for t in triangles)


class Import(Test):
    def test_every_format_gives_the_same_solid(self):
        points = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]]
        faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
        triangles = [[points[i] for i in face] for face in faces]

        def lines(rows, *before):
            return "".join(" ".join(map(str, [*before, *row])) + "\n" for row in rows)

        files = {
            "tet.obj": lines(points, "v") + lines([[i + 1 for i in face] for face in faces], "f"),
            "tet.off": "OFF\n4 4 0\n" + lines(points) + lines(faces, 3),
            "text.stl": stl_text(triangles),
            "binary.stl": stl_binary(triangles),
            "tet.ply": "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                       "element face 4\nproperty list uchar int vertex_indices\nend_header\n" + lines(points) + lines(faces, 3),
        }
        for name, content in files.items():
            self.assertIn("4 vertices, 4 faces", self.succeeds("import", self.file(name, content), "--out", "scene.json"))
            imported = self.json("scene.json")
            self.assertEqual(sorted(imported["bodies"][0]["shape"]["vertices"]), sorted(points), name)
            self.assertEqual(imported["bodies"][0]["name"], name.split(".")[0])
            # Volume 2³/6 at 1 kg/m³.
            mass = json.loads(self.succeeds("ask", "mass", "scene.json", "--json"))["bodies"][0]["mass"]
            self.assertEqual([near(m, 4 / 3, 1e-15) for m in mass], [True, True], name)
            self.assertEqual(json.loads(self.succeeds("import", name)), imported)


class Words(Test):
    def test_version_is_the_one_of_the_build(self):
        built = re.search(r"project\(touchstone VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertEqual(self.succeeds("--version").strip(), built)

    def test_help_names_every_option_and_exit_code(self):
        run = ["--subjects", "--queries", "--properties", "--cases", "--effort", "quick", "standard", "soak", "--seed",
               "--jobs", "--out", "--json", "--junit", "--time-limit", "--meshes"]
        expected = {"report": run, "check": run, "replay": ["CASE", "--subject", "--json"],
                    "minimise": ["CASE", "--subject", "--budget", "--out"], "ask": ["QUERY", "SCENE", "--json", "distance"], "plan": ["SCENE", "--json"],
                    "import": ["MESH", "--out"], "list": ["subjects", "properties", "clauses", "families"],
                    "soak": ["--pairs", "--seed", "--jobs"]}
        overview = self.succeeds("--help")
        for command, words in expected.items():
            self.assertIn(command, overview)
            page = self.succeeds(command, "--help")
            for word in [*words, "xit code"]:
                self.assertIn(word, page, command)
        for code in ("0 ", "1 ", "2 ", "3 ", "130 "):
            self.assertRegex(overview, rf"\n\s+{code}")

    def test_lists(self):
        self.assertRegex(self.succeeds("list", "subjects"), r"(?m)^reference +0\.")
        properties = re.findall(r"(?m)^([a-z_.]+) ", self.succeeds("list", "properties"))
        self.assertIn("distance.value", properties)
        clauses = self.succeeds("list", "clauses")
        self.assertRegex(clauses, r"(?m)^TS-DISTANCE-1 ")
        checked = set(re.findall(r"[a-z_]+(?:\.[a-z_]+)+", " ".join(re.findall(r"checked by (.*)", clauses))))
        self.assertEqual(checked, set(properties))
        families = self.succeeds("list", "families")
        for stem in ("mass", "bounds", "broad_phase", "distance", "penetration"):
            self.assertIn(stem, families)


if __name__ == "__main__":
    unittest.main()
