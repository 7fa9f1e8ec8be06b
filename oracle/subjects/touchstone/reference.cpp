#include "oracle/subjects/touchstone/reference.h"

#include <cmath>
#include <utility>

#include "model/input_error.h"
#include "oracle/subject.h"
#include "oracle/subjects/common/engine.h"
#include "oracle/subjects/touchstone/reference_ball_orientation.h"
#include "reference/bounds.h"
#include "reference/broad_phase.h"
#include "reference/constraint.h"
#include "reference/distance.h"
#include "reference/impulse.h"
#include "reference/mass.h"
#include "reference/penetration.h"
#include "reference/pixel.h"
#include "reference/simulation.h"
#include "reference/time_of_impact.h"

namespace touchstone::oracle::subjects {
namespace {

/// A value that no double can represent is not reported, since any finite number would be a different value.
const Abstains beyond_doubles{"the exact value is beyond the range of doubles"};

/// A mass or inertia that underflows to 0 is out of range like one that overflows.
bool in_range(const MassProperties& m) {
  return m.mass > 0 && std::isfinite(m.mass) && m.p_BBcm.allFinite() && m.I_BBcm_B.allFinite() &&
         (m.I_BBcm_B.diagonal().array() > 0).all();
}

bool in_range(const Aabb& box) { return box.lo.allFinite() && box.hi.allFinite(); }

/// Rounds outward.
Aabb box_of(const reference::ExactBox& exact) {
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    box.lo[i] = exact.lo[axis].enclosure().lo;
    box.hi[i] = exact.hi[axis].enclosure().hi;
  }
  return box;
}

Vec3 nearest(const reference::ExactVec3& v) { return {v[0].nearest(), v[1].nearest(), v[2].nearest()}; }

bool in_range(const Velocity& velocity) { return velocity.v_WBcm.allFinite() && velocity.w_WB.allFinite(); }

/// The error of the truth itself plus the rounding of P to doubles.
double error_of(const reference::ImpulseTruth& truth, const Vec3& P) {
  reference::Rational square;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto off = [&](std::size_t k) {
        return reference::Rational(P[static_cast<Eigen::Index>(k)]) - truth.P_A_W[k];
      };
      square += off(i) * truth.K_W[i][j] * off(j);
    }
  }
  const double rounding = square.sqrt_enclosure().hi;
  return truth.error == 0 ? rounding : std::nextafter(rounding + truth.error, INFINITY);
}

Vec3 middle(const std::array<Interval, 3>& v) { return {v[0].middle(), v[1].middle(), v[2].middle()}; }

State state_of(const reference::BallTruth& truth, const Body& ball) {
  return {{middle(truth.p_WB), ball.X_WB.q_WB}, {middle(truth.v_WB), middle(truth.w_WB)}};
}

/// A is the body with the lower index.
Event event_of(const reference::ConstraintTruth::Change& change, const Scene& scene, int ball) {
  const Body& other = scene.bodies[static_cast<std::size_t>(change.other)];
  Event event{change.kind,
              change.time.middle(),
              ball,
              change.other,
              change.p_WC,
              change.nhat_W,
              change.P_W,
              state_of(change.after, scene.bodies[static_cast<std::size_t>(ball)]),
              {other.X_WB, other.velocity}};
  if (ball < change.other) return event;
  std::swap(event.a, event.b);
  std::swap(event.after_a, event.after_b);
  event.nhat_BA_W = -event.nhat_BA_W;
  event.P_A_W = -event.P_A_W;
  return event;
}

Trajectory trajectory_of(const reference::ConstraintTruth& truth, const Scene& scene) {
  Trajectory said;
  const auto ball = static_cast<std::size_t>(truth.ball);
  const std::vector<Quaternion> turned = orientations(truth, scene);
  for (std::size_t i = 0; i < truth.states.size(); ++i) {
    std::vector<State> states;
    for (const Body& body : scene.bodies) states.push_back({body.X_WB, body.velocity});
    states[ball] = state_of(truth.states[i], scene.bodies[ball]);
    states[ball].X_WB.q_WB = turned[i];
    said.states.push_back(std::move(states));
  }
  said.events.emplace();
  for (const auto& change : truth.changes) said.events->push_back(event_of(change, scene, truth.ball));
  return said;
}

