"""Usage: wrong_adapter.py MISTAKE ENGINE. An adapter with one mistake. Its engine is a subject of ours behind a pipe, whose
conventions are those of the protocol; the mistake is made on the way to it, or on the way back. MISTAKE may be "none"."""

import copy
import json
import math
import pathlib
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[3] / "adapters/python"))
from touchstone_adapter import Abstain, in_body, rotated, serve  # noqa: E402

DEGREE = math.pi / 180


class Engine:
    def __init__(self, program):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.seq = 0
        self.card = self.exchange({"op": "start", "protocol": 1})["card"]

    def exchange(self, message):
        self.seq += 1
        self.process.stdin.write(json.dumps({**message, "seq": self.seq}) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def ask(self, query, scene):
        answer = self.exchange({"op": "ask", "query": query, "scene": scene})
        if "abstains" in answer:
            raise Abstain(answer["abstains"])
        if "breaks" in answer:
            raise RuntimeError(answer["breaks"]["how"])
        return answer["result"]


def each_body(change):
    def changed(scene):
        for body in scene["bodies"]:
            change(body)
    return changed


def half_extents(body):
    if body["shape"]["type"] == "box":
        body["shape"]["half_extents"] = [h / 2 for h in body["shape"]["half_extents"]]


def diameter(body):
    if body["shape"]["type"] == "sphere":
        body["shape"]["radius"] *= 2


def xyzw(body):
    q = body["X_WB"]["q"]
    body["X_WB"]["q"] = {"x": q["w"], "y": q["x"], "z": q["y"], "w": q["z"]}


def transposed(body):
    q = body["X_WB"]["q"]
    body["X_WB"]["q"] = {"w": q["w"], "x": -q["x"], "y": -q["y"], "z": -q["z"]}


def spin_in_degrees(body):
    if "velocity" in body:
        body["velocity"]["w_WB"] = [w * DEGREE for w in body["velocity"]["w_WB"]]


def unfixed(body):
    if body.get("mass", {}).get("type") == "fixed":
        body["mass"] = {"type": "density", "density": 1}


def e_by_max(scene):
    largest = max(body["material"]["restitution"] for body in scene["bodies"])
    for body in scene["bodies"]:
        body["material"]["restitution"] = largest
    if "contact" in scene:
        scene["contact"]["restitution"] = largest


def normal_to_B(scene):
    scene["contact"]["nhat_BA_W"] = [-n for n in scene["contact"]["nhat_BA_W"]]


def normal_reversed(result, scene):
    if "nhat_BA_W" in result:
        result["nhat_BA_W"] = [-n for n in result["nhat_BA_W"]]


def depth_sign(result, scene):
    result["depth"] = -result["depth"]


def normal_in_B(result, scene):
    if "nhat_BA_W" in result:
        q = scene["bodies"][1]["X_WB"]["q"]
        result["nhat_BA_W"] = rotated({**q, "w": -q["w"]}, result["nhat_BA_W"])


def witnesses_in_bodies(result, scene):
    for body, witness in zip(scene["bodies"], ("p_WCa", "p_WCb")):
        if witness in result:
            result[witness] = in_body(body["X_WB"], result[witness])


def inertia_about_origin(result, scene):
    for mass in filter(None, result):
        c, m = mass["p_BBcm"], mass["mass"]
        square = sum(x * x for x in c)
        for i in range(3):
            for j in range(3):
                mass["I_BBcm_B"][i][j] += m * ((i == j) * square - c[i] * c[j])


def density_for_mass(result, scene):
    for mass, body in zip(result, scene["bodies"]):
        kind = body.get("mass", {"type": "density", "density": 1})
        if mass and kind["type"] == "density":
            factor = kind["density"] / mass["mass"]
            mass["mass"] = kind["density"]
            mass["I_BBcm_B"] = [[factor * x for x in row] for row in mass["I_BBcm_B"]]


def in_floats(value):
    if isinstance(value, float):
        return struct.unpack("f", struct.pack("f", value))[0]
    if isinstance(value, list):
        return [in_floats(part) for part in value]
    return {key: in_floats(part) for key, part in value.items()} if isinstance(value, dict) else value


def margin(result, scene):
    result["distance"] -= 0.08 if result["distance"] > 0 else 0


# name: (the query, what the adapter makes of the question, what it makes of the result, a part of the right hint)
MISTAKES = {
    "normal reversed": ("penetration", None, normal_reversed, "normal reversed"),
    "normal of an impact reversed": ("impulse", normal_to_B, None, "normal reversed"),
    "half extents": ("distance", each_body(half_extents), None, "half extents taken for extents"),
    "diameter": ("bounds", each_body(diameter), None, "diameter taken for radius"),
    "quaternion order": ("distance", each_body(xyzw), None, "quaternion order"),
    "pose transposed": ("bounds", each_body(transposed), None, "pose transposed"),
    "degrees": ("impulse", each_body(spin_in_degrees), None, "degrees for radians"),
    "frame of bodies": ("distance", None, witnesses_in_bodies, "frame of A and B"),
    "frame of B": ("penetration", None, normal_in_B, "frame of B"),
    "depth sign": ("penetration", None, depth_sign, "depth sign"),
    "inertia about the origin": ("mass", None, inertia_about_origin, "inertia about the origin"),
    "density for mass": ("mass", None, density_for_mass, "density taken for mass"),
    "fixed body moved": ("impulse", each_body(unfixed), None, "fixed body moved"),
    "e by max": ("impulse", e_by_max, None, "e combined by max"),
    "e of a motion by max": ("simulation", e_by_max, None, "e combined by max"),
    "single precision": ("distance", None, lambda result, scene: result.update(in_floats(result)), "single precision"),
    "margin": ("distance", None, margin, "off by the same -0.08"),
}


def queries(engine, mistake):
    wrong_query, to_engine, from_engine, _ = MISTAKES.get(mistake, (None, None, None, None))

    def answer(query, scene):
        asked = copy.deepcopy(scene)
        if query == wrong_query and to_engine:
            to_engine(asked)
        result = engine.ask(query, asked)
        if query == wrong_query and from_engine:
            from_engine(result, scene)
        if query in ("distance", "impulse"):  # claims that are no business of this test
            for claim in ("enclosure", "feature_A", "feature_B", "error", "ambiguous"):
                result.pop(claim, None)
        return result

    asked_about = [wrong_query] if wrong_query else engine.card["answers"]
    return {query: (lambda scene, query=query: answer(query, scene)) for query in asked_about}


if __name__ == "__main__":
    engine = Engine(sys.argv[2])
    serve({"name": "wrong_adapter", "version": "1", "precision": "binary64"}, queries(engine, sys.argv[1]))
