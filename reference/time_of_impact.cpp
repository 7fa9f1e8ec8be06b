#include "reference/time_of_impact.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "model/input_error.h"
#include "reference/distance.h"
#include "reference/encounter_impl.h"
#include "reference/flight_impl.h"
#include "reference/float_mode_impl.h"
#include "reference/next_impact_impl.h"
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
  if (standing.kind == Standing::Kind::overlapping) return truth;
  const auto vec = [](const Triple& v) { return Vec3(nearest(v[0]), nearest(v[1]), nearest(v[2])); };
  const Float scale = 1 / sqrt(float_of(dot(standing.n, standing.n)));
  for (int i = 0; i < 3; ++i) {
    truth.nhat_BA_W[i] = static_cast<double>(Float(scale * float_of(standing.n[static_cast<std::size_t>(i)])));
  }
  truth.p_WCa = vec(standing.x) - core_of(parts.A, parts.a).radius * truth.nhat_BA_W;
  truth.p_WCb = vec(standing.y) + core_of(parts.B, parts.b).radius * truth.nhat_BA_W;
  return truth;
}

[[noreturn]] void refuse_overlap(const Scene& scene) {
  const Body& A = scene.bodies[0];
  const Body& B = scene.bodies[1];
  std::ostringstream what;
  what << '"' << A.name << "\" and \"" << B.name << "\" overlap";
  if (!std::holds_alternative<Compound>(A.shape) && !std::holds_alternative<Compound>(B.shape)) {
    what << " by " << penetration(scene).depth.hi << " m";
  }
  throw InputError("bodies", what.str() + " where their flight begins; expected bodies that are apart");
}

/// One of them has been flying before: their poses are known to rounding, and so is an overlap.
void refuse_overlap_to_rounding(const Question& question) {
  Scene scene = question.scene;
  for (std::size_t i = 0; i < 2; ++i) scene.bodies[i] = moved(question.scene, i, question.from);
  if (distance(scene).verdict == Verdict::overlapping) refuse_overlap(scene);
}

/// Where doubles see nothing between the two at the start.
TimeOfImpactTruth closely(const Parts& parts, const Question& question) {
  const auto& [a, b] = question.departures;
  Encounter<InWide> encounter(parts, question.departures, question.apart);
  const auto search = [&](const Float& from) { return encounter.search(from, question.end); };
  if (!question.poses_hold) {
    const Found<Float> found = search(question.from);
    const bool known = isfinite(found.gap);  // else a tumbling body is lost
    if (known && found.lo == question.from && question.only_meetings) refuse_overlap_to_rounding(question);
    return truth_of(found, parts, question.end);
  }
  const Standing there = standing(parts.A, parts.a, a, parts.B, parts.b, b, question.apart);
  using Kind = Standing::Kind;
  if (there.kind == Kind::apart) return truth_of(search(question.from), parts, question.end);
  if (!question.only_meetings) return at_start(parts, question, Meeting::hit, there);
  if (there.kind == Kind::overlapping) refuse_overlap(question.scene);
  if (there.kind == Kind::approaching) return at_start(parts, question, Meeting::hit, there);
  if (there.kind == Kind::parting) {
    if (const std::optional<Float> later = encounter.leave(there, question.from, question.end)) {
      return truth_of(search(*later), parts, question.end);
    }
  }
  return at_start(parts, question, Meeting::undecided, there);
}

TimeOfImpactTruth between_parts(const Parts& parts, const Question& question) {
  const Encounter<InDoubles> in_doubles(parts, question.departures, question.apart);
  const Found<double> quick = in_doubles.search(question.from, question.end);
  if (!(quick.lo > question.from)) return closely(parts, question);
  const bool loose = quick.meeting == Meeting::hit && in_doubles.is_loose(quick);
  if (!loose && (quick.meeting != Meeting::undecided || quick.exhausted)) return truth_of(quick, parts, question.end);
  Encounter<InWide> encounter(parts, question.departures, question.apart);
  return truth_of(encounter.search(quick.lo, question.end), parts, question.end);
}

/// Of both: nothing before the earlier `lo`, and a meeting by the earlier `hi`.
TimeOfImpactTruth earlier(const TimeOfImpactTruth& a, const TimeOfImpactTruth& b) {
  const bool a_begins = a.time.lo <= b.time.lo;
  TimeOfImpactTruth first = a_begins ? a : b;
  const TimeOfImpactTruth& other = a_begins ? b : a;
  if (other.meeting == Meeting::hit) {
    first.meeting = Meeting::hit;
    first.time.hi = std::min(first.time.hi, other.time.hi);
  }
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
