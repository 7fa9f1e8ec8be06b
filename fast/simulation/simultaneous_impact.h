// Impacts at several contact points at one time: which act together, and the impulses (docs/design/simultaneous.md).
#pragma once

#include <functional>
#include <vector>

#include "fast/simulation/run.h"

namespace touchstone::fast::simulation {

/// The contacts that act together in one round: those that approach faster than `slow(a, b)` (m/s), and those of the
/// same two bodies with the normal of such a contact, which are parts of one contact region.
std::vector<PairPoints> acting(const std::vector<PairPoints>& contacts,
                               const std::function<double(BodyId, BodyId)>& slow);

/// Whether two bodies touch at one point and no contact of a third body acts with theirs, so that their impact is one
/// of a lone contact point: no event is due at this time, or no other body is near one of them that moves. u_n: the
/// normal velocity of the two (m/s), negative. Requires a < b.
bool acts_alone(Run& run, BodyId a, BodyId b, double u_n);

/// The contacts that act together with a pair that collides now, itself included: those of pairs within the envelope
/// that approach, connected to it through bodies that move, by contacts that approach or, if another one is due before
/// this one would cross the envelope, by any. Pairs that approach so slowly that they may stay together do not count.
/// `touch` is the contact point of the pair that approaches fastest, and `points` are all of them, empty if it is the
/// only one. Requires a < b and that islands of the two have been advanced to the current time.
std::vector<PairPoints> acting_with(Run& run, BodyId a, BodyId b, const Touch& touch,
                                    const std::vector<PairPoints>& points);

/// The point of the contact region of two bodies through which it acts, and the normal. With C this point, u the
/// velocities before and u' those after the impact at C, the mean u_n' + e u_n is least over the region at C: where it
/// is greater, no pressure is left at the end of compression. So a body that lands flat leaves flat, if its region is
/// wide enough. Without friction C is the centre of pressure of the compression (fast/simultaneous/round.h). With
/// friction it is found by iteration; if that does not converge, C is the best point found.
Touch centre_of_pressure(const Run& run, const PairPoints& points);

/// One round of impacts. A contact that shares no moving body with others is an impact at its centre of pressure, by
/// the law of the scene (impact.h). Others act at once, by fast/simultaneous/round.h, and each is recorded as one
/// impact at its centre of pressure, or with friction as one for each of its points; the velocities that are recorded
/// with it are those after this impulse and the ones before it.
void resolve_impacts(Run& run, const std::vector<PairPoints>& contacts);

}  // namespace touchstone::fast::simulation
