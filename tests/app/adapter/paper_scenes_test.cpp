// The closed forms of the scenes on paper against the exact reference, and the typical mistakes against their own
// hints.
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "app/adapter/paper/paper_scene.h"
#include "oracle/query.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/reference.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

constexpr double differs = std::numeric_limits<double>::infinity();

/// The greatest difference of two answers' numbers; infinite if they differ in anything else.
struct Off {
  template <class Expected, class Exact>
  double operator()(const Expected&, const Exact&) const {
    return differs;
  }

  static double vectors(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

  /// A part that the closed form leaves open is not compared.
  static double optional_vectors(const std::optional<Vec3>& expected, const std::optional<Vec3>& exact) {
    if (!expected) return 0;
    return exact ? vectors(*expected, *exact) : differs;
  }

  static double velocities(const Velocity& a, const Velocity& b) {
    return std::max(vectors(a.v_WBcm, b.v_WBcm), vectors(a.w_WB, b.w_WB));
  }

  static double rotations(const Quaternion& a, const Quaternion& b) {
    if (a == not_judged) return 0;
    const auto unit = [](const Quaternion& q) { return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized(); };
    return (unit(a).toRotationMatrix() - unit(b).toRotationMatrix()).cwiseAbs().maxCoeff();
  }

  double operator()(const Masses& expected, const Masses& exact) const {
    double off = expected.size() == exact.size() ? 0 : differs;
    for (std::size_t i = 0; i < std::min(expected.size(), exact.size()); ++i) {
      if (expected[i].has_value() != exact[i].has_value()) return differs;
      if (!expected[i]) continue;
      const double mass = exact[i]->mass;
      off = std::max({off, std::abs(expected[i]->mass / mass - 1), vectors(expected[i]->p_BBcm, exact[i]->p_BBcm),
                      (expected[i]->I_BBcm_B - exact[i]->I_BBcm_B).cwiseAbs().maxCoeff() / mass});
    }
    return off;
  }
  double operator()(const Bounds& expected, const Bounds& exact) const {
    double off = expected.size() == exact.size() ? 0 : differs;
    for (std::size_t i = 0; i < std::min(expected.size(), exact.size()); ++i) {
      off = std::max({off, vectors(expected[i].lo, exact[i].lo), vectors(expected[i].hi, exact[i].hi)});
    }
    return off;
  }
  double operator()(const PairSet& expected, const PairSet& exact) const { return expected == exact ? 0 : differs; }
  double operator()(const PairHistory& expected, const PairHistory& exact) const {
    const auto same_pairs = [](const PairFrame& a, const PairFrame& b) { return a.pairs == b.pairs; };
    return std::equal(expected.begin(), expected.end(), exact.begin(), exact.end(), same_pairs) ? 0 : differs;
  }
  double operator()(const Pixels& expected, const Pixels& exact) const { return expected == exact ? 0 : differs; }
  double operator()(const Distance& expected, const Distance& exact) const {
    if (expected.verdict != exact.verdict) return differs;
    return std::max({std::abs(*expected.distance - *exact.distance), optional_vectors(expected.p_WCa, exact.p_WCa),
                     optional_vectors(expected.p_WCb, exact.p_WCb)});
  }
  double operator()(const Penetration& expected, const Penetration& exact) const {
    if (expected.verdict != exact.verdict) return differs;
    return std::max(std::abs(*expected.depth - *exact.depth), optional_vectors(expected.nhat_BA_W, exact.nhat_BA_W));
  }
  double operator()(const Impulse& expected, const Impulse& exact) const {
    return std::max({velocities(expected.after[0], exact.after[0]), velocities(expected.after[1], exact.after[1]),
                     optional_vectors(expected.P_A_W, exact.P_A_W)});
  }
  double operator()(const TimeOfImpact& expected, const TimeOfImpact& exact) const {
    if (expected.status != exact.status) return differs;
    return expected.time ? std::abs(*expected.time - *exact.time) : 0;
  }
  double operator()(const Trajectory& expected, const Trajectory& exact) const {
    if (expected.states.size() != exact.states.size()) return differs;
    double off = 0;
    for (std::size_t t = 0; t < expected.states.size(); ++t) {
      if (expected.states[t].size() != exact.states[t].size()) return differs;
      for (std::size_t i = 0; i < expected.states[t].size(); ++i) {
        const State &a = expected.states[t][i], &b = exact.states[t][i];
        off = std::max({off, vectors(a.X_WB.p_WB, b.X_WB.p_WB), velocities(a.velocity, b.velocity),
                        rotations(a.X_WB.q_WB, b.X_WB.q_WB)});
      }
    }
    return off;
  }
};

/// The closed forms are evaluated in doubles with a few roundings of numbers below 1,000, so 2⁻⁴³ each. An impact of
/// the simulation may act within the envelope, 2⁻³⁰ of a size of about 1 m, before the contact, at speeds below 8 m/s;
/// what follows within 2 s is off by less than 1e-7.
double allowed(const std::string& query) { return query == "simulation" ? 1e-7 : 1e-11; }

TEST_CASE("adapter: each closed form is the exact answer") {
  const auto reference = oracle::subjects::make_reference();
  for (const oracle::Query& query : oracle::queries()) {
    for (const PaperScene& paper : paper_scenes(query.name)) {
      CAPTURE(query.name, paper.scene.name);
      std::visit(
          [&](auto ask) {
            const auto said = (*reference.*ask)(paper.scene);
            REQUIRE(said.index() == 0);
            CHECK(std::visit(Off{}, paper.expected, AnyAnswer(std::get<0>(said))) <= allowed(query.name));
          },
          query.ask);
    }
  }
}

TEST_CASE("adapter: some 40 scenes a query, fewer where fewer make sense") {
  for (const auto& [query, least] : std::vector<std::pair<std::string, std::size_t>>{{"mass", 35},
                                                                                     {"bounds", 35},
                                                                                     {"broad_phase", 20},
                                                                                     {"pair_history", 9},
                                                                                     {"distance", 40},
                                                                                     {"penetration", 40},
                                                                                     {"impulse", 40},
                                                                                     {"pixel", 15},
                                                                                     {"time_of_impact", 27},
                                                                                     {"simulation", 20},
                                                                                     {"constraint", 18}}) {
    CAPTURE(query);
    CHECK(paper_scenes(query).size() >= least);
  }
}

}  // namespace
}  // namespace touchstone::app
