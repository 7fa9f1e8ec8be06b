// The boxes that a subject declares to answer, for comparing what is larger than it must be.
#pragma once

#include "oracle/subject.h"

namespace touchstone::properties {

/// The bodies whose least boxes the subject declares to answer: with `of_turned_box` a hull becomes the box about it in
/// its own axes, and a compound the box about its parts in the body's axes. Balls and boxes are their own. With
/// `of_ball` each body becomes the ball about its box in its own axes: the subject's box is at most that of the ball.
Scene boxed(Scene scene, oracle::BoxKind kind);

/// How far apart the least boxes of a pair may be for the margin alone (m): each box may be larger by it.
inline double margin_of_a_pair(const oracle::Card& card) { return 2 * card.broad_phase_margin; }

/// Two answers about one set of bodies may differ in a free pair: its least boxes are apart, and the boxes that the
/// subject declares touch within rounding, or are apart by no more than its reach (m, rounding plus the margin of
/// a pair). Boxes that are only declared to be at most those of balls may overlap in one answer and not in the other.
/// declared_gap (m): negative for boxes that overlap.
bool is_free(bool least_apart, double declared_gap, double reach, const oracle::Card& card);

}  // namespace touchstone::properties
