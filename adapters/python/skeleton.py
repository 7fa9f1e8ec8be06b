#!/usr/bin/env python3
"""An adapter of NAME for Touchstone. Run it by
    touchstone adapter check "exec:python3 NAME.py"
It answers the distance of two balls, and abstains from all else. Replace the parts that are marked TODO."""
import math

from touchstone_adapter import Abstain, in_world, rotated, serve, unit_quaternion  # import the engine below this line


# TODO: the name and version of your engine; "binary32" if it computes in floats; which settings you use.
CARD = {
    "name": "NAME", "version": "0", "precision": "binary64",
    "about": "closed form; a skeleton",
}


def shape_of(body):
    """TODO: make your engine's shape of the body's. Mind what your engine calls radius, half extents and sides:
    {"type": "sphere", "radius"}, {"type": "box", "half_extents"}: a box has the sides 2 hx, 2 hy, 2 hz;
    {"type": "polytope", "vertices", "faces"}: its faces are counter-clockwise seen from outside."""
    if body["shape"]["type"] != "sphere":
        raise Abstain("balls only")
    return body["shape"]["radius"]


def distance(scene):
    """The distance of bodies 0 (A) and 1 (B). A pose X_WB maps points of the body's frame B to the world's frame W:
    p_WQ = R(q) p_BQ + p. q = (w, x, y, z) may have any length but 0; unit_quaternion(q) has length 1."""
    A, B = scene["bodies"][:2]
    r_A, r_B = shape_of(A), shape_of(B)
    p_WA, p_WB = A["X_WB"]["p"], B["X_WB"]["p"]
    # TODO: ask your engine here. Do not repair its answer: no clamping, no epsilon, no second try.
    between = [a - b for a, b in zip(p_WA, p_WB)]
    length = math.hypot(*between)
    gap = length - r_A - r_B
    if gap <= 0:
        return {"verdict": "overlapping", "distance": 0.0}
    nhat_BA_W = [x / length for x in between]  # all positions and directions of answers are in the world's frame W
    p_WCa = [p - r_A * n for p, n in zip(p_WA, nhat_BA_W)]  # witness on A: a member that you do not know is left out
    p_WCb = [p + r_B * n for p, n in zip(p_WB, nhat_BA_W)]
    return {"verdict": "separated", "distance": gap, "p_WCa": p_WCa, "p_WCb": p_WCb}


# TODO: a function for each query that your engine answers: mass, bounds, broad_phase, pair_history, distance,
# penetration, impulse, pixel, time_of_impact, simulation, constraint. Queries that are not here are never asked.
serve(CARD, {"distance": distance})
