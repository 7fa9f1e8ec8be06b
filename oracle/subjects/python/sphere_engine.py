#!/usr/bin/env python3
"""A complete Touchstone subject in Python: the distance of two spheres, and of a sphere and a box.

Speaks the protocol of docs/protocol.md on stdin and stdout; try it with
    touchstone check --subjects exec:'python3 oracle/subjects/python/sphere_engine.py' --queries distance
"""
import json
import math
import sys

CARD = {
    "name": "sphere_engine", "version": "1", "precision": "binary64", "answers": ["distance"],
    "about": "closed forms in Python; spheres, and boxes against spheres",
}


def add(a, b): return [x + y for x, y in zip(a, b)]
def sub(a, b): return [x - y for x, y in zip(a, b)]
def scaled(s, a): return [s * x for x in a]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def rotated(q, v, sign=1):
    """R(q/|q|) v; with sign -1, the inverse rotation. Any q but 0 is a rotation, however large or small."""
    largest = max(map(abs, q.values()))
    w, x, y, z = (q[k] / largest for k in "wxyz")
    norm = math.hypot(w, x, y, z)
    w, axis = w / norm, [sign * c / norm for c in (x, y, z)]
    t = scaled(2, cross(axis, v))
    return add(add(v, scaled(w, t)), cross(axis, t))


def nearest_on(body, p_WQ):
    """For a box: its point nearest to Q, and 0. For a sphere: its centre, and its radius."""
    shape, pose = body["shape"], body["X_WB"]
    if shape["type"] == "sphere":
        return pose["p"], shape["radius"]
    p_BQ = rotated(pose["q"], sub(p_WQ, pose["p"]), -1)
    p_BN = [min(max(x, -h), h) for x, h in zip(p_BQ, shape["half_extents"])]
    return add(rotated(pose["q"], p_BN), pose["p"]), 0.0


def distance(scene):
    A, B = scene["bodies"][:2]
    if {A["shape"]["type"], B["shape"]["type"]} not in ({"sphere"}, {"sphere", "box"}):
        return {"abstains": "spheres, and a box against a sphere"}
    p_WA, r_A = nearest_on(A, B["X_WB"]["p"])
    p_WB, r_B = nearest_on(B, A["X_WB"]["p"])
    between = sub(p_WA, p_WB)
    length = math.hypot(*between)
    if not math.isfinite(length):
        return {"abstains": "coordinates whose differences overflow"}
    gap = length - r_A - r_B
    if gap <= 0:
        return {"result": {"verdict": "overlapping", "distance": 0.0}}
    nhat_BA_W = [x / length for x in between]  # 1 / length may overflow
    return {"result": {"verdict": "separated", "distance": gap,
                       "p_WCa": sub(p_WA, scaled(r_A, nhat_BA_W)), "p_WCb": add(p_WB, scaled(r_B, nhat_BA_W))}}


for line in sys.stdin:
    message = json.loads(line)
    if message["op"] == "stop":
        break
    if message["op"] == "start":
        answer = {"protocol": 1, "card": CARD}
    elif message["query"] == "distance":
        answer = distance(message["scene"])
    else:
        answer = {"abstains": "no " + message["query"] + " query"}
    print(json.dumps({"seq": message["seq"], **answer}), flush=True)
