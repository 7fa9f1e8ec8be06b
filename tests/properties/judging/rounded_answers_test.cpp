// No false accusation: an engine whose every number is one of the doubles next to the right one holds every property.
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <ranges>
#include <string>
#include <vector>

#include "oracle/subject.h"
#include "oracle/subjects/canaries/lie.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/property.h"
#include "properties/random.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"

namespace touchstone::properties {
namespace {

using oracle::Subject;

constexpr std::uint64_t scenes_of_a_family = 3, runs_of_a_family = 1;  // runs are long

/// A neighbour of x or x itself, chosen by its digits alone: equal numbers stay equal, and so do their ratios where
/// these are powers of two. So laws that ask for the same bits hold too.
void round(double& x) {
  if (x == 0 || !std::isnormal(x)) return;
  int exponent = 0;
  const double digits = std::frexp(std::abs(x), &exponent);
  const int way = Random(std::bit_cast<std::uint64_t>(digits)).between(-1, 1);
  const double next = way == 0 ? digits : std::nextafter(digits, 2.0 * way);
  x = std::copysign(std::ldexp(next, exponent), x);
}

template <class Matrix>
void round_entries(Matrix& m) {
  for (double& x : m.reshaped()) round(x);
}

void round(std::optional<double>& x) {
  if (x) round(*x);
}

void round(std::optional<Vec3>& v) {
  if (v) round_entries(*v);
}

void round(Velocity& V) {
  round_entries(V.v_WBcm);
  round_entries(V.w_WB);
}

void round(State& state) {
  round_entries(state.X_WB.p_WB);
  for (double* x : {&state.X_WB.q_WB.w, &state.X_WB.q_WB.x, &state.X_WB.q_WB.y, &state.X_WB.q_WB.z}) round(*x);
  round(state.velocity);
}

/// Its own time is not rounded where the scene gives it: so do forces begin, and samples are before or after it.
void round(Event& event, const std::vector<double>& given) {
  if (event.kind != Event::Kind::force && std::ranges::find(given, event.time) == given.end()) round(event.time);
  for (Vec3* v : {&event.p_WC, &event.nhat_BA_W, &event.P_A_W}) round_entries(*v);
  round(event.after_a);
  round(event.after_b);
}

void round_all(Subject&, const Scene& scene, Trajectory& said) {
  for (std::vector<State>& states : said.states) std::ranges::for_each(states, [](State& state) { round(state); });
  if (!said.events) return;
  for (Event& event : *said.events) round(event, scene.motion->sample_times);
}

/// Claims, such as enclosures, are left out: an engine that makes one must keep it.
oracle::subjects::Lies roundings() {
  oracle::subjects::Lies lies;
  lies.mass = [](Subject&, const Scene&, Masses& said) {
    for (std::optional<MassProperties>& body : said) {
      if (!body) continue;
      round(body->mass);
      round_entries(body->p_BBcm);
      round_entries(body->I_BBcm_B);
    }
  };
  lies.bounds = [](Subject&, const Scene&, Bounds& said) {
    for (Aabb& box : said) round_entries(box.lo), round_entries(box.hi);
  };
  lies.distance = [](Subject&, const Scene&, Distance& said) {
    round(said.distance);
    round(said.p_WCa);
    round(said.p_WCb);
    said.enclosure.reset();
  };
  lies.penetration = [](Subject&, const Scene&, Penetration& said) {
    round(said.depth);
    round(said.nhat_BA_W);
  };
  lies.impulse = [](Subject&, const Scene&, Impulse& said) {
    for (Velocity& V : said.after) round(V);
    round(said.P_A_W);
    said.error.reset();
  };
  lies.time_of_impact = [](Subject&, const Scene&, TimeOfImpact& said) {
    round(said.time);
    said.enclosure.reset();
  };
  lies.simulation = lies.constraint = round_all;
  return lies;
}

std::unique_ptr<Subject> rounded() {
  const auto next = oracle::subjects::lying("rounded", "each number is next to the right one", roundings);
  return next.make(oracle::subjects::make_fast());
}

void expect_held(const Property& property, const Family& family, std::uint64_t scenes, Subject& subject) {
  for (std::uint64_t i = 0; i < scenes; ++i) {
    const oracle::Finding found = property.check(draw(family, 5, i), subject);
    INFO(property.id << ", " << family.id << ' ' << i << ": " << found.observed << " instead of " << found.expected
                     << ", " << found.error << " of " << found.allowed << ' ' << found.unit);
    CHECK(!oracle::failed(found));
  }
}

TEST_CASE("no false accusation: answers whose numbers are next to the right ones hold every property") {
  const std::unique_ptr<Subject> subject = rounded();
  for (const Property& property : all()) {
    const bool is_run = property.query == "simulation" || property.query == "constraint";
    for (const Family* family : for_query(families(), property.query))
      expect_held(property, *family, is_run ? runs_of_a_family : scenes_of_a_family, *subject);
  }
}

// At an apex a body is so slow that the rounding of an event's time changes its velocity by far more than its own
// rounding.
TEST_CASE("no false accusation: times next to that of an apex") {
  const std::unique_ptr<Subject> subject = rounded();
  for (const char* id : {"simulation.flights", "simulation.event_states", "simulation.impulses_apply",
                         "simulation.impulses_add_up", "simulation.none_missed"}) {
    for (const Family* family : for_query(families(), "simulation")) {
      if (family->id == "runs.apex" || family->id == "runs.plate_leaves") expect_held(find(id), *family, 24, *subject);
    }
  }
}

}  // namespace
}  // namespace touchstone::properties
