// The constraint-based time stepper that the lecture notes compare with impulses. It takes small steps, and in each
// solves for the contact forces that keep all bodies apart at once.
#pragma once

#include <optional>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// How finely time is cut, and how long a step is solved.
struct ConstraintOptions {
  std::optional<double> step = {};  ///< s, the longest short step (below); if absent, 1/4096 of the motion's duration
  int sweeps = 200;                 ///< most solver sweeps per step
};

/// A time stepper at the level of velocities (Moreau; Stewart and Trinkle 1996). In a step h it treats all contacts
/// within reach at once. With u = the relative velocity at a contact after the step and φ its gap before the step:
///   0 ≤ P_n ⟂ u_n + φ/h ≥ 0,     |P_t| ≤ μ P_n, and P_t = −μ P_n u_t/|u_t| where it slips.
/// A contact is an impact if P_n > 0 and its approach −u_n before the step exceeds what four steps of free fall
/// explain; it then has to separate with at least −e u_n (u_n before the step). Bodies without contact follow their
/// parabolas exactly. Other bodies move with their velocity after the step, so the error is of first order in h.
///
/// Bodies rest half an envelope apart, so that each contact's normal is the direction of a distance (fast/distance.h).
/// Bodies that overlap nevertheless are moved apart without gaining velocity. Events are emitted at the ends of steps:
/// the first impulse of a pair is an `impact` if weight alone does not explain it; `contact` is emitted once when the
/// pair presses on in the next step, and again when its slip begins or ends; its separation emits `release`. A change
/// of an applied force emits its event at the beginning of the first step that does not begin before it.
///
/// A ball that is the only body that moves, without applied forces, takes long steps too: up to 256 times as long, in
/// which no contact force changes, so that the method has no error of first order. What changes is found in a short
/// step.
///
/// Requires a valid scene with a motion and polytopes with faces. Throws InputError for compounds, bodies that start
/// late, bodies that overlap at the start, and more than 2²⁴ steps. Cost: 2 µs a step for a ball on a table, which
/// takes some 20 to 200 steps.
Trajectory constrained(const Scene& scene, const ConstraintOptions& options = {});

}  // namespace touchstone::fast
