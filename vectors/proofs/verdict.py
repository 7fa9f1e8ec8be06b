"""What a proof of an answer may say, and how it says it."""

import math
from fractions import Fraction


class Wrong(Exception):
    """An answer is not that of its scene."""


class InPart(Exception):
    """What is proved here of the answer holds; the docstring above says what that is."""


class Unproved(Exception):
    """Nothing here proves anything of the answer."""


def demand(holds, what):
    if not holds:
        raise Wrong(what)


def ends(interval):
    """Fractions; an end beyond the doubles is null in the file."""
    low, high = interval
    return -math.inf if low is None else Fraction(low), math.inf if high is None else Fraction(high)


def encloses(interval, low, high, what):
    demand(ends(interval)[0] <= low and high <= ends(interval)[1], what)


def near(a, b, scale, what):
    demand(all(abs(x - y) <= scale * Fraction(1, 2**44) for x, y in zip(a, b)), what)
