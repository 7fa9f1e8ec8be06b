#include "app/adapter/compare.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "oracle/rotation.h"

namespace touchstone::app {
namespace {

std::string words(double x) { return fmt::format("{:.6g}", x); }
std::string words(const Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z()); }
std::string words(Verdict verdict) {
  return verdict == Verdict::separated ? "separated" : verdict == Verdict::touching ? "touching" : "overlapping";
}
std::string words(TimeOfImpact::Status status) {
  using Status = TimeOfImpact::Status;
  return status == Status::hit ? "hit" : status == Status::miss ? "miss" : "undecided";
}
std::string words(const PairSet& pairs) {
  std::string all;
  for (const auto& [i, j] : pairs) all += fmt::format("{}[{}, {}]", all.empty() ? "" : ", ", i, j);
  return all.empty() ? "no pair" : all;
}

/// Keeps the first complaint.
class Complaint {
 public:
  template <class T>
  void unless(bool fine, const std::string& part, const T& expected, const T& said) {
    if (!fine && text_.empty()) text_ = fmt::format("{}: {}, expected {}", part, words(said), words(expected));
  }
  void unless(bool fine, const std::string& complaint) {
    if (!fine && text_.empty()) text_ = complaint;
  }

  void near(const std::string& part, double expected, double said, double allowed) {
    unless(std::abs(said - expected) <= allowed, part, expected, said);
  }
  void near(const std::string& part, const Vec3& expected, const Vec3& said, double allowed) {
    unless((said - expected).norm() <= allowed, part, expected, said);
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

double of_length(double expected) { return 0.01 + 1e-3 * std::abs(expected); }
double of_point(const Vec3& expected) { return 0.01 + 1e-3 * expected.norm(); }
double of_velocity(const Vec3& expected) { return 0.02 + 1e-2 * expected.norm(); }

constexpr double of_direction = 0.1;
constexpr double of_rotation = 0.02;
constexpr double of_stepped_place = 0.1;
constexpr double of_stepped_velocity = 0.2;

std::string of_body(const std::string& part, std::size_t body) { return fmt::format("{} of body {}", part, body); }

struct Compare {
  Complaint& complaint;

  template <class Expected, class Said>
  void operator()(const Expected&, const Said&) const {
    complaint.unless(false, "the answer is one to another query");
  }

  void operator()(const Masses& expected, const Masses& said) const {
    complaint.unless(expected.size() == said.size(), "not one entry for each body");
    for (std::size_t i = 0; i < std::min(expected.size(), said.size()); ++i) {
      complaint.unless(expected[i].has_value() == said[i].has_value(),
                       expected[i] ? "null, expected the body's mass" : "a mass, expected null for a fixed body");
      if (!expected[i] || !said[i]) continue;
      const Mat3& I = expected[i]->I_BBcm_B;
      const double size = std::sqrt(I.trace() / expected[i]->mass);
      complaint.near("mass", expected[i]->mass, said[i]->mass, 1e-3 * expected[i]->mass);
      complaint.near("p_BBcm", expected[i]->p_BBcm, said[i]->p_BBcm, 1e-3 * size);
      complaint.near("moments of inertia", Vec3(I.diagonal()), Vec3(said[i]->I_BBcm_B.diagonal()), 1e-3 * I.trace());
      const auto products = [](const Mat3& m) { return Vec3(m(1, 2), m(2, 0), m(0, 1)); };
      complaint.near("products of inertia yz, zx, xy", products(I), products(said[i]->I_BBcm_B), 1e-3 * I.trace());
    }
  }

  void operator()(const Bounds& expected, const Bounds& said) const {
    complaint.unless(expected.size() == said.size(), "not one box for each body");
    for (std::size_t i = 0; i < std::min(expected.size(), said.size()); ++i) {
      complaint.near(of_body("lo", i), expected[i].lo, said[i].lo, of_point(expected[i].lo));
      complaint.near(of_body("hi", i), expected[i].hi, said[i].hi, of_point(expected[i].hi));
    }
  }

  void operator()(const PairSet& expected, const PairSet& said) const {
    complaint.unless(expected == said, "pairs", expected, said);
  }

  void operator()(const PairHistory& expected, const PairHistory& said) const {
    complaint.unless(expected.size() == said.size(), "not one entry for each frame");
    for (std::size_t i = 0; i < std::min(expected.size(), said.size()); ++i) {
      complaint.unless(expected[i].pairs == said[i].pairs, fmt::format("pairs of frame {}", i), expected[i].pairs,
                       said[i].pairs);
    }
  }

  void operator()(const Distance& expected, const Distance& said) const {
    if (said.verdict) {
      complaint.unless(*expected.verdict == *said.verdict, "verdict", *expected.verdict, *said.verdict);
    }
    if (said.distance) complaint.near("distance", *expected.distance, *said.distance, of_length(*expected.distance));
    const auto witness = [&](const char* part, const std::optional<Vec3>& known, const std::optional<Vec3>& found) {
      if (known && found) complaint.near(part, *known, *found, of_point(*known));
    };
    witness("p_WCa", expected.p_WCa, said.p_WCa);
    witness("p_WCb", expected.p_WCb, said.p_WCb);
  }

  void operator()(const Penetration& expected, const Penetration& said) const {
    if (said.verdict) {
      complaint.unless(*expected.verdict == *said.verdict, "verdict", *expected.verdict, *said.verdict);
    }
    if (said.depth) complaint.near("depth", *expected.depth, *said.depth, of_length(*expected.depth));
    if (expected.nhat_BA_W && said.nhat_BA_W) {
      complaint.near("nhat_BA_W", *expected.nhat_BA_W, *said.nhat_BA_W, of_direction);
    }
  }

  void operator()(const Impulse& expected, const Impulse& said) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const Velocity &known = expected.after[i], &found = said.after[i];
      complaint.near(of_body("v_WBcm", i), known.v_WBcm, found.v_WBcm, of_velocity(known.v_WBcm));
      complaint.near(of_body("w_WB", i), known.w_WB, found.w_WB, of_velocity(known.w_WB));
    }
    if (expected.P_A_W && said.P_A_W) {
      complaint.near("P_A_W", *expected.P_A_W, *said.P_A_W, of_velocity(*expected.P_A_W));
    }
  }

