"""A ball on fixed boxes: what its mode says of its motion from one change to the next, and to the samples."""

import math
from fractions import Fraction

from proofs.exact import *
from proofs.verdict import InPart, demand

TINY = Fraction(1, 2**44)  # of the scale, as `near` has it: middles of enclosures that are an ulp or two wide


def middle(interval):
    return (Fraction(interval[0]) + Fraction(interval[1])) / 2


class State:
    """p, v and w at a time, the middles of enclosures."""

    def __init__(self, time, p, v, w):
        self.time, self.p, self.v, self.w = time, p, v, w

    @staticmethod
    def read(time, json):
        return State(time, *(tuple(map(middle, json[key])) for key in ("p_WB", "v_WB", "w_WB")))


def is_near_state(a, b, scale):
    return all(abs(x - y) <= TINY * scale for x, y in zip(a.p + a.v + a.w, b.p + b.v + b.w))


def near_state(a, b, scale, what):
    demand(is_near_state(a, b, scale), what)


def normal_of_contact(state, radius, box, scale):
    """The outward normal of the box's face on which the ball rests. It is rational: a column of a rotation."""
    axes = transposed(rotation(box["X_WB"]["q"]))
    from_middle = minus(state.p, vec(box["X_WB"]["p"]))
    for axis, half in zip(axes, vec(box["shape"]["half_extents"])):
        for n in (axis, times(-1, axis)):
            if abs(dot(n, from_middle) - half - radius) <= TINY * scale:
                return n
    demand(False, "the ball does not touch the face that it rolls or slides on")


def slip(state, n, radius):
    """The velocity of the ball's point at the contact."""
    return plus(state.v, cross(state.w, times(-radius, n)))


def length(a):
    size = dot(a, a)
    return Fraction(0) if size == 0 else root(size)


def inertia_of(ball, radius):
    """Over m r²: 2/5 if the ball is uniform."""
    given = ball.get("mass", {"type": "density"})
    if given["type"] != "given":
        return Fraction(2, 5)
    return Fraction(given["I_BBcm_B"][0][0]) / (Fraction(given["mass"]) * radius**2)


def moved(state, time, mode, contact, gravity):
    """The state at a later time. `contact`: (normal, radius, friction, inertia over m r²) unless the ball flies."""
    t = time - state.time
    acceleration, turning = gravity, (Fraction(0),) * 3
    if mode != "ballistic":
        n, radius, friction, inertia = contact
        pressed = -dot(gravity, n)
        along = plus(gravity, times(pressed, n))
        if mode == "rolling":
            acceleration = times(1 / (1 + inertia), along)
            turning = times(1 / radius, cross(n, acceleration))
        else:
            u = slip(state, n, radius)
            u = u if length(u) > TINY else along  # slip begins
            u = times(1 / length(u), u)
            acceleration = minus(along, times(friction * pressed, u))
            turning = times(friction * pressed / (inertia * radius), cross(n, u))
    p = plus(state.p, plus(times(t, state.v), times(t * t / 2, acceleration)))
    return State(time, p, plus(state.v, times(t, acceleration)), plus(state.w, times(t, turning)))


def pair_friction(scene, a, b):
    return min(Fraction(scene["bodies"][i].get("material", {"friction": 0})["friction"]) for i in (a, b))


def check_constraint(scene, answer):
    index = answer["ball"]
    ball, radius = scene["bodies"][index], Fraction(scene["bodies"][index]["shape"]["radius"])
    gravity = vec(scene.get("gravity", [0, 0, 0]))
    velocity = ball.get("velocity", {"v_WBcm": [0, 0, 0], "w_WB": [0, 0, 0]})
    state = State(Fraction(0), vec(ball["X_WB"]["p"]), vec(velocity["v_WBcm"]), vec(velocity["w_WB"]))
    samples = [State.read(Fraction(t), s) for t, s in zip(scene["motion"]["sample_times"], answer["states"])]
    demand(len(samples) == len(scene["motion"]["sample_times"]), "a sample is missing")
    scale = max(1, *(abs(x) for s in samples + [state] for x in s.p + s.v + s.w))
    mode, contact, since = "ballistic", None, Fraction(0)
    beside = {}  # at a time in the enclosure of a change, which may be later or earlier: the states before and after it
    changes = answer["changes"] + [None]
    for change in changes:
        end = middle(change["time"]) if change else None
        until = Fraction(change["time"][0]) if change else math.inf
        if not (change and end == state.time):
            if mode != "ballistic":
                demand(contact is not None, "rolls or slides on nothing")
            for sample in (s for s in samples if since <= s.time < until):
                truth = moved(state, sample.time, mode, contact, gravity)
                near_state(truth, sample, scale, f"at {float(sample.time)} s")
        if not change:
            break
        after = State.read(end, change["after"])
        before = moved(state, end, mode, contact, gravity)
        if change["kind"] == "impact":
            demand(all(abs(x - y) <= TINY * scale for x, y in zip(before.p, after.p)), "an impact moves the ball")
        else:
            near_state(before, after, scale, f"at the change at {float(end)} s")
        for sample in (s for s in samples if until <= s.time <= Fraction(change["time"][1])):
            beside.setdefault(sample.time, []).extend([before, after])
        state, mode, since = after, change["then"], Fraction(change["time"][1])
        if mode != "ballistic" and change["kind"] == "contact":
            n = normal_of_contact(state, radius, scene["bodies"][change["other"]], scale)
            contact = (n, radius, pair_friction(scene, index, change["other"]), inertia_of(ball, radius))
        if mode == "rolling" and change["kind"] == "contact":
            demand(length(slip(state, contact[0], radius)) <= TINY * scale, "a rolling ball slips")
    for sample in (s for s in samples if s.time in beside):
        demand(any(is_near_state(state, sample, scale) for state in beside[sample.time]), f"at {float(sample.time)} s")
    raise InPart
