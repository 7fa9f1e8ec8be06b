// One step of the bodies of an island: how long it is, where it leads, and how well trajectories represent it.
#pragma once

#include "fast/simulation/island/contact_graph.h"

namespace touchstone::fast::simulation {

std::vector<contact::StepBody> step_bodies(const ContactGraph& graph);
std::vector<contact::ContactConstraint> constraints(const ContactGraph& graph);

struct StepPlan {
  double h = 0;  ///< s
  contact::Stepped stepped;
  std::vector<contact::ContactConstraint> constraints;  ///< with the impulses of the step
};

/// The longest step (s): one of `steps` while a body falls by its size, turns by a radian or moves by its size, and at
/// most `most`.
double step_length(const ContactGraph& graph, double steps, double most);

/// A step of h. Bodies that overlap are moved apart no faster than in a step of max(h, longest).
StepPlan solve_step(const ContactGraph& graph, double h, double longest);

/// A step of h, or a shorter one that ends where the first contact stops slipping, where one that slips stops pressing,
/// where the first corner not yet in contact comes down, or where the first part slides off another (at most h/2¹⁴
/// later).
StepPlan plan_step(const ContactGraph& graph, double h, double longest);

/// m; what the residual of a step should not exceed.
double accuracy(const ContactGraph& graph);

/// The greatest residual with which the step, and not the solver, determines the error (m). A step of second order in
/// which bodies move by 1/`steps` of their size has a local error of the order of size/steps³. The bound is not less
/// than the distance at which bodies touch; and rounding of positions adds to a gap.
double residual_bound(const ContactGraph& graph, double steps);

/// m; the greatest depth of two parts at the end of the step.
double deepest(const ContactGraph& graph, const StepPlan& plan);

/// How far bodies leave the trajectories with which a step is represented: parabolas and steady turns, although forces
/// and angular velocities change within the step.
struct StepDeviation {
  double margin = 0;        ///< m
  double acceleration = 0;  ///< m/s²; of balls: they begin to leave them no faster
};

/// Estimates. Within a step a normal force may vanish or double, and friction may change its direction.
StepDeviation deviation(const ContactGraph& graph, const StepPlan& plan);

}  // namespace touchstone::fast::simulation
