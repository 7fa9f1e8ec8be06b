#include "oracle/judge/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/infinity.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "reference/certificate.h"

namespace touchstone::oracle::judge {
namespace {

bool finite(double x) { return std::isfinite(x); }
bool finite(const Vec3& v) { return v.allFinite(); }
bool finite(const Interval& i) { return finite(i.lo) && finite(i.hi); }
bool finite(const Velocity& V) { return finite(V.v_WBcm) && finite(V.w_WB); }
bool finite(const Quaternion& q) { return finite(q.w) && finite(q.x) && finite(q.y) && finite(q.z); }
bool finite(const State& state) { return finite(state.X_WB.p_WB) && finite(state.X_WB.q_WB) && finite(state.velocity); }
bool finite(const Event& event) {
  return finite(event.time) && finite(event.p_WC) && finite(event.nhat_BA_W) && finite(event.P_A_W) &&
         finite(event.after_a) && finite(event.after_b);
}
template <class T>
bool finite(const std::optional<T>& said) {
  return !said || finite(*said);
}

Defect defect_of(Breaks::Kind kind) {
  switch (kind) {
    case Breaks::Kind::threw:
      return Defect::threw;
    case Breaks::Kind::refused:
      return Defect::refused;
    case Breaks::Kind::crashed:
      return Defect::crashed;
    case Breaks::Kind::hung:
      return Defect::hung;
    case Breaks::Kind::garbage:
      return Defect::garbage;
  }
  return Defect::garbage;
}

bool is_compound(const Body& body) { return std::holds_alternative<Compound>(body.shape); }

// The union of the parts' differences contains the ball of radius r − |d*|, or that of the certificate's radius plus r.
double least_compound_depth(const Scene& scene, const reference::DistanceTruth& truth) {
  const double r = truth.radius_sum.nearest();
  if (truth.certificate.cores != Verdict::overlapping) return r - truth.core_squared.sqrt_enclosure().hi;
  return reference::inner_radius(truth.certificate, scene) + r;
}

}  // namespace

bool finite(const Masses& answer) {
  return std::ranges::all_of(answer, [](const std::optional<MassProperties>& m) {
    return !m || (finite(m->mass) && finite(m->p_BBcm) && m->I_BBcm_B.allFinite());
  });
}
bool finite(const Bounds& answer) {
  return std::ranges::all_of(answer, [](const Aabb& box) { return finite(box.lo) && finite(box.hi); });
}
bool finite(const PairSet&) { return true; }
bool finite(const PairHistory&) { return true; }
bool finite(const Distance& answer) {
  return finite(answer.distance) && finite(answer.p_WCa) && finite(answer.p_WCb) && finite(answer.enclosure);
}
bool finite(const Penetration& answer) { return finite(answer.depth) && finite(answer.nhat_BA_W); }
bool finite(const Impulse& answer) {
  return finite(answer.P_A_W) && finite(answer.error) && finite(answer.ambiguous) &&
         std::ranges::all_of(answer.after, [](const Velocity& v) { return finite(v); });
}
bool finite(const Pixels&) { return true; }
bool finite(const TimeOfImpact& answer) {
  return finite(answer.time) && finite(answer.enclosure) && finite(answer.gap);
}
bool finite(const Trajectory& answer) {
  const auto of_bodies = [](const std::vector<State>& bodies) {
    return std::ranges::all_of(bodies, [](const State& state) { return finite(state); });
  };
  const auto event = [](const Event& e) { return finite(e); };
  return std::ranges::all_of(answer.states, of_bodies) && finite(answer.complete_until) &&
         (!answer.events || std::ranges::all_of(*answer.events, event));
}

Finding holds() { return {}; }

Finding outside(std::string why) {
  Finding finding;
  finding.outcome = Outcome::outside;
  finding.why = std::move(why);
  return finding;
}

Finding silent(const std::string& about_what) {
  Finding finding;
  finding.outcome = Outcome::abstains;
  finding.why = "does not say " + about_what;
  return finding;
}

Finding broken(const Breaks& breaks) {
  Finding finding;
  finding.outcome = Outcome::breaks;
  finding.defect = defect_of(breaks.kind);
  finding.why = breaks.how;
  return finding;
}

Finding not_a_number() { return wrong(Defect::not_finite, "NaN or infinity", "finite numbers"); }

Finding wrong(Defect defect, std::string observed, std::string expected) {
  Finding finding;
  finding.outcome = Outcome::fails;
  finding.defect = defect;
  finding.observed = std::move(observed);
  finding.expected = std::move(expected);
  finding.error = 1;
  finding.unit = without_size;
  return finding;
}

Finding wrong_by(double error, const Allowance& allowance, Defect defect, std::string observed, std::string expected) {
  Finding finding = wrong(defect, std::move(observed), std::move(expected));
  finding.error = error / allowance.unit;
  finding.allowed = allowance.bound / allowance.unit;
  finding.unit = allowance.unit_name;
  measure(finding, error, allowance);
  return finding;
}

Allowance in_ulps(const Scene& scene, const Card& card, double allowed) {
  Allowance allowance;
  allowance.bound = allowed;
  allowance.unit = std::max(tolerance::ulp(scene, card.precision), std::numeric_limits<double>::denorm_min());
  allowance.body = infinity;
  for (const Body& body : scene.bodies) allowance.body = std::min(allowance.body, tolerance::size(body));
  return allowance;
}

void measure(Finding& finding, double error, const Allowance& allowance) {
  if (allowance.body > 0) finding.of_body = error / allowance.body;
  if (allowance.value > 0) finding.relative = error / allowance.value;
}

Finding near(double claimed, const Interval& truth, const Allowance& allowance, Defect below, Defect above) {
  const double under = truth.lo - claimed, over = claimed - truth.hi, error = std::max({under, over, 0.0});
  Finding finding = at_most(
      error, allowance, under > over ? below : above, [&] { return words::text(claimed); },
      [&] { return words::text(truth); });
  if (finding.outcome == Outcome::fails && !finding.relative) {
    const double least = std::max({truth.lo, -truth.hi, 0.0});  // of the truth's absolute values
    finding.relative = least > 0 ? error / least : infinity;
  }
  return finding;
}

bool is_held_to_touching(const Card& card) { return card.knows_touching || card.precision == Precision::exact; }

double verdict_allowance(const Scene& scene, const Card& card) {
  if (is_held_to_touching(card)) return 0;
  return tolerance::distance(scene, card.precision) + card.distance_tolerance.of(0);
}

Interval margin(const Scene& scene) {
  const reference::DistanceTruth& truth = truth::distance(scene);
  if (truth.verdict != Verdict::overlapping) return truth.distance;
  if (!is_compound(scene.bodies[0]) && !is_compound(scene.bodies[1])) return truth::penetration(scene).depth;
  return {least_compound_depth(scene, truth), infinity};
}

double overlap(const Scene& scene) {
  return truth::distance(scene).verdict == Verdict::overlapping ? margin(scene).lo : 0;
}

Finding verdict(const Scene& scene, const Card& card, Verdict said) {
  const Verdict truth = truth::distance(scene).verdict;
  if (said == truth) return holds();
  const double misjudged = margin(scene).lo;
  const double allowed = verdict_allowance(scene, card);
  if (misjudged <= allowed && !is_held_to_touching(card)) return holds();
  const Defect defect = said == Verdict::separated || truth == Verdict::overlapping ? Defect::missed : Defect::phantom;
  const Allowance allowance = in_ulps(scene, card, allowed);
  return explained(wrong_by(misjudged, allowance, defect, words::text(said), words::text(truth)), scene);
}

Finding explained(Finding finding, const Scene& scene) {
  if (finding.outcome != Outcome::fails) return finding;
  const reference::DistanceTruth& truth = truth::distance(scene);
  finding.margin = margin(scene);
  finding.certificate = words::text(truth.certificate);
  return finding;
}

double off_body(const Body& body, const Vec3& p_W) { return reference::distance_to_body(body, p_W).hi; }

double depth_left(const Scene& scene, const Vec3& translation) { return reference::depth_after(scene, translation).hi; }

}  // namespace touchstone::oracle::judge
