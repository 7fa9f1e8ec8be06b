#include "oracle/truth/truth.h"

#include <cstddef>
#include <list>
#include <string>
#include <utility>

#include "model/input_error.h"
#include "reference/broad_phase.h"
#include "reference/convex_hull.h"
#include "reference/validity.h"

namespace touchstone::oracle::truth {
namespace {

/// The answers to the last few questions, the most recent first.
template <class Truth, std::size_t capacity = remembered>
class Memory {
 public:
  template <class Compute>
  const Truth& of(const Scene& scene, Compute&& compute) {
    for (auto it = entries_.begin(); it != entries_.end(); ++it) {
      if (it->first == scene) {
        entries_.splice(entries_.begin(), entries_, it);
        return it->second;
      }
    }
    entries_.emplace_front(scene, compute(scene));
    if (entries_.size() > capacity) entries_.pop_back();
    return entries_.front().second;
  }

 private:
  std::list<std::pair<Scene, Truth>> entries_;
};

}  // namespace

const std::vector<std::optional<reference::MassTruth>>& mass(const Scene& scene) {
  thread_local Memory<std::vector<std::optional<reference::MassTruth>>> memory;
  return memory.of(scene, [](const Scene& s) { return reference::mass(s); });
}

const std::vector<reference::ExactBox>& bounds(const Scene& scene) {
  thread_local Memory<std::vector<reference::ExactBox>> memory;
  return memory.of(scene, [](const Scene& s) { return reference::bounds(s); });
}

const PairSet& broad_phase(const Scene& scene) {
  thread_local Memory<PairSet> memory;
  return memory.of(scene, [](const Scene& s) { return reference::broad_phase(s); });
}

const std::vector<reference::FrameBoxes>& sequence_bounds(const Scene& sequence) {
  thread_local Memory<std::vector<reference::FrameBoxes>> memory;
  return memory.of(sequence, [](const Scene& s) { return reference::sequence_bounds(s); });
}

const PairHistory& pair_history(const Scene& sequence) {
  thread_local Memory<PairHistory> memory;
  return memory.of(sequence, [](const Scene& s) { return reference::pair_history(sequence_bounds(s)); });
}

const reference::DistanceTruth& distance(const Scene& scene) {
  thread_local Memory<reference::DistanceTruth> memory;
  return memory.of(scene, [](const Scene& s) { return reference::distance(s); });
}

const reference::PenetrationTruth& penetration(const Scene& scene) {
  thread_local Memory<reference::PenetrationTruth> memory;
  return memory.of(scene, [](const Scene& s) { return reference::penetration(s); });
}

const reference::ImpulseTruth& impulse(const Scene& scene) {
  thread_local Memory<reference::ImpulseTruth> memory;
  return memory.of(scene, [](const Scene& s) { return reference::impulse(s, reference::Digits::some); });
}

std::array<double, reference::impact_conditions> impact_condition_errors(const reference::ReportedImpacts& reported) {
  return reference::condition_errors(reported);
}

const ConstraintOrWhy& constraint(const Scene& scene) {
  thread_local Memory<ConstraintOrWhy> memory;
  return memory.of(scene, [](const Scene& s) -> ConstraintOrWhy {
    try {
      return reference::constraint(s);
    } catch (const InputError& outside) {
      return outside.what();
    }
  });
}

const reference::TimeOfImpactTruth& time_of_impact(const Scene& scene) {
  thread_local Memory<reference::TimeOfImpactTruth, remembered_motions> memory;
  return memory.of(scene, [](const Scene& s) { return reference::time_of_impact(s); });
}

// The key is the scene with the body and the time of the question in it.
const reference::BallisticTruth& ballistic_state(const Scene& scene, std::size_t body, double time) {
  thread_local Memory<reference::BallisticTruth, remembered_motions> memory;
  Scene question = scene;
  question.name = std::to_string(body);
  question.motion->sample_times = {time};
  return memory.of(question, [&](const Scene&) { return reference::ballistic_state(scene, body, time); });
}

// The key is the scene with the two numbers of the question in fields that have no effect on the answer.
const reference::TimeOfImpactTruth& time_of_distance(const Scene& scene, double apart, double from) {
  thread_local Memory<reference::TimeOfImpactTruth, remembered_motions> memory;
  Scene question = scene;
  question.motion->envelope = apart;
  question.motion->force_bound = from;
  return memory.of(question, [&](const Scene&) { return reference::time_of_distance(scene, apart, from); });
}

const Pixels& pixel(const Scene& scene) {
  thread_local Memory<Pixels> memory;
  return memory.of(scene, [](const Scene& s) { return reference::pixel(s); });
}

bool projection_comes_near(const Scene& scene, std::size_t body, int column, int row, int around) {
  return reference::projection_comes_near(scene, body, column, row, around);
}

bool depths_come_near(const Scene& scene, int column, int row, int around, double apart) {
  return reference::depths_come_near(scene, column, row, around, apart);
}

Polytope convex_hull(const std::vector<Vec3>& points) { return reference::convex_hull(points); }

Scene completed(Scene scene) { return reference::completed(std::move(scene)); }

}  // namespace touchstone::oracle::truth
