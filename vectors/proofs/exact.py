"""Vectors, rotations and solids in exact arithmetic."""

import math
from fractions import Fraction


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def plus(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def times(s, a):
    return (s * a[0], s * a[1], s * a[2])


def applied(matrix, a):
    return tuple(dot(row, a) for row in matrix)


def vec(numbers):
    return tuple(Fraction(x) for x in numbers)


def rotation(q):
    """The matrix of q/|q|: its entries are rational, as only squares of |q| occur."""
    w, x, y, z = (Fraction(q[k]) for k in "wxyz")
    n = w * w + x * x + y * y + z * z
    return (((w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n),
            (2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n),
            (2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n))


def transposed(matrix):
    return tuple(zip(*matrix))


def product(a, b):
    columns = transposed(b)
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def inverse(m):
    rows = cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])
    return transposed([times(1 / dot(m[0], rows[0]), row) for row in rows])


IDENTITY = {"p": [0, 0, 0], "q": {"w": 1, "x": 0, "y": 0, "z": 0}}
BOX_FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def solids(shape):
    """The convex parts of a shape, each as (vertices, faces, radius, pose); a ball has one vertex."""
    parts = [(part["shape"], part["X_BP"]) for part in shape["parts"]] if shape["type"] == "compound" else [
        (shape, IDENTITY)]
    for part, pose in parts:
        if part["type"] == "sphere":
            yield [(Fraction(0),) * 3], [], Fraction(part["radius"]), pose
        elif part["type"] == "box":
            h = vec(part["half_extents"])
            corners = [tuple(h[k] if i >> k & 1 else -h[k] for k in range(3)) for i in range(8)]
            yield corners, BOX_FACES, Fraction(0), pose
        else:
            yield [vec(v) for v in part["vertices"]], part["faces"], Fraction(0), pose


def placed(points, pose):
    matrix, p = rotation(pose["q"]), vec(pose["p"])
    return [plus(applied(matrix, v), p) for v in points]


def parts_in_world(body, pose=None):
    """(vertices in W, faces, radius) of each convex part."""
    pose = pose or body["X_WB"]
    return [(placed(placed(points, part_pose), pose), faces, radius)
            for points, faces, radius, part_pose in solids(body["shape"])]


def root(x):
    """A square root, rounded to 2^-200 of its size."""
    shift = 1 << 400
    return Fraction(math.isqrt(x.numerator * x.denominator * shift), x.denominator << 200)