  /// The conservative masks may be wider.
  void operator()(const Pixels& expected, const Pixels& said) const {
    complaint.unless(expected.sampled == said.sampled, "a mask of `sampled` differs");
    const auto contains = [](const Mask& wide, const Mask& narrow) {
      bool all = wide.size() == narrow.size();
      for (std::size_t j = 0; all && j < narrow.size(); ++j) {
        all = wide[j].size() == narrow[j].size();
        for (std::size_t i = 0; all && i < narrow[j].size(); ++i) all = wide[j][i] == '1' || narrow[j][i] == '0';
      }
      return all;
    };
    bool all = expected.conservative.size() == said.conservative.size();
    for (std::size_t i = 0; all && i < expected.conservative.size(); ++i) {
      all = contains(said.conservative[i], expected.conservative[i]);
    }
    complaint.unless(all, "a mask of `conservative` misses a pixel");
    complaint.near("overlap.count", expected.overlap.count, said.overlap.count, 0);
    complaint.unless(expected.overlap.first == said.overlap.first, "overlap.first differs");
    complaint.unless(expected.meet_sampled == said.meet_sampled, "meet_sampled differs");
    complaint.unless(contains(said.meet_conservative, expected.meet_conservative), "meet_conservative misses a pixel");
  }

  void operator()(const TimeOfImpact& expected, const TimeOfImpact& said) const {
    complaint.unless(expected.status == said.status, "status", expected.status, said.status);
    if (expected.time && said.time) complaint.near("time", *expected.time, *said.time, of_length(*expected.time));
  }

  void operator()(const Trajectory& expected, const Trajectory& said) const {
    complaint.unless(expected.states.size() == said.states.size(), "not one list of states for each sample time");
    for (std::size_t t = 0; t < std::min(expected.states.size(), said.states.size()); ++t) {
      complaint.unless(expected.states[t].size() == said.states[t].size(), "not one state for each body");
      for (std::size_t i = 0; i < std::min(expected.states[t].size(), said.states[t].size()); ++i) {
        const State &known = expected.states[t][i], &found = said.states[t][i];
        complaint.near(of_body("X_WB.p", i), known.X_WB.p_WB, found.X_WB.p_WB, of_stepped_place);
        complaint.near(of_body("v_WBcm", i), known.velocity.v_WBcm, found.velocity.v_WBcm, of_stepped_velocity);
        complaint.near(of_body("w_WB", i), known.velocity.w_WB, found.velocity.w_WB, of_stepped_velocity);
        if (known.X_WB.q_WB == not_judged) continue;
        const double turned = oracle::rotation(known.X_WB.q_WB).angularDistance(oracle::rotation(found.X_WB.q_WB));
        complaint.unless(turned <= of_rotation, of_body("X_WB.q", i) + fmt::format(": off by {:.3g} rad", turned));
      }
    }
  }
};

}  // namespace

std::string what_is_wrong(const AnyAnswer& expected, const AnyAnswer& said) {
  Complaint complaint;
  std::visit(Compare{complaint}, expected, said);
  return complaint.text();
}

}  // namespace touchstone::app
