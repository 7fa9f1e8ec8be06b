"""What every impulse obeys: momentum, the cone, restitution, energy, parting."""

from fractions import Fraction

from proofs.exact import *
from proofs.mass import mass_properties
from proofs.verdict import InPart, demand, near


def known(numbers):
    """Where the answer is rational the file has it exactly, else the nearest doubles."""
    return vec(numbers["exact"] if isinstance(numbers, dict) else numbers)


def check_impulse(scene, answer):
    contact = scene["contact"]
    n = vec(contact["nhat_BA_W"])
    P = known(answer["P_A_W"])
    zero = (Fraction(0),) * 3
    energy, speed, slip, driven = [Fraction(0), Fraction(0)], Fraction(0), [zero, zero], False
    for sign, body, said in ((1, scene["bodies"][0], answer["after_A"]), (-1, scene["bodies"][1], answer["after_B"])):
        velocity = body.get("velocity", {"v_WBcm": [0, 0, 0], "w_WB": [0, 0, 0]})
        v, w = vec(velocity["v_WBcm"]), vec(velocity["w_WB"])
        properties = mass_properties(body)
        centre, turned = vec(body["X_WB"]["p"]), rotation(body["X_WB"]["q"])
        driven = driven or not properties and any(v + w)
        v_after, w_after, levered = v, w, 0  # P is rounded, which a lever may magnify
        if properties:  # else it is fixed
            mass, p_BBcm, inertia = properties
            centre = plus(centre, applied(turned, p_BBcm))
            inertia = product(product(turned, inertia), transposed(turned))
            arm = minus(vec(contact["p_WC"]), centre)
            v_after = plus(v, times(sign / mass, P))
            turning = inverse(inertia)
            w_after = plus(w, applied(turning, times(sign, cross(arm, P))))
            levered = max(abs(x) for row in turning for x in row) * max(map(abs, arm)) * max(map(abs, P))
            for k, (linear, angular) in enumerate(((v, w), (v_after, w_after))):
                energy[k] += (mass * dot(linear, linear) + dot(angular, applied(inertia, angular))) / 2
        arm = minus(vec(contact["p_WC"]), centre)
        scale = max(map(abs, v + v_after))
        near(v_after, known(said["v_WBcm"]), scale, "velocity after")
        near(w_after, known(said["w_WB"]), max(map(abs, w + w_after)) + levered, "angular velocity after")
        for k, (linear, angular) in enumerate(((v, w), (v_after, w_after))):
            slip[k] = plus(slip[k], times(sign, plus(linear, cross(angular, arm))))
        speed = max(speed, scale, *(abs(x) for s in slip for x in s), levered * max(map(abs, arm)))
    tiny = Fraction(1, 2**40)
    normal = dot(P, n) ** 2 / dot(n, n)  # squared
    demand(dot(P, n) >= 0, "the impulse pulls")
    if contact["friction"] != "sticking":
        tangential = dot(P, P) - normal
        most = Fraction(contact["friction"]) ** 2 * normal
        demand(tangential <= most + tiny * dot(P, P), "the impulse leaves the cone")
    work = max(map(abs, P)) * max(abs(x) for s in slip for x in s)
    law, before = contact.get("law", "poisson"), dot(slip[0], n)
    if law == "newton":  # which may make energy grow, as Kane's rod shows
        bounce = -Fraction(contact["restitution"]) * min(before, 0)
        # Friction alone may part the bodies: then there is no normal impulse.
        off = abs(dot(slip[1], n) - bounce)
        demand(normal == 0 or off <= 4 * tiny * speed * max(map(abs, n)), "Newton's restitution")
    elif not driven:
        demand(energy[1] <= energy[0] + tiny * (energy[0] + work), "energy grows")
    demand(dot(slip[1], n) >= -tiny * speed * max(map(abs, n)) * 3, "the bodies still approach")
    if law == "poisson" and "compressed again" not in answer["modes"]:
        said, truth = Fraction(answer["p_f"]), (1 + Fraction(contact["restitution"])) * Fraction(answer["p_c"])
        demand(abs(said - truth) <= tiny * truth, "Poisson's restitution")
    raise InPart
