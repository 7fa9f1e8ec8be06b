"""Reads the test vectors beside this file. It needs nothing else; copy both where you like.

    python3 read_vectors.py          how many vectors there are
    from read_vectors import vectors, nearest, is_allowed
    for test in vectors("distance"):
        said = my_engine_distance(test["scene"])
        assert is_allowed(said, test["answer"]["distance_enclosure"], test["allowed"]["binary64"]), test["id"]
"""

import fractions
import json
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent
QUERIES = ("mass bounds broad_phase distance penetration pixel impulse time_of_impact simulation constraint").split()


def vectors(query):
    """The list of the test vectors of a query: objects with id, classes, source, scale, scene and answer."""
    return json.loads((FOLDER / f"{query}.json").read_text())["tests"]


def exact(text):
    """A rational number, written as in "exact": "-3/4"."""
    return fractions.Fraction(text)


def is_allowed(said, enclosure, allowed):
    """Is a number within `allowed` of an interval that contains the exact one? Computed without rounding."""
    low, high = (fractions.Fraction(end) for end in enclosure)
    return low - fractions.Fraction(allowed) <= fractions.Fraction(said) <= high + fractions.Fraction(allowed)


if __name__ == "__main__":
    for query in QUERIES:
        print(f"{query:<16}{len(vectors(query)):5} vectors")
