// The boxes that a subject declares to answer, for comparing what is larger than it must be.
#pragma once

#include "oracle/subject.h"

namespace touchstone::properties {

/// The bodies whose least boxes the subject declares to answer: with `of_turned_box` a hull becomes the box about it in
/// its own axes, and a compound the box about its parts in the body's axes. Balls and boxes are their own. With
/// `of_ball` each body becomes the ball about its box in its own axes: the subject's box is at most that of the ball.
Scene boxed(Scene scene, oracle::BoxKind kind);

}  // namespace touchstone::properties
