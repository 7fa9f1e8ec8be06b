// Chooses the parts of the broad phase that a scene needs, and says why the others are left out.
#pragma once

#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// How a body's tight box is computed; each way obeys the law of fast/bounds.h.
enum class BoundKind {
  closed_form,  ///< spheres, boxes and compounds of them
  scan,         ///< all vertices
  climb         ///< the six extremal vertices, starting from those of the previous frame (fast/bounds/tight_box.h)
};

/// What is used or left out, and why: text for users, with the figure that decided.
struct Choice {
  std::string what;
  std::string why;
};

/// The parts chosen for a scene.
struct Plan {
  std::string strategy;           ///< a name of fast/broad_phase/strategies.h
  std::vector<BoundKind> bounds;  ///< indexed by body
  std::vector<Choice> used;
  std::vector<Choice> left_out;
};

/// Leaving parts out changes no pair beyond the law of the boxes: every plan reports a pair whose exact boxes overlap,
/// and a pair that only some plans report is apart by no more than the widening of its two boxes.
///
/// The thresholds are measured (docs/measured/plan.md). Requires a valid scene.
Plan plan(const Scene& scene);

/// Adds what a simulation of the scene's motion needs and what it can omit. If all times of impact have closed forms,
/// omissions change no bit of any state. Otherwise each impact is still within the envelope, but differs in its last
/// bits, and the motion after it may diverge as all motion does. Throws InputError if a shape is not a solid.
void plan_motion(const Scene& scene, Plan& plan);

/// The plan that leaves nothing out: every shape with vertices climbs, and the strategy is the default for many bodies.
Plan all_parts(const Scene& scene);

/// Computes which boxes overlap in each frame of a sequence of poses (model/sequence.h), by a plan for it. Throws
/// InputError for coordinates beyond the strategies' limit of 2^1000.
PairHistory pair_history(const Scene& sequence, const Plan& plan);

}  // namespace touchstone::fast
