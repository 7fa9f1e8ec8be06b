"""Distances by their certificates: one for each pair of parts."""

import itertools
from fractions import Fraction

from proofs.exact import *
from proofs.verdict import demand, ends


def has_rank_3(vectors_):
    for a, b, c in itertools.combinations(vectors_, 3):
        if dot(a, cross(b, c)) != 0:
            return True
    return False


def check_certificate(certificate, A, B):
    """A and B are (vertices, faces, radius). Returns "apart", "touching" or "overlapping" of the cores."""
    normal = [Fraction(x) for x in certificate["direction"]]
    weights = [Fraction(pair["weight"]) for pair in certificate["pairs"]]
    differences = [minus(A[0][pair["A"]], B[0][pair["B"]]) for pair in certificate["pairs"]]
    mix = (Fraction(0),) * 3
    for weight, difference in zip(weights, differences):
        mix = plus(mix, times(weight, difference))
    demand(sum(weights) == 1 and min(weights) >= 0, "weights of a certificate")
    demand(Fraction(certificate["radius_sum"]) == A[2] + B[2], "radius sum")
    core = Fraction(certificate["squared_distance_of_cores"])
    demand(dot(mix, mix) == core, "the mix of a certificate has another length")
    if core > 0:
        demand(tuple(normal) == mix, "direction of a certificate")
    elif any(normal):
        pass
    else:
        demand(min(weights) > 0 and has_rank_3(differences), "no common interior point is proved")
        return "overlapping", core
    least = min(dot(normal, a) for a in A[0]) - max(dot(normal, b) for b in B[0])
    demand(least >= core, "the plane of a certificate does not separate")
    return ("apart" if core > 0 else "touching"), core


def check_distance(scene, answer):
    bodies = [parts_in_world(body) for body in scene["bodies"][:2]]
    pairs = {(c["part_A"], c["part_B"]): c for c in answer["certificates"]}
    demand(set(pairs) == set(itertools.product(*(range(len(parts)) for parts in bodies))), "a pair of parts is missing")
    low, high = ends(answer["distance_enclosure"])
    demand(0 <= low <= high, "a negative distance")
    verdicts, reached = set(), False
    for (a, b), certificate in pairs.items():
        A, B = bodies[0][a], bodies[1][b]
        cores, core = check_certificate(certificate, A, B)
        radius = A[2] + B[2]
        if cores == "overlapping" or core < radius**2:
            verdicts.add("overlapping")
        else:
            verdicts.add("touching" if core == radius**2 else "separated")
            demand(core >= (low + radius) ** 2, "the distance is less")
        reached = reached or core <= (high + radius) ** 2
    truth = next(v for v in ("overlapping", "touching", "separated") if v in verdicts)
    demand(answer["verdict"] == truth, f"it is {truth}")
    demand(reached, "the distance is greater")
    demand(truth == "separated" or (low, high) == (0, 0), "a distance of bodies that touch")