class Reference : public Subject {
 public:
  const Card& card() const override { return card_; }

  Answer<Masses> mass(const Scene& scene) override {
    Masses said;
    for (const auto& truth : reference::mass(scene)) {
      said.push_back(truth ? std::optional(reference::nearest(*truth)) : std::nullopt);
      if (said.back() && !in_range(*said.back())) return beyond_doubles;
    }
    return said;
  }

  Answer<Bounds> bounds(const Scene& scene) override {
    Bounds said;
    for (const reference::ExactBox& exact : reference::bounds(scene)) {
      said.push_back(box_of(exact));
      if (!in_range(said.back())) return beyond_doubles;
    }
    return said;
  }

  Answer<PairSet> broad_phase(const Scene& scene) override { return reference::broad_phase(scene); }

  Answer<PairHistory> pair_history(const Scene& scene) override {
    return reference::pair_history(reference::sequence_bounds(scene));
  }

  Answer<Distance> distance(const Scene& scene) override {
    const reference::DistanceTruth truth = reference::distance(scene);
    Distance said;
    said.verdict = truth.verdict;
    if (!std::isfinite(truth.distance.hi)) return beyond_doubles;
    said.distance = truth.distance.middle();
    said.enclosure = truth.distance;
    if (truth.verdict == Verdict::overlapping) return said;
    said.p_WCa = truth.p_WCa;
    said.p_WCb = truth.p_WCb;
    said.feature_A = truth.feature_A;
    said.feature_B = truth.feature_B;
    return said;
  }

  Answer<Penetration> penetration(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    const reference::PenetrationTruth truth = reference::penetration(scene);
    Penetration said;
    said.verdict = truth.verdict;
    if (!std::isfinite(truth.depth.hi)) return beyond_doubles;
    said.depth = truth.depth.middle();
    if (truth.verdict == Verdict::overlapping) said.nhat_BA_W = truth.nhat_BA_W;
    return said;
  }

  Answer<Impulse> impulse(const Scene& scene) override {
    const reference::ImpulseTruth truth = reference::impulse(scene);
    Impulse said;
    for (std::size_t i = 0; i < 2; ++i) {
      said.after[i] = {nearest(truth.after[i].v_WBcm), nearest(truth.after[i].w_WB)};
      if (!in_range(said.after[i])) return beyond_doubles;
    }
    said.P_A_W = nearest(truth.P_A_W);
    if (!said.P_A_W->allFinite()) return beyond_doubles;
    said.error = error_of(truth, *said.P_A_W);
    if (!std::isfinite(*said.error)) return beyond_doubles;
    said.ambiguous = truth.ambiguous;
    return said;
  }

  Answer<Trajectory> constraint(const Scene& scene) override {
    try {
      return trajectory_of(reference::constraint(scene), scene);
    } catch (const InputError& outside) {
      return Abstains{outside.what()};
    }
  }

  Answer<Pixels> pixel(const Scene& scene) override { return reference::pixel(scene); }

  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override {
    const reference::TimeOfImpactTruth truth = reference::time_of_impact(scene);
    TimeOfImpact said;
    said.status = truth.status;
    if (truth.status == TimeOfImpact::Status::hit) said.time = truth.time.middle();
    if (truth.status != TimeOfImpact::Status::miss) said.enclosure = truth.time;
    if (truth.status == TimeOfImpact::Status::undecided && std::isfinite(truth.gap)) said.gap = truth.gap;
    return said;
  }

  Answer<Trajectory> simulation(const Scene& scene) override { return reference::simulation(scene); }

 private:
  const Card card_{.name = "reference",
                   .version = "0.1.0",
                   .precision = Precision::exact,
                   .answers = {"mass", "bounds", "broad_phase", "pair_history", "distance", "penetration", "impulse",
                               "pixel", "time_of_impact", "simulation", "constraint"},
                   .knows_touching = true,
                   .about = "Touchstone's exact reference, results rounded to doubles",
                   .homepage = "",
                   .deviations = {}};
};

}  // namespace

std::unique_ptr<Subject> make_reference() { return std::make_unique<Reference>(); }

}  // namespace touchstone::oracle::subjects
