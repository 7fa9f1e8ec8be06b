"""Mass, centre of mass and inertia: integrals over tetrahedra; π to 60 digits."""

import itertools
from fractions import Fraction

from proofs.exact import *
from proofs.verdict import demand, encloses

PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")
PI_ERROR = Fraction(1, 10**62)


def moments(body, pi):
    """Volume, first and second moments about the body's origin, for density 1."""
    volume, first = Fraction(0), (Fraction(0),) * 3
    second = [[Fraction(0)] * 3 for _ in range(3)]
    for points, faces, radius, pose in solids(body["shape"]):
        points = placed(points, pose)
        if radius:
            v = 4 * pi * radius**3 / 3
            volume, first = volume + v, plus(first, times(v, points[0]))
            for i, j in itertools.product(range(3), repeat=2):
                second[i][j] += v * points[0][i] * points[0][j] + (v * radius**2 / 5 if i == j else 0)
        for face in faces:
            a = points[face[0]]
            for b, c in zip((points[i] for i in face[1:]), (points[i] for i in face[2:])):
                v = dot(a, cross(b, c)) / 6
                total = plus(plus(a, b), c)
                volume, first = volume + v, plus(first, times(v / 4, total))
                for i, j in itertools.product(range(3), repeat=2):
                    second[i][j] += v / 20 * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + total[i] * total[j])
    return volume, first, second


def mass_properties(body, pi=PI):
    """Mass, centre of mass in B, inertia about it in B's axes; None of a fixed body."""
    given = body.get("mass", {"type": "density", "density": 1})
    if given["type"] == "fixed":
        return None
    if given["type"] == "given":
        return Fraction(given["mass"]), vec(given["p_BBcm"]), [vec(row) for row in given["I_BBcm_B"]]
    density = Fraction(given["density"])
    volume, first, second = moments(body, pi)
    centre = times(1 / volume, first)
    about = [[second[i][j] - volume * centre[i] * centre[j] for j in range(3)] for i in range(3)]
    trace = about[0][0] + about[1][1] + about[2][2]
    inertia = [[density * ((trace if i == j else 0) - about[i][j]) for j in range(3)] for i in range(3)]
    return density * volume, centre, inertia


def check_mass(scene, answer):
    for body, said in zip(scene["bodies"], answer["bodies"], strict=True):
        least, most = (mass_properties(body, pi) for pi in (PI - PI_ERROR, PI + PI_ERROR))
        if least is None:
            demand(said.get("fixed"), "a fixed body")
            continue
        truths = [("mass", said["mass"], least[0], most[0])]
        for k, name in enumerate("xyz"):
            truths.append((name, said["centre_of_mass"][name], least[1][k], most[1][k]))
        for i, j in itertools.combinations_with_replacement(range(3), 2):
            name = "xyz"[i] + "xyz"[j]
            truths.append((name, said["inertia"][name], least[2][i][j], most[2][i][j]))
        for name, interval, a, b in truths:
            encloses(interval, min(a, b), max(a, b), name)
