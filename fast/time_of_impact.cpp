#include "fast/time_of_impact.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "fast/lin_canny/nearest_parts.h"
#include "fast/time_of_impact/advance.h"
#include "fast/time_of_impact/first_contact.h"
#include "fast/time_of_impact/spheres.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

using Status = TimeOfImpact::Status;
using motion::RigidBodyModel;

/// Combines the results of two pairs of parts of the same bodies, neither of which is a miss.
FirstContact either(const FirstContact& x, const FirstContact& y) {
  const FirstContact& sooner = y.lo < x.lo ? y : x;
  const FirstContact& later = y.lo < x.lo ? x : y;
  FirstContact both = sooner;
  if (sooner.status == Status::hit && later.status == Status::hit) {
    both.hi = std::min(x.hi, y.hi);
  } else if (later.status == Status::hit) {
    both.status = Status::hit;
    both.hi = later.hi;
    both.p_WC = later.p_WC;
    both.nhat_BA_W = later.nhat_BA_W;
  } else if (sooner.status == Status::undecided) {
    both.hi = std::max(x.hi, y.hi);
    both.gap = std::min(x.gap, y.gap);
  }
  return both;
}

/// Gravity, plus the force that acts on the body when it starts, over its mass. Throws InputError if a force changes
/// before the motion ends: the trajectory would then have more than one ballistic segment.
Vec3 acceleration(const Scene& scene, int body, double since, const RigidBodyModel& model) {
  if (model.is_fixed) return Vec3::Zero();
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < scene.motion->forces.size(); ++i) {
    const AppliedForce& push = scene.motion->forces[i];
    if (push.body != body || push.time >= scene.motion->sample_times.back()) continue;
    if (push.time > since) {
      throw InputError("motion.forces[" + std::to_string(i) + "].time", "is after its body's start: ask from then on");
    }
    force = push.force_W;
  }
  return scene.gravity + force / model.mass;
}

struct Start {
  Start(const Scene& scene, int body)
      : model(scene.bodies[static_cast<std::size_t>(body)]), since(time(scene, body)), motion(made(scene, body)) {}

  static double time(const Scene& scene, int body) {
    const std::vector<double>& since = scene.motion->start_times;
    return since.empty() ? 0 : since[static_cast<std::size_t>(body)];
  }
  motion::BallisticMotion made(const Scene& scene, int body) const {
    const Body& b = scene.bodies[static_cast<std::size_t>(body)];
    return {model, since, b.X_WB, b.velocity, acceleration(scene, body, since, model)};
  }

  RigidBodyModel model;
  double since;
  motion::BallisticMotion motion;
};

/// Exact if both bodies start at the same time; otherwise only what doubles can prove.
Verdict verdict_at(double from, const Start& A, const Start& B, std::vector<lin_canny::FeaturePair>& memory) {
  using lin_canny::CachedPose;
  if (A.since == B.since) {
    const CachedPose at_A(A.motion.start()), at_B(B.motion.start());
    return nearest_parts(A.model.solid, at_A, B.model.solid, at_B, memory).proximity.verdict;
  }
  auto place = memory.begin();
  for (std::size_t i = 0; i < A.model.solid.parts().size(); ++i) {
    for (std::size_t j = 0; j < B.model.solid.parts().size(); ++j, ++place) {
      const time_of_impact::Pair pair{A.motion, B.motion, i, j, {A.motion.start().p_WB}};
      const time_of_impact::SeparationQuery query(pair, from, *place, Vec3::Zero());
      if (query.overlap(query)) return Verdict::overlapping;
    }
  }
  return Verdict::separated;
}

}  // namespace

FirstContact first_contact(const motion::BallisticMotion& a, const motion::BallisticMotion& b, double from,
                           double until, double envelope, std::span<lin_canny::FeaturePair> memory,
                           const Inflation& inflation) {
  if (inflation.is_none() && time_of_impact::are_falling_balls(a, b)) {
    if (const std::optional<FirstContact> met = time_of_impact::spheres(a, b, from, until, envelope)) return *met;
  }
  FirstContact met{Status::miss, until, until, 0, Vec3::Zero(), Vec3::Zero()};
  int queries = 0;
  bool is_cut_off = false;
  auto place = memory.begin();
  for (std::size_t i = 0; i < a.model().solid.parts().size(); ++i) {
    for (std::size_t j = 0; j < b.model().solid.parts().size(); ++j, ++place) {
      const time_of_impact::Pair pair{a, b, i, j, time_of_impact::origin(a, b), inflation};
      const double end = met.status == Status::hit ? met.hi : until;
      const FirstContact found = time_of_impact::advance(pair, from, end, envelope, *place);
      queries += found.queries;
      is_cut_off = is_cut_off || found.is_cut_off;
      if (found.status != Status::miss) met = met.status == Status::miss ? found : either(met, found);
    }
  }
  met.queries = queries;
  met.is_cut_off = is_cut_off && met.status == Status::undecided;
  return met;
}

FirstContact first_contact(const motion::BallisticMotion& a, const motion::BallisticMotion& b, double from,
                           double until, double envelope) {
  std::vector<lin_canny::FeaturePair> memory(lin_canny::pairs_of_parts(a.model().solid, b.model().solid));
  return first_contact(a, b, from, until, envelope, memory);
}

TimeOfImpact time_of_impact_of(const Scene& scene) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "expected two");
  if (!scene.motion) throw InputError("motion", "is missing");
  const Start A(scene, 0), B(scene, 1);
  const double from = std::max(A.since, B.since), until = scene.motion->sample_times.back();
  std::vector<lin_canny::FeaturePair> memory(lin_canny::pairs_of_parts(A.model.solid, B.model.solid));
  if (verdict_at(from, A, B, memory) == Verdict::overlapping) {
    throw InputError("bodies",
                     '\'' + scene.bodies[0].name + "' and '" + scene.bodies[1].name + "' overlap at the start");
  }
  const FirstContact met = first_contact(A.motion, B.motion, from, until, 0, memory);
  TimeOfImpact answer;
  answer.status = met.status;
  if (met.status == Status::miss) return answer;
  answer.enclosure = {met.lo, met.hi};
  // At lo only rounding separates the two; hi is where the overlap was proved, which is deeper than that.
  if (met.status == Status::hit) answer.time = met.lo;
  if (met.status == Status::undecided) answer.gap = met.gap;
  return answer;
}

}  // namespace touchstone::fast
