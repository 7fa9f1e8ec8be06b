// No false accusation: an engine whose every number is one of the doubles, or singles, next to the right one holds
// every property.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <ranges>
#include <string>
#include <vector>

#include "oracle/case.h"
#include "oracle/subject.h"
#include "oracle/subjects/canaries/lie.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/judging/remembered_answers.h"
#include "properties/property.h"
#include "properties/random.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"

namespace touchstone::properties {
namespace {

using oracle::Precision;
using oracle::Subject;
using oracle::subjects::Lies;

constexpr std::uint64_t scenes_of_a_family = 3, runs_of_a_family = 1;  // runs are long

/// Replaces a number by a neighbour or by itself, chosen by its digits alone: equal numbers stay equal, and so do their
/// ratios where these are powers of two. So laws that ask for the same bits hold too.
class Rounding {
 public:
  explicit Rounding(Precision precision) : is_single_(precision == Precision::binary32) {}

  void operator()(double& x) const {
    if (x == 0 || !std::isnormal(x)) return;
    int exponent = 0;
    const double digits = std::frexp(std::abs(x), &exponent);
    const int way = Random(std::bit_cast<std::uint64_t>(digits)).between(-1, 1);
    x = std::copysign(std::ldexp(next(digits, way), exponent), x);
  }

  template <class Matrix>
  void entries(Matrix& m) const {
    for (double& x : m.reshaped()) (*this)(x);
  }

  void operator()(std::optional<double>& x) const {
    if (x) (*this)(*x);
  }
  void operator()(std::optional<Vec3>& v) const {
    if (v) entries(*v);
  }
  void operator()(Velocity& V) const {
    entries(V.v_WBcm);
    entries(V.w_WB);
  }
  void operator()(State& state) const {
    Quaternion& q = state.X_WB.q_WB;
    entries(state.X_WB.p_WB);
    for (double* x : {&q.w, &q.x, &q.y, &q.z}) (*this)(*x);
    (*this)(state.velocity);
  }
  /// Its own time is not rounded where the scene gives it: so do forces begin, and samples are before or after it. Nor
  /// is it to a single, which would put events into another order.
  void operator()(Event& event, const std::vector<double>& given) const {
    const bool is_given = event.kind == Event::Kind::force || std::ranges::find(given, event.time) != given.end();
    if (!is_given && !is_single_) (*this)(event.time);
    for (Vec3* v : {&event.p_WC, &event.nhat_BA_W, &event.P_A_W}) entries(*v);
    (*this)(event.after_a);
    (*this)(event.after_b);
  }
  /// A box is rounded outward.
  void operator()(Aabb& box) const {
    for (double& x : box.lo) x = next(x, -1);
    for (double& x : box.hi) x = next(x, 1);
  }

 private:
  double next(double x, int way) const {
    const double there = way * std::numeric_limits<double>::infinity();
    if (is_single_) return way == 0 ? float(x) : std::nextafter(float(x), float(there));
    return way == 0 ? x : std::nextafter(x, there);
  }

  bool is_single_;
};

/// Claims, such as enclosures, are left out: an engine that makes one must keep it.
Lies rounded_to(Precision precision) {
  const Rounding round(precision);
  Lies lies;
  lies.precision = precision;
  lies.mass = [=](Subject&, const Scene&, Masses& said) {
    for (std::optional<MassProperties>& body : said) {
      if (!body) continue;
      round(body->mass);
      round.entries(body->p_BBcm);
      round.entries(body->I_BBcm_B);
    }
  };
  lies.bounds = [=](Subject&, const Scene&, Bounds& said) { std::ranges::for_each(said, round); };
  lies.distance = [=](Subject&, const Scene&, Distance& said) {
    round(said.distance);
    round(said.p_WCa);
    round(said.p_WCb);
    said.enclosure.reset();
  };
  lies.penetration = [=](Subject&, const Scene&, Penetration& said) {
    round(said.depth);
    round(said.nhat_BA_W);
  };
  lies.impulse = [=](Subject&, const Scene&, Impulse& said) {
    std::ranges::for_each(said.after, round);
    round(said.P_A_W);
    said.error.reset();
  };
  lies.time_of_impact = [=](Subject&, const Scene&, TimeOfImpact& said) {
    round(said.time);
    said.enclosure.reset();
  };
  lies.simulation = lies.constraint = [=](Subject&, const Scene& scene, Trajectory& said) {
    for (std::vector<State>& states : said.states) std::ranges::for_each(states, round);
    if (!said.events) return;
    for (Event& event : *said.events) round(event, scene.motion->sample_times);
  };
  return lies;
}

std::unique_ptr<Subject> rounded(Precision precision) {
  return oracle::subjects::lying("rounded", "each number is next to the right one",
                                 [=] { return rounded_to(precision); })
      .make(oracle::subjects::make_fast());
}

void expect_held(const Property& property, const Scene& scene, const std::string& name, Subject& subject) {
  const oracle::Finding found = property.check(scene, subject);
  INFO(property.id << ", " << name << ": " << found.observed << " instead of " << found.expected << ", " << found.error
                   << " of " << found.allowed << ' ' << found.unit);
  CHECK(!oracle::failed(found));
}

/// As `check` asks: of each scene all properties, since judge and subject keep what they know about the last one.
void expect_all_held(Precision precision) {
  const std::unique_ptr<Subject> subject = rounded(precision);
  for (const std::string& query : tested_queries()) {
    const bool is_run = query == "simulation" || query == "constraint";
    for (const Family* family : for_query(families(), query)) {
      for (std::uint64_t i = 0; i < (is_run ? runs_of_a_family : scenes_of_a_family); ++i) {
        const Scene scene = draw(*family, 5, i);
        RememberedAnswers answers(*subject);
        for (const Property& property : all()) {
          if (property.query != query) continue;
          expect_held(property, scene, family->id + ' ' + std::to_string(i), answers.asked_by(property));
        }
      }
    }
  }
}

TEST_CASE("no false accusation: answers whose numbers are next to the right ones hold every property") {
  expect_all_held(Precision::binary64);
}

TEST_CASE("no false accusation: answers in singles hold every property") { expect_all_held(Precision::binary32); }

// Found by fuzzing such an engine: 2^23 m from the origin, and impacts whose contact regions rounding widens.
TEST_CASE("no false accusation: answers in singles to cases of the corpus") {
  const std::unique_ptr<Subject> subject = rounded(Precision::binary32);
  for (const char* name :
       {"constraint/bodies_2_23_from_the_origin", "simulation/fuzzed/box_falls_onto_a_box_on_a_plate"}) {
    const oracle::Case found =
        oracle::read_case(TOUCHSTONE_SOURCE_DIR "/properties/corpus/" + std::string(name) + ".json");
    CHECK(!oracle::failed(find(found.property).check(found.scene, *subject)));
  }
}

// At an apex a body is so slow that the rounding of an event's time changes its velocity by far more than its own
// rounding.
TEST_CASE("no false accusation: times next to that of an apex") {
  const std::unique_ptr<Subject> subject = rounded(Precision::binary64);
  for (const char* id : {"simulation.flights", "simulation.event_states", "simulation.impulses_apply",
                         "simulation.impulses_add_up", "simulation.none_missed"}) {
    for (const Family* family : for_query(families(), "simulation")) {
      if (family->id != "runs.apex" && family->id != "runs.plate_leaves") continue;
      for (std::uint64_t i = 0; i < 24; ++i)
        expect_held(find(id), draw(*family, 5, i), family->id + ' ' + std::to_string(i), *subject);
    }
  }
}

}  // namespace
}  // namespace touchstone::properties
