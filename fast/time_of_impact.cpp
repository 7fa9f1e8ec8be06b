#include "fast/time_of_impact.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "fast/lin_canny/nearest_parts.h"
#include "fast/time_of_impact/advance.h"
#include "fast/time_of_impact/spheres.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

using Kind = TimeOfImpact::Meeting;
using motion::Flyer;

/// Of two pairs of parts of the same bodies, neither of which misses.
Meeting either(const Meeting& x, const Meeting& y) {
  const Meeting& sooner = y.lo < x.lo ? y : x;
  const Meeting& later = y.lo < x.lo ? x : y;
  Meeting both = sooner;
  if (sooner.meeting == Kind::hit && later.meeting == Kind::hit) {
    both.hi = std::min(x.hi, y.hi);
  } else if (later.meeting == Kind::hit) {
    both.meeting = Kind::hit;
    both.hi = later.hi;
    both.p_WC = later.p_WC;
    both.nhat_BA_W = later.nhat_BA_W;
  } else if (sooner.meeting == Kind::undecided) {
    both.hi = std::max(x.hi, y.hi);
    both.gap = std::min(x.gap, y.gap);
  }
  return both;
}

/// Gravity, and what pushes the body when it starts. Throws InputError where another push begins before the flight
/// ends: the body then flies in more than one piece.
Vec3 acceleration(const Scene& scene, int body, double since, const Flyer& flyer) {
  if (flyer.is_fixed) return Vec3::Zero();
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < scene.flight->pushes.size(); ++i) {
    const Push& push = scene.flight->pushes[i];
    if (push.body != body || push.time >= scene.flight->times.back()) continue;
    if (push.time > since) {
      throw InputError("flight.pushes[" + std::to_string(i) + "].time", "is after its body's start: ask from then on");
    }
    force = push.force_W;
  }
  return scene.gravity + force / flyer.mass;
}

struct Start {
  Start(const Scene& scene, int body)
      : flyer(scene.bodies[static_cast<std::size_t>(body)]), since(time(scene, body)), flight(made(scene, body)) {}

  static double time(const Scene& scene, int body) {
    const std::vector<double>& since = scene.flight->since;
    return since.empty() ? 0 : since[static_cast<std::size_t>(body)];
  }
  motion::Flight made(const Scene& scene, int body) const {
    const Body& b = scene.bodies[static_cast<std::size_t>(body)];
    return {flyer, since, b.X_WB, b.velocity, acceleration(scene, body, since, flyer)};
  }

  Flyer flyer;
  double since;
  motion::Flight flight;
};

/// Exact where both start at one time; else what doubles prove.
Verdict verdict_at(double from, const Start& A, const Start& B, std::vector<lin_canny::FeaturePair>& memory) {
  using lin_canny::Station;
  if (A.since == B.since) {
    const Station at_A(A.flight.start()), at_B(B.flight.start());
    return nearest_parts(A.flyer.solid, at_A, B.flyer.solid, at_B, memory).proximity.verdict;
  }
  auto place = memory.begin();
  for (std::size_t i = 0; i < A.flyer.solid.parts().size(); ++i) {
    for (std::size_t j = 0; j < B.flyer.solid.parts().size(); ++j, ++place) {
      const meeting::Pair pair{A.flight, B.flight, i, j, {A.flight.start().p_WB}};
      const meeting::Look look(pair, from, *place, Vec3::Zero());
      if (look.overlap(look)) return Verdict::overlapping;
    }
  }
  return Verdict::separated;
}

}  // namespace

Meeting time_of_impact(const motion::Flight& a, const motion::Flight& b, double from, double until, double envelope,
                       std::span<lin_canny::FeaturePair> memory, const Swelling& swelling) {
  if (swelling.is_none() && meeting::are_falling_balls(a, b)) {
    if (const std::optional<Meeting> met = meeting::spheres(a, b, from, until, envelope)) return *met;
  }
  Meeting met{Kind::miss, until, until, 0, Vec3::Zero(), Vec3::Zero()};
  int looks = 0;
  auto place = memory.begin();
  for (std::size_t i = 0; i < a.flyer().solid.parts().size(); ++i) {
    for (std::size_t j = 0; j < b.flyer().solid.parts().size(); ++j, ++place) {
      const meeting::Pair pair{a, b, i, j, meeting::origin(a, b), swelling};
      const double end = met.meeting == Kind::hit ? met.hi : until;
      const Meeting found = meeting::advance(pair, from, end, envelope, *place);
      looks += found.looks;
      if (found.meeting != Kind::miss) met = met.meeting == Kind::miss ? found : either(met, found);
    }
  }
  met.looks = looks;
  return met;
}

Meeting time_of_impact(const motion::Flight& a, const motion::Flight& b, double from, double until, double envelope) {
  std::vector<lin_canny::FeaturePair> memory(a.flyer().solid.parts().size() * b.flyer().solid.parts().size());
  return time_of_impact(a, b, from, until, envelope, memory);
}

TimeOfImpact time_of_impact_of(const Scene& scene) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "expected two");
  if (!scene.flight) throw InputError("flight", "is missing");
  const Start A(scene, 0), B(scene, 1);
  const double from = std::max(A.since, B.since), until = scene.flight->times.back();
  std::vector<lin_canny::FeaturePair> memory(A.flyer.solid.parts().size() * B.flyer.solid.parts().size());
  if (verdict_at(from, A, B, memory) == Verdict::overlapping) {
    throw InputError("bodies",
                     '\'' + scene.bodies[0].name + "' and '" + scene.bodies[1].name + "' overlap at the start");
  }
  const Meeting met = time_of_impact(A.flight, B.flight, from, until, 0, memory);
  TimeOfImpact said;
  said.meeting = met.meeting;
  if (met.meeting == Kind::miss) return said;
  said.enclosure = {met.lo, met.hi};
  // At lo rounding alone keeps the two apart; hi is where the overlap was proved, deeper than that.
  if (met.meeting == Kind::hit) said.time = met.lo;
  if (met.meeting == Kind::undecided) said.gap = met.gap;
  return said;
}

}  // namespace touchstone::fast
