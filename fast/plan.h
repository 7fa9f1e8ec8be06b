// Which parts of the broad phase a scene needs, and which it can do without.
#pragma once

#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// How a body's tight box is found; each obeys the law of fast/bounds.h.
enum class BoundKind {
  closed_form,  ///< spheres, boxes and compounds of them
  scan,         ///< all vertices
  climb         ///< the six extremal vertices of the frame before (fast/bounds/tight_box.h)
};

/// What is used or left out, and why: words for people, with the figure that decided.
struct Choice {
  std::string what;
  std::string why;
};

struct Plan {
  std::string strategy;           ///< a name of fast/broad_phase/strategies.h
  std::vector<BoundKind> bounds;  ///< by body
  std::vector<Choice> used;
  std::vector<Choice> left_out;
};

/// Leaving out changes no pair beyond the law of the boxes: a pair whose exact boxes meet is told under every plan, and
/// one that only some plans tell is apart by no more than the widening of its two boxes.
///
/// The thresholds are measured (docs/design/broad_phase.md). Requires a valid scene.
Plan plan(const Scene& scene);

/// Adds what a simulation of the scene's flight needs, and what it can do without: no state changes a bit where
/// meetings have closed forms. Else each impact is still one within the envelope, but at another bit of it, and what
/// follows it may grow apart as all motion does. Throws InputError where a shape is no solid.
void plan_motion(const Scene& scene, Plan& plan);

/// Nothing left out: every shape that has vertices climbs, and the strategy is the default for many bodies.
Plan all_parts(const Scene& scene);

/// Which boxes meet in each frame of a film (model/film.h), by a plan for it. Throws InputError for coordinates that
/// the strategies do not serve (beyond 2^1000).
PairHistory pair_history(const Scene& film, const Plan& plan);

}  // namespace touchstone::fast
