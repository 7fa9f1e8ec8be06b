"""Proves the answers of the test vectors beside this file again, in exact arithmetic, without Touchstone.

    python3 check_vectors.py [QUERY...]

Everything here is recomputed from the scenes with Python's whole numbers and fractions, by other methods than those of
the program that wrote the files. It says for each query how many answers are proved as a whole, how many in part, and
how many not at all; the exit code is 1 if one is wrong.

    mass            as a whole: the integrals over tetrahedra; π to 60 digits
    bounds          as a whole: the extreme vertices
    broad_phase     as a whole: all pairs of boxes, in each frame
    distance        as a whole: the certificates, one for each pair of parts
    penetration     as a whole: the least of all directions in which a polytope's shadow ends; or the certificate
    pixel           in part: the masks of each body and their overlap, not where the bodies meet
    impulse         in part: momentum, the friction cone, restitution (not Stronge's), energy, parting
    time_of_impact  as a whole, within 2^-40 of the scale, where neither body turns: a plane separates them until then
    simulation      in part: the free motion of each body before its first event
    constraint      in part: the motion from one change of mode to the next and to the samples, not the impulses
"""

import sys

from proofs.ball import check_constraint
from proofs.boxes import check_bounds, check_broad_phase
from proofs.depth import check_penetration
from proofs.distance import check_distance
from proofs.impulse import check_impulse
from proofs.mass import check_mass
from proofs.motion import check_simulation, check_time_of_impact
from proofs.pixel import check_pixel
from proofs.verdict import InPart, Unproved, Wrong
from read_vectors import QUERIES, vectors


CHECKS = {"mass": check_mass, "bounds": check_bounds, "broad_phase": check_broad_phase, "distance": check_distance,
          "penetration": check_penetration, "pixel": check_pixel, "impulse": check_impulse,
          "time_of_impact": check_time_of_impact, "simulation": check_simulation, "constraint": check_constraint}


def check_query(query):
    """How many answers are proved as a whole, in part and not at all; and what is wrong."""
    counts, wrong = [0, 0, 0], []
    for test in vectors(query):
        try:
            CHECKS[query](test["scene"], test["answer"])
            counts[0] += 1
        except InPart:
            counts[1] += 1
        except Unproved:
            counts[2] += 1
        except Wrong as error:
            wrong.append(f"{test['id']}: {error}")
    return counts, wrong


def main(queries):
    failed = False
    for query in queries:
        (whole_, part, none), wrong = check_query(query)
        failed = failed or wrong
        print(f"{query:<16}{whole_ + part + none + len(wrong):5} vectors: {whole_} proved, {part} in part, "
              f"{none} not, {len(wrong)} wrong")
        for line in wrong:
            print(f"  {line}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:] or QUERIES))
