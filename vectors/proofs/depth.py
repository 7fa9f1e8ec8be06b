"""Depths: the least over all normals of faces and products of edges; or the certificate of the distance."""

import itertools
import math
from fractions import Fraction

from proofs.distance import check_certificate
from proofs.exact import *
from proofs.verdict import demand, ends


def whole(points_a, points_b):
    """The same points as whole numbers, times a common factor, which is the third value."""
    factor = math.lcm(*(x.denominator for point in points_a + points_b for x in point))
    return ([tuple(int(x * factor) for x in p) for p in points_a],
            [tuple(int(x * factor) for x in p) for p in points_b], factor)


def edges_of(faces):
    return {(min(e), max(e)) for face in faces for e in zip(face, face[1:] + face[:1])}


def normal_of(points, face):
    a = points[face[0]]
    return next(n for b, c in itertools.combinations(face[1:], 2)
                if any(n := cross(minus(points[b], a), minus(points[c], a))))


def least_depth_squared(A, B):
    """The least width of the overlap over the normals of faces and the products of edges, squared."""
    a, b, factor = whole(A[0], B[0])
    normals = {normal_of(points, list(face)) for points, faces in ((a, A[1]), (b, B[1])) for face in faces}
    for i, j in edges_of([list(f) for f in A[1]]):
        for k, m in edges_of([list(f) for f in B[1]]):
            n = cross(minus(a[j], a[i]), minus(b[m], b[k]))
            if any(n):
                normals.add(n)
    least = None
    for n in normals:
        on_a, on_b = [dot(n, p) for p in a], [dot(n, p) for p in b]
        width = min(max(on_b) - min(on_a), max(on_a) - min(on_b))
        squared = Fraction(width * width, dot(n, n) * factor * factor)
        least = squared if least is None or squared < least else least
    return least


def check_penetration(scene, answer):
    A, B = (parts_in_world(body)[0] for body in scene["bodies"][:2])
    radius = A[2] + B[2]
    low, high = ends(answer["depth_enclosure"])
    demand(0 <= low <= high, "a negative depth")
    cores, core = check_certificate(answer["certificates"][0], A, B)
    if cores != "overlapping":
        truth = "overlapping" if core < radius**2 else "touching" if core == radius**2 else "separated"
        if truth == "overlapping":  # depth = r − |d*|
            demand(high <= radius and (radius - low) ** 2 >= core >= (radius - high) ** 2, "depth")
        else:
            demand((low, high) == (0, 0), "a depth of bodies that do not overlap")
        demand(answer["verdict"] == truth, f"it is {truth}")
        return
    demand(answer["verdict"] == "overlapping", "it is overlapping")
    if len(A[0]) == 1 or len(B[0]) == 1:  # a point in a polytope: the nearest face's plane
        (point, _, _), (points, faces, _) = (A, B) if len(A[0]) == 1 else (B, A)
        least = None
        for face in faces:
            n = normal_of(points, list(face))
            away = dot(n, minus(points[face[0]], point[0]))
            squared = away * away / dot(n, n)
            least = squared if least is None or squared < least else least
    else:
        least = least_depth_squared(A, B)
    demand(Fraction(answer["squared_depth_of_cores"]["exact"]) == least, "squared depth")
    demand(high >= radius and max(low - radius, 0) ** 2 <= least <= (high - radius) ** 2, "depth")
