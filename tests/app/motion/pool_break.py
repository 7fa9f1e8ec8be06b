"""Computes the pool break with 60 digits, event by event, over all pairs. Prints app/motion/scenes/pool_break_truth.h.

Equal balls, e = 1, no friction: in an impact the two exchange the components of velocity along the line of centres.
"""

from decimal import Decimal as D, getcontext

getcontext().prec = 60
DIAMETER, STEP, LOOKS = D(1), D("0.125"), 16


def start():
    balls = [((D(-3), D("0.0625")), (D(8), D(0)))]
    for row in range(5):
        for k in range(row + 1):
            balls.append(((D("0.890625") * row, D("1.03125") * (k - D(row) / 2)), (D(0), D(0))))
    return balls


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def along(p, v, t):
    return p[0] + t * v[0], p[1] + t * v[1]


def meet(a, b):
    """The time at which the two, moving straight, are a diameter apart and approach; None if never."""
    x, v = minus(a[0], b[0]), minus(a[1], b[1])
    closing, speed2 = dot(x, v), dot(v, v)
    if closing >= 0:
        return None
    left = closing * closing - speed2 * (dot(x, x) - DIAMETER * DIAMETER)
    return None if left < 0 else (dot(x, x) - DIAMETER * DIAMETER) / (-closing + left.sqrt())


def impact(balls, i, j):
    (p, v), (q, w) = balls[i], balls[j]
    n = minus(p, q)
    share = dot(minus(v, w), n) / dot(n, n)
    balls[i] = p, along(v, n, -share)
    balls[j] = q, along(w, n, share)


def run():
    """Returns the samples and the number of impacts."""
    balls, now, looks, impacts = start(), D(0), [], 0
    while len(looks) < LOOKS:
        meetings = [(meet(balls[i], balls[j]), i, j) for i in range(16) for j in range(i + 1, 16)]
        first = min((m for m in meetings if m[0] is not None), default=None)
        look = STEP * (len(looks) + 1)
        until = look if first is None or now + first[0] > look else now + first[0]
        balls = [(along(p, v, until - now), v) for p, v in balls]
        now = until
        if until == look:
            looks.append([p for p, _ in balls])
        else:
            impact(balls, *first[1:])
            impacts += 1
    return looks, impacts


if __name__ == "__main__":
    looks, impacts = run()
    print(f"""// Made by tests/app/motion/pool_break.py, which a test runs again: {impacts} impacts with 60 digits, rounded to doubles.
#pragma once

#include <array>

namespace touchstone::app {{

struct PoolBall {{
  double x = 0, y = 0;
}};

/// By sample, then by ball (m).
// clang-format off
inline constexpr std::array<std::array<PoolBall, 16>, {LOOKS}> pool_break_truth{{{{""")
    for positions in looks:
        print("  {{" + ", ".join("{%r, %r}" % (float(x), float(y)) for x, y in positions) + "}},")
    print("}};\n// clang-format on\n\n}  // namespace touchstone::app")
