// How a body comes to rest on another one in closed form, and how that ends.
#pragma once

#include "fast/simulation/run.h"

namespace touchstone::fast::simulation {

/// A body that may start to rest on another one.
struct RestCandidate {
  BodyId id = 0, on = 0;
  Vec3 nhat_W = Vec3::Zero();  ///< towards the body
  State state;                 ///< at rest relative to the support along n̂
};

/// The body of the pair that may rest on the other one, now. None unless exactly one of them is fixed.
std::optional<RestCandidate> rest_candidate(const World& world, BodyId a, BodyId b, const Touch& touch);

/// Its resting contact, if that has a closed form. `load`: the mean contact force relative to the weight.
std::optional<RestingContact> closed_form_rest(const World& world, const RestCandidate& candidate, double load);

/// Starts the resting contact of the candidate, `rest`, and records it as a contact event. `v_before`: the body's
/// velocity before.
void start_rest(Run& run, const RestCandidate& candidate, const RestingContact& rest, const Vec3& v_before);

/// The same, if the candidate has a closed form, but records nothing if micro-bounces remain, which end at `until` (s).
bool try_rest(Run& run, const RestCandidate& candidate, const Vec3& v_before, const MicroBounces& bounces,
              double until);

/// A resting contact ends or changes: its micro-bounces are over, slip ends, or the contact point leaves the face.
void end_rest_phase(Run& run, BodyId id);

/// If micro-bounces of the body are under way, reports those until now as completed. Called before another event ends
/// them early, since the body was not in ballistic motion since they began.
void sum_up_bounces(Run& run, BodyId id);

/// The body, which rests, does no longer. Records the event, with the body's state; changes no trajectory.
void release_rest(Run& run, BodyId id, const State& state);

}  // namespace touchstone::fast::simulation
