#include "reference/time_of_impact.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "model/input_error.h"
#include "reference/distance.h"
#include "reference/exact/enclosed.h"
#include "reference/exact/float_mode.h"
#include "reference/exact/rational.h"
#include "reference/motion/ballistic_motion.h"
#include "reference/penetration.h"
#include "reference/time_of_impact/encounter.h"
#include "reference/time_of_impact/initial_contact.h"
#include "reference/time_of_impact/next_impact.h"
#include "reference/time_of_impact/translation.h"

namespace touchstone::reference {
namespace {

using Status = TimeOfImpact::Status;

Vec3 plain(const Coordinates<double>& v) { return {v.x, v.y, v.z}; }
Vec3 plain(const Coordinates<Float>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

double rounded_up(double x) { return x; }
double rounded_up(const Float& x) { return mpfr_get_d(x.backend().data(), MPFR_RNDU); }

template <class P>
TimeOfImpactTruth truth_of(const Found<P>& found, const Parts& parts, double end) {
  TimeOfImpactTruth truth;
  truth.status = found.status;
  truth.time = {rounded_down<double>(Float(found.lo)), found.status == Status::hit ? rounded_up(found.hi) : end};
  truth.gap = rounded_up(found.gap);
  truth.nhat_BA_W = plain(found.nhat_BA);
  truth.p_WCa = plain(found.p_WCa) - core_of(parts.A, parts.a).radius * truth.nhat_BA_W;
  truth.p_WCb = plain(found.p_WCb) + core_of(parts.B, parts.b).radius * truth.nhat_BA_W;
  return truth;
}

/// The question about the motion of two bodies.
struct Question {
  const Scene& scene;
  const std::array<BallisticStart, 2>& starts;
  double apart;
  double from, end;
  bool poses_hold;          ///< at `from` both have exactly the scene's poses
  bool first_contact_only;  ///< separating contact does not count, and overlap is refused
};

TimeOfImpactTruth at_start(const Parts& parts, const Question& question, Status status, const InitialContact& initial) {
  TimeOfImpactTruth truth;
  truth.status = status;
  truth.at_start = true;
  truth.time = {question.from, status == Status::hit ? question.from : question.end};
  if (initial.kind == InitialContact::Kind::overlapping) return truth;
  const auto vec = [](const Triple& v) { return Vec3(nearest(v[0]), nearest(v[1]), nearest(v[2])); };
  const Float scale = 1 / sqrt(float_of(dot(initial.n, initial.n)));
  for (int i = 0; i < 3; ++i) {
    truth.nhat_BA_W[i] = static_cast<double>(Float(scale * float_of(initial.n[static_cast<std::size_t>(i)])));
  }
  truth.p_WCa = vec(initial.x) - core_of(parts.A, parts.a).radius * truth.nhat_BA_W;
  truth.p_WCb = vec(initial.y) + core_of(parts.B, parts.b).radius * truth.nhat_BA_W;
  return truth;
}

[[noreturn]] void refuse_overlap(const Body& A, const Body& B) {
  std::ostringstream what;
  what << '"' << A.name << "\" and \"" << B.name << "\" overlap";
  if (!std::holds_alternative<Compound>(A.shape) && !std::holds_alternative<Compound>(B.shape)) {
    Scene pair;
    pair.bodies = {A, B};
    what << " by " << penetration(pair).depth.hi << " m";
  }
  throw InputError("bodies", what.str() + " where their motion begins; expected bodies that are apart");
}

/// One of the bodies started earlier, so the poses are known only to rounding, and so is an overlap. If a pose is not
/// known at all, nothing is refused.
void refuse_overlap_to_rounding(const Question& question) {
  Scene scene = question.scene;
  try {
    for (std::size_t i = 0; i < 2; ++i) scene.bodies[i] = moved(question.scene, i, question.from);
  } catch (const MotionUnknown&) {
    return;
  }
  if (distance(scene).verdict == Verdict::overlapping) refuse_overlap(scene.bodies[0], scene.bodies[1]);
}

/// Decides exactly what intervals leave undecided, if the two translate uniformly relative to each other. Requires that
/// they are apart at first.
TimeOfImpactTruth decided(TimeOfImpactTruth truth, const Parts& parts, const Question& question) {
  if (truth.status != Status::undecided) return truth;
  const std::optional<TranslatingContact> contact =
      translating_contact(parts, question.starts, question.apart, question.from, question.end);
  if (!contact) return truth;
  if (!contact->time) {
    truth.status = Status::miss;
    truth.time = {question.end, question.end};
    return truth;
  }
  truth.status = Status::hit;
  truth.time = Enclosed(*contact->time).in_doubles();
  return truth;
}

/// For pairs that doubles do not separate at the start.
TimeOfImpactTruth resolve_start(const Parts& parts, const Question& question) {
  const auto& [a, b] = question.starts;
  Encounter<InWide> encounter(parts, question.starts, question.apart);
  const auto search = [&](const Float& from) { return encounter.search(from, question.end); };
  if (!question.poses_hold) {
    const Found<Float> found = search(question.from);
    const bool known = isfinite(found.gap);  // else the trajectory of a tumbling body is unknown
    if (known && found.lo == question.from && question.first_contact_only) refuse_overlap_to_rounding(question);
    return truth_of(found, parts, question.end);
  }
  const InitialContact there = initial_contact(parts.A, parts.a, a, parts.B, parts.b, b, question.apart);
  using Kind = InitialContact::Kind;
  if (there.kind == Kind::apart) return decided(truth_of(search(question.from), parts, question.end), parts, question);
  if (!question.first_contact_only) return at_start(parts, question, Status::hit, there);
  if (there.kind == Kind::overlapping) refuse_overlap(parts.A, parts.B);
  if (there.kind == Kind::approaching) return at_start(parts, question, Status::hit, there);
  if (there.kind == Kind::separating) {
    if (const std::optional<Float> later = encounter.leave(there, question.from, question.end)) {
      return truth_of(search(*later), parts, question.end);
    }
  }
  return at_start(parts, question, Status::undecided, there);
}

TimeOfImpactTruth between_parts(const Parts& parts, const Question& question) {
  const Encounter<InDoubles> in_doubles(parts, question.starts, question.apart);
  const Found<double> quick = in_doubles.search(question.from, question.end);
  if (!(quick.lo > question.from)) return resolve_start(parts, question);
  const bool loose = quick.status == Status::hit && in_doubles.is_loose(quick);
  if (!loose && (quick.status != Status::undecided || quick.exhausted)) return truth_of(quick, parts, question.end);
  Encounter<InWide> encounter(parts, question.starts, question.apart);
  return decided(truth_of(encounter.search(quick.lo, question.end), parts, question.end), parts, question);
}

/// The result for both pairs of parts: no contact before the earlier `lo`, and a contact by the earlier `hi`.
TimeOfImpactTruth earlier(const TimeOfImpactTruth& a, const TimeOfImpactTruth& b) {
  const bool a_begins = a.time.lo <= b.time.lo;
  TimeOfImpactTruth first = a_begins ? a : b;
  const TimeOfImpactTruth& other = a_begins ? b : a;
  if (other.status == Status::hit) {
    first.status = Status::hit;
    first.time.hi = std::min(first.time.hi, other.time.hi);
  }
  return first;
}

/// Removes the rotation of a sphere about its centre, which does not change the set of its points.
void leave_out_turning(const Body& body, BallisticStart& start) {
  const bool centred = start.centre[0] == 0 && start.centre[1] == 0 && start.centre[2] == 0;
  if (!std::holds_alternative<Sphere>(body.shape) || !centred) return;
  start.w = start.Omega = start.sigma = Triple();
  start.tumble = nullptr;
}

TimeOfImpactTruth first_within(const Scene& scene, double apart, std::optional<double> earliest) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "two are needed for a time of impact");
  if (!scene.motion) throw InputError("motion", "missing; expected one for a question about motion");
  const DefaultFloatMode mode;
  std::array<Body, 2> bodies = {scene.bodies[0], scene.bodies[1]};
  std::array<BallisticStart, 2> starts = {ballistic_start(scene, 0), ballistic_start(scene, 1)};
  for (std::size_t i = 0; i < 2; ++i) leave_out_turning(bodies[i], starts[i]);
  const double end = scene.motion->sample_times.back();
  const double from = std::max({starts[0].start_time.get_d(), starts[1].start_time.get_d(), earliest.value_or(0)});
  if (from > end) throw InputError("motion.sample_times", "the motion ends before the time that is queried");
  for (std::size_t i = 0; i < 2; ++i) {
    if (starts[i].start_time < from && translates(starts[i])) start_later(bodies[i], starts[i], from);
  }
  const auto& [A, B] = bodies;
  const bool poses_hold = starts[0].start_time == from && starts[1].start_time == from;
  const Question question = {scene, starts, apart, from, end, poses_hold, !earliest};
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
