"""First contacts of bodies that do not turn, by a plane; and free motion."""

import math
from fractions import Fraction

from proofs.depth import normal_of
from proofs.exact import *
from proofs.verdict import InPart, Unproved, demand, near


def does_not_turn(body):
    """Do all points that matter move alike? A uniform ball may spin about its centre."""
    if not any(body.get("velocity", {"w_WB": [0]})["w_WB"]):
        return True
    return body["shape"]["type"] == "sphere" and body.get("mass", {"type": "density"})["type"] == "density"


def moved_by(scene, body, t):
    """How far a body that does not turn has come in ballistic motion after the time t."""
    velocity = body.get("velocity", {"v_WBcm": [0, 0, 0]})
    falls = body.get("mass", {"type": "density"})["type"] != "fixed"
    linear = times(t, vec(velocity["v_WBcm"]))
    return plus(linear, times(t * t / 2, vec(scene.get("gravity", [0, 0, 0])))) if falls else linear


def extent(body, direction, sign):
    """The least (sign −1) or greatest of direction · x over the body's points, as placed; balls rounded to 2^-60."""
    size = root(dot(direction, direction))
    return sign * max(sign * dot(direction, point) + radius * size
                      for points, _, radius in parts_in_world(body) for point in points)


def check_time_of_impact(scene, answer):
    """The plane through the contact separates the bodies at the contact, and all the time before. It must if they are
    convex and approach each other on a straight line; else it may not, and then it proves nothing."""
    bodies, motion = scene["bodies"][:2], scene["motion"]
    if answer["status"] != "hit" or not all(map(does_not_turn, bodies)) or motion.get("forces"):
        raise Unproved
    starts = [Fraction(t) for t in motion.get("start_times", [0, 0])]
    n, end = vec(answer["nhat_BA_W"]), Fraction(answer["met_by"])
    gap_at_start = extent(bodies[0], n, -1) - extent(bodies[1], n, 1)

    def gap(t):
        return gap_at_start + dot(n, minus(*(moved_by(scene, body, t - s) for body, s in zip(bodies, starts))))

    tiny = Fraction(scene_size(bodies)) * Fraction(1, 2**40)
    begin = max(starts)
    demand(Fraction(answer["apart_before"]) <= end, "the enclosure is empty")
    # The gap is a parabola in t, or a line: its least value is at an end or at its vertex.
    middle = (begin + end) / 2
    curvature = 2 * (gap(begin) + gap(end) - 2 * gap(middle))
    times_ = [begin, end]
    if curvature > 0:
        slope = gap(end) - gap(begin)
        vertex = middle - (end - begin) * slope / (2 * curvature)
        times_ += [vertex] if begin < vertex < end else []
    separated = all(gap(t) >= -tiny for t in times_)
    if not separated and (curvature or any(body["shape"]["type"] == "compound" for body in bodies)):
        raise Unproved
    demand(separated, "the plane does not separate the bodies before")
    near(vec(answer["p_WCa"]), vec(answer["p_WCb"]), 2 * scene_size(bodies), "the witness points are not one")
    for body, start, key in zip(bodies, starts, ("p_WCa", "p_WCb")):
        point = minus(vec(answer[key]), moved_by(scene, body, end - start))
        demand(any(is_near_part(point, part, tiny) for part in parts_in_world(body)), f"{key} is off its body")


def scene_size(bodies):
    parts = [part for body in bodies for part in parts_in_world(body)]
    return max(abs(x) + radius for points, _, radius in parts for point in points for x in point)


def is_near_part(point, part, tiny):
    points, faces, radius = part
    if radius:
        d = minus(point, points[0])
        return dot(d, d) <= (radius + tiny) ** 2
    for face in faces:
        n = normal_of(points, list(face))
        outward = dot(n, minus(point, points[face[0]]))
        if outward > 0 and outward**2 > tiny**2 * dot(n, n):
            return False
    return True


def check_simulation(scene, answer):
    first, compared = {}, False
    for event in answer.get("events", []):
        for body in (event["a"], event.get("b")):
            first.setdefault(body, Fraction(event["time"]))
    if scene["motion"].get("forces") or any(scene["motion"].get("start_times", [])):
        raise Unproved
    for t, states in zip(scene["motion"]["sample_times"], answer["states"]):
        for b, (body, state) in enumerate(zip(scene["bodies"], states, strict=True)):
            if does_not_turn(body) and Fraction(t) < first.get(b, math.inf):
                truth = plus(vec(body["X_WB"]["p"]), moved_by(scene, body, Fraction(t)))
                near(truth, vec(state["X_WB"]["p"]), max(1, *map(abs, truth)), f"body {b} at {t} s")
                compared = True
    raise InPart if compared else Unproved
