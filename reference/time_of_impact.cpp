#include "reference/time_of_impact.h"

#include <cmath>
#include <string>
#include <utility>

#include "model/input_error.h"
#include "reference/distance.h"
#include "reference/encounter_impl.h"
#include "reference/flight_impl.h"
#include "reference/float_mode_impl.h"
#include "reference/penetration.h"
#include "reference/rational_impl.h"
#include "reference/start_impl.h"

namespace touchstone::reference {
namespace {

using Meeting = TimeOfImpact::Meeting;

Vec3 plain(const Coordinates<double>& v) { return {v.x, v.y, v.z}; }
Vec3 plain(const Coordinates<Float>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

double rounded_up(double x) { return x; }
double rounded_up(const Float& x) { return mpfr_get_d(x.backend().data(), MPFR_RNDU); }

template <class P>
TimeOfImpactTruth truth_of(const Found<P>& found, const Parts& parts, double end) {
  TimeOfImpactTruth truth;
  truth.meeting = found.meeting;
  truth.time = {rounded_down<double>(Float(found.lo)), found.meeting == Meeting::hit ? rounded_up(found.hi) : end};
  truth.gap = rounded_up(found.gap);
  truth.nhat_BA_W = plain(found.nhat_BA);
  truth.p_WCa = plain(found.p_WCa) - core_of(parts.A, parts.a).radius * truth.nhat_BA_W;
  truth.p_WCb = plain(found.p_WCb) + core_of(parts.B, parts.b).radius * truth.nhat_BA_W;
  return truth;
}

/// What is asked about a flight.
struct Question {
  const Scene& scene;
  const std::array<Departure, 2>& departures;
  double apart;
  double from, end;
  bool poses_hold;     ///< both stand at `from` as the scene says
  bool only_meetings;  ///< contact from which they part does not count, and overlap is no answer
};

TimeOfImpactTruth at_start(const Parts& parts, const Question& question, Meeting meeting, const Standing& standing) {
  TimeOfImpactTruth truth;
  truth.meeting = meeting;
  truth.at_start = true;
  truth.time = {question.from, meeting == Meeting::hit ? question.from : question.end};
  const auto vec = [](const Triple& v) { return Vec3(nearest(v[0]), nearest(v[1]), nearest(v[2])); };
  const Float scale = 1 / sqrt(float_of(dot(standing.n, standing.n)));
  for (int i = 0; i < 3; ++i) {
    truth.nhat_BA_W[i] = static_cast<double>(Float(scale * float_of(standing.n[static_cast<std::size_t>(i)])));
  }
  truth.p_WCa = vec(standing.x) - core_of(parts.A, parts.a).radius * truth.nhat_BA_W;
  truth.p_WCb = vec(standing.y) + core_of(parts.B, parts.b).radius * truth.nhat_BA_W;
  return truth;
}

[[noreturn]] void refuse_overlap(const Parts& parts, const Question& question) {
  const std::string names = "\"" + parts.A.name + "\" and \"" + parts.B.name + "\"";
  std::string depth;
  if (!std::holds_alternative<Compound>(parts.A.shape) && !std::holds_alternative<Compound>(parts.B.shape)) {
    depth = " by " + std::to_string(penetration(question.scene).depth.hi) + " m";
  }
  throw InputError("bodies", names + " overlap" + depth + " where their flight begins; expected bodies that are apart");
}

/// Where doubles see nothing between the two at the start.
TimeOfImpactTruth closely(const Parts& parts, const Question& question) {
  const auto& [a, b] = question.departures;
  Encounter<InWide> encounter(parts, question.departures, question.apart);
  if (!question.poses_hold) return truth_of(encounter.search(question.from, question.end), parts, question.end);
  Standing there = standing(parts.A, parts.a, a, parts.B, parts.b, b, question.apart);
  using Kind = Standing::Kind;
  Float from = question.from;
  if (there.kind == Kind::overlapping && question.only_meetings) refuse_overlap(parts, question);
  if (there.kind == Kind::overlapping || (there.kind != Kind::apart && !question.only_meetings)) {
    return at_start(parts, question, Meeting::hit, there);
  }
  if (there.kind == Kind::approaching) return at_start(parts, question, Meeting::hit, there);
  if (there.kind == Kind::neither) return at_start(parts, question, Meeting::undecided, there);
  if (there.kind == Kind::parting) {
    const std::optional<Float> later = encounter.leave(there, from, question.end);
    if (!later) return at_start(parts, question, Meeting::undecided, there);
    from = *later;
  }
  return truth_of(encounter.search(from, question.end), parts, question.end);
}

TimeOfImpactTruth between_parts(const Parts& parts, const Question& question) {
  const Found<double> quick =
      Encounter<InDoubles>(parts, question.departures, question.apart).search(question.from, question.end);
  if (!(quick.lo > question.from)) return closely(parts, question);
  if (quick.meeting != Meeting::undecided || quick.exhausted) return truth_of(quick, parts, question.end);
  Encounter<InWide> encounter(parts, question.departures, question.apart);
  return truth_of(encounter.search(quick.lo, question.end), parts, question.end);
}

/// Of both: the first meeting is the earlier one.
TimeOfImpactTruth earlier(const TimeOfImpactTruth& a, const TimeOfImpactTruth& b) {
  const auto latest = [](const TimeOfImpactTruth& t) { return t.meeting == Meeting::hit ? t.time.hi : INFINITY; };
  const bool a_begins = a.time.lo <= b.time.lo;
  TimeOfImpactTruth first = a_begins ? a : b;
  const TimeOfImpactTruth& other = a_begins ? b : a;
  if (first.meeting == Meeting::hit) first.time.hi = std::min(first.time.hi, latest(other));
  return first;
}

/// A sphere that turns about its centre moves no point of its surface out of it.
void leave_out_turning(const Body& body, Departure& departure) {
  const bool centred = departure.centre[0] == 0 && departure.centre[1] == 0 && departure.centre[2] == 0;
  if (!std::holds_alternative<Sphere>(body.shape) || !centred) return;
  departure.w = departure.Omega = departure.sigma = Triple();
  departure.tumble = nullptr;
}

TimeOfImpactTruth first_within(const Scene& scene, double apart, std::optional<double> earliest) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "two are needed for a time of impact");
  if (!scene.flight) throw InputError("flight", "missing; expected one for a question about motion");
  const DefaultFloatMode mode;
  const Body& A = scene.bodies[0];
  const Body& B = scene.bodies[1];
  std::array<Departure, 2> departures = {departure(scene, 0), departure(scene, 1)};
  leave_out_turning(A, departures[0]);
  leave_out_turning(B, departures[1]);
  const double end = scene.flight->times.back();
  const double from = std::max({departures[0].since.get_d(), departures[1].since.get_d(), earliest.value_or(0)});
  if (from > end) throw InputError("flight.times", "the flight ends before the time that is asked about");
  const bool poses_hold = departures[0].since == from && departures[1].since == from;
  const Question question = {scene, departures, apart, from, end, poses_hold, !earliest};
  std::optional<TimeOfImpactTruth> first;
  for (int a = 0; a < part_count(A); ++a) {
    for (int b = 0; b < part_count(B); ++b) {
      const TimeOfImpactTruth truth = between_parts({A, B, a, b}, question);
      first = first ? earlier(*first, truth) : truth;
    }
  }
  return *first;
}

}  // namespace

TimeOfImpactTruth time_of_impact(const Scene& scene) { return first_within(scene, 0, std::nullopt); }

TimeOfImpactTruth time_of_distance(const Scene& scene, double apart, double from) {
  return first_within(scene, apart, from);
}

}  // namespace touchstone::reference
