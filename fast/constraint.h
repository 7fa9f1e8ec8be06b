// The constraint-based alternative that the lecture notes compare impulses with: small steps, and in each the contact
// forces that keep all bodies apart at once.
#pragma once

#include <optional>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

struct ConstraintOptions {
  std::optional<double> step = {};  ///< s, at most; none: 1/4096 of the flight
  int sweeps = 200;                 ///< of the solver a step, at most
};

/// A time-stepper at the level of velocities (Moreau; Stewart and Trinkle 1996). In a step h, for all contacts within
/// its reach at once, with u = the relative velocity at a contact after the step and φ its gap before:
///   0 ≤ P_n ⟂ u_n + φ/h ≥ 0,     |P_t| ≤ μ P_n, and P_t = −μ P_n u_t/|u_t| where it slips.
/// A contact that is hit (P_n > 0, and before the step u_n < 0 by more than four steps of free fall explain) has to
/// part with u_n ≥ −e u_n before. Bodies that nothing touches move on their parabolas exactly; others with their
/// velocity after the step: first order in h.
///
/// Bodies rest half an envelope apart, so that each contact's normal is that of a distance (fast/distance.h); what
/// overlaps all the same is moved apart without a velocity. Events are told at the ends of steps: a pair's first
/// impulse is an `impact` if weight alone does not explain it, `contact` as it goes on or as slip begins or ends, then
/// `release`; a push where it begins to act, at the first beginning of a step that is not before it.
///
/// Requires a valid scene with a flight, polytopes with faces. Throws InputError for compounds, bodies that start late,
/// bodies that overlap at the start, and more than 2²⁴ steps. Cost: 2 µs a step for a ball on a table.
Trajectory constrained(const Scene& scene, const ConstraintOptions& options = {});

}  // namespace touchstone::fast
