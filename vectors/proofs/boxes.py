"""Bounding boxes by the extreme vertices, and their pairs by trying all."""

import itertools
from fractions import Fraction

from proofs.exact import *
from proofs.verdict import demand


def exact_box(body, pose=None):
    corners = [[point[k] + sign * radius for points, _, radius in parts_in_world(body, pose) for point in points]
               for k in range(3) for sign in (-1, 1)]
    return [min(corners[2 * k]) for k in range(3)], [max(corners[2 * k + 1]) for k in range(3)]


def check_bounds(scene, answer):
    for body, said in zip(scene["bodies"], answer["boxes"], strict=True):
        for end, truth in zip(("lo", "hi"), exact_box(body)):
            demand([Fraction(x) for x in said[end]["exact"]] == truth, f"{end} of body {said['body']}")


def pairs_of(boxes):
    def overlap(a, b):
        return all(a[0][k] <= b[1][k] and b[0][k] <= a[1][k] for k in range(3))

    there = sorted(boxes)
    return [[i, j] for i, j in itertools.combinations(there, 2) if overlap(boxes[i], boxes[j])]


def check_broad_phase(scene, answer):
    if "frames" not in scene:
        boxes = {b: exact_box(body) for b, body in enumerate(scene["bodies"])}
        demand(answer["overlapping_boxes"] == pairs_of(boxes), "pairs")
        return
    boxes, before = {}, []
    for changes, said in zip(scene["frames"], answer["frames"], strict=True):
        for change in changes:
            if change["X_WB"] is None:
                del boxes[change["body"]]
            else:
                boxes[change["body"]] = exact_box(scene["bodies"][change["body"]], change["X_WB"])
        now = pairs_of(boxes)
        demand(said["pairs"] == now, "pairs of a frame")
        demand(said["begun"] == [pair for pair in now if pair not in before], "pairs that begin")
        demand(said["ended"] == [pair for pair in before if pair not in now], "pairs that end")
        before = now
