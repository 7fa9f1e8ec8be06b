// docs/spec/time_of_impact.md, as sentences that run.
#include <algorithm>
#include <cmath>

#include "model/limits.h"
#include "oracle/tolerance_motion.h"
#include "oracle/truth.h"
#include "oracle/words.h"
#include "properties/body_motion.h"
#include "properties/flight_case.h"
#include "properties/flight_motion.h"
#include "properties/motion.h"
#include "properties/pair_laws.h"
#include "properties/stems.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
using Meeting = TimeOfImpact::Meeting;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;

double rounding(const FlightCase& asked) { return 4 * oracle::unit_roundoff(asked.precision) * asked.end; }

Finding wrong(Defect defect, const TimeOfImpact& said, const FlightCase& asked) {
  return judge::wrong(defect, text(said), text(asked.truth));
}

bool in(const Interval& interval, double x) { return interval.lo <= x && x <= interval.hi; }

// At the time that is said the two touch within rounding, and have not been deeper in each other before.
Finding touches_at(const FlightCase& asked, const TimeOfImpact& said) {
  if (!said.time) return judge::silent("when they meet");
  const double time = std::clamp(*said.time, asked.start, asked.end);
  if (std::abs(time - *said.time) > rounding(asked)) {
    return judge::wrong(Defect::inconsistent, text(said), "a time of the flight");
  }
  if (asked.truth.meeting == Meeting::hit && in(asked.truth.time, time)) return judge::holds();
  const double apart = asked.gap(time), deep = -asked.deepest(time);
  return judge::at_most(
      std::max(apart, deep), in_ulps_of_place(asked, asked.slack),
      asked.truth.meeting == Meeting::miss ? Defect::phantom
      : apart > deep                       ? Defect::too_early
                                           : Defect::too_late,
      [&] { return text(said); }, [&] { return text(asked.truth); });
}

Finding no_miss(const FlightCase& asked, const TimeOfImpact& said) {
  if (asked.truth.meeting == Meeting::undecided) return judge::outside("they graze: the reference does not tell");
  return judge::at_most(
      -asked.deepest(asked.end), in_ulps_of_place(asked, asked.slack), Defect::missed, [&] { return text(said); },
      [&] { return text(asked.truth); });
}

Finding agrees(const Scene& scene, Subject& subject) {
  return of_answered_flight(scene, subject, [](const FlightCase& asked, const TimeOfImpact& said) {
    if (said.meeting == Meeting::undecided) return judge::silent("whether they meet");
    return said.meeting == Meeting::hit ? touches_at(asked, said) : no_miss(asked, said);
  });
}

Finding decided(const Scene& scene, Subject& subject) {
  return of_answered_flight(scene, subject, [](const FlightCase& asked, const TimeOfImpact& said) {
    if (said.meeting != Meeting::undecided) return judge::holds();
    const bool clear_hit = asked.certainly_met(asked.end);
    const bool clear_miss = asked.truth.meeting == Meeting::miss && !asked.earliest();
    return clear_hit || clear_miss ? wrong(Defect::inconsistent, said, asked) : judge::holds();
  });
}

// Of claims that need no allowance: apart before lo; if they meet, not after hi; nearer than the gap somewhere between.
Finding enclosure(const Scene& scene, Subject& subject) {
  return of_answered_flight(scene, subject, [](const FlightCase& asked, const TimeOfImpact& said) {
    if (!said.enclosure) return judge::silent("an enclosure");
    const bool hits = asked.truth.meeting == Meeting::hit;
    if (hits && said.enclosure->lo > asked.truth.time.hi) return wrong(Defect::too_late, said, asked);
    if (said.meeting == Meeting::hit) {
      const bool met = asked.truth.meeting != Meeting::miss && said.enclosure->hi >= asked.truth.time.lo;
      return met ? judge::holds() : wrong(Defect::broken_enclosure, said, asked);
    }
    if (said.meeting == Meeting::miss) return hits ? wrong(Defect::missed, said, asked) : judge::holds();
    if (!said.gap) return judge::silent("how near they come");
    const auto near = oracle::truth::time_of_distance(asked.scene, *said.gap);
    const bool comes_near = near.meeting != Meeting::miss && near.time.lo <= said.enclosure->hi;
    return comes_near ? judge::holds() : wrong(Defect::broken_enclosure, said, asked);
  });
}

// A claimed bound on one's own error is seldom the tightest: twice the allowance, on each of the two sides.
Finding tight(const Scene& scene, Subject& subject) {
  return of_answered_flight(scene, subject, [](const FlightCase& asked, const TimeOfImpact& said) {
    if (said.meeting != Meeting::hit || !said.enclosure) return judge::silent("the enclosure of a meeting");
    if (asked.truth.meeting != Meeting::hit) return judge::outside("they do not meet, or only graze");
    const double slack =
        tolerance::meeting(asked.scene, asked.truth.time.hi, std::max(asked.precision, oracle::Precision::binary64));
    const double lo = std::clamp(said.enclosure->lo, asked.start, asked.end);
    const double hi = std::clamp(said.enclosure->hi, asked.start, asked.end);
    return judge::at_most(
        std::max(asked.gap(lo), -asked.deepest(hi)), in_ulps_of_place(asked, 4 * slack), Defect::loose_enclosure,
        [&] { return text(said); }, [&] { return text(asked.truth); });
  });
}

// Poses and velocities at the start are given, so whether bodies that touch there approach is no matter of rounding,
// unless their speed is.
Finding start(const Scene& scene, Subject& subject) {
  return of_answered_flight(scene, subject, [](const FlightCase& asked, const TimeOfImpact& said) {
    if (asked.gap(asked.start) != 0) return judge::outside("they do not touch at the start");
    if (asked.truth.meeting == Meeting::hit && asked.truth.at_start) {
      if (said.meeting == Meeting::hit) return touches_at(asked, said);
      return said.meeting == Meeting::miss ? no_miss(asked, said) : judge::silent("whether they meet");
    }
    if (asked.truth.at_start) return judge::outside("neither parting nor approaching");
    for (double after = asked.moment; asked.start + after < asked.end; after *= 2) {
      const double apart = asked.gap(asked.start + after);
      if (apart <= asked.slack) continue;
      if (said.meeting != Meeting::hit) return judge::holds();
      if (!said.time) return judge::silent("when they meet");
      return *said.time >= asked.start + after ? judge::holds() : wrong(Defect::phantom, said, asked);
    }
    return judge::outside("they do not part");
  });
}

/// How surely the two meet, or miss each other.
struct Sure {
  bool hit = false;
  double window = 0;  ///< s: within which roundings leave the meeting
};

// Who computes poses exactly still encloses meetings, as narrowly as doubles do (TS-TIME-OF-IMPACT-4), and names some
// time in between.
std::optional<Sure> surely(const FlightCase& given) {
  const FlightCase asked(given.scene, std::max(given.precision, oracle::Precision::binary64));
  const std::optional<double> earliest = asked.earliest();
  if (asked.truth.meeting == Meeting::miss && !earliest) return Sure{false, 0};
  if (asked.truth.meeting != Meeting::hit || !earliest) return std::nullopt;
  const std::optional<double> latest = asked.latest();
  if (!latest) return std::nullopt;
  return Sure{true, *latest - *earliest + rounding(asked)};
}

/// Two answers to questions whose truths are one, the second's times told as the first's: each may be off by the
/// window.
Finding one_meeting(const FlightCase& asked, const TimeOfImpact& first, const TimeOfImpact& second, Defect defect) {
  if (first.meeting == Meeting::undecided || second.meeting == Meeting::undecided) {
    return judge::silent("whether they meet");
  }
  const std::optional<Sure> sure = surely(asked);
  if (!sure) return judge::outside("they graze: rounding decides");
  if (first.meeting != second.meeting) return judge::wrong(defect, text(second), text(first) + ", as before");
  if (first.meeting == Meeting::miss || !sure->hit) return judge::holds();
  if (!first.time || !second.time) return judge::silent("when they meet");
  return judge::at_most(
      std::abs(*first.time - *second.time), {2 * sure->window, sure->window, "times of rounding"}, defect,
      [&] { return text(second); }, [&] { return text(first) + ", as before"; });
}

/// Asks about both; `told` makes the first's time of the second's.
template <class Told>
Finding unchanged(const Scene& scene, const std::optional<Scene>& other, Subject& subject, Defect defect, Told&& told) {
  return of_answered_flight(scene, subject, [&](const FlightCase& asked, const TimeOfImpact& first) {
    return of_moved(other, subject, [&](const Scene& moved) {
      return judge::given(subject.time_of_impact(moved), [&](TimeOfImpact second) {
        if (second.time) second.time = told(*second.time);
        return one_meeting(asked, first, second, defect);
      });
    });
  });
}

Finding unchanged(const Scene& scene, const std::optional<Scene>& other, Subject& subject, Defect defect) {
  return unchanged(scene, other, subject, defect, [](double time) { return time; });
}

/// For changes that need a flight to change.
template <class Change>
std::optional<Scene> changed(const Scene& scene, Change&& change) {
  return scene.flight && scene.bodies.size() == 2 ? change(scene) : std::nullopt;
}

Finding symmetric(const Scene& scene, Subject& subject) {
  return unchanged(scene, changed(scene, [](const Scene& s) { return std::optional(swapped(s)); }), subject,
                   Defect::asymmetric);
}

Finding rotated(const Scene& scene, Subject& subject) {
  return unchanged(scene, some_turn(scene), subject, Defect::moved_with_frame);
}

Finding shifted(const Scene& scene, Subject& subject) {
  return unchanged(scene, translated(scene), subject, Defect::moved_with_frame);
}

Finding galilean(const Scene& scene, Subject& subject) {
  return unchanged(scene, changed(scene, carried), subject, Defect::moved_with_frame);
}

Finding gravity(const Scene& scene, Subject& subject) {
  return unchanged(scene, changed(scene, weightless), subject, Defect::inconsistent);
}

Finding length(const Scene& scene, Subject& subject) {
  return unchanged(scene, changed(scene, [](const Scene& s) { return scaled(s, -3); }), subject, Defect::scaled);
}

Finding pace(const Scene& scene, Subject& subject) {
  return unchanged(scene, changed(scene, [](const Scene& s) { return hastened(s, 5); }), subject, Defect::scaled,
                   [](double time) { return std::ldexp(time, 5); });
}

// By less than the flight is long: a later time is rounded more coarsely.
Finding clock(const Scene& scene, Subject& subject) {
  const double delay = scene.flight ? 0.75 * std::exp2(std::floor(std::log2(end_of(scene)))) : 0;
  return unchanged(scene, changed(scene, [delay](const Scene& s) { return later(s, delay); }), subject,
                   Defect::moved_with_frame, [delay](double time) { return time - delay; });
}

Finding mass(const Scene& scene, Subject& subject) {
  const bool pushed = scene.flight && !scene.flight->pushes.empty();
  return unchanged(scene, pushed ? std::nullopt : denser(scene, 4), subject, Defect::inconsistent);
}

Finding spin_of_balls(const Scene& scene, Subject& subject) {
  return unchanged(scene, changed(scene, spun_balls), subject, Defect::inconsistent);
}

// What rules impacts has no part in when they come.
Finding coefficients(const Scene& scene, Subject& subject) {
  return unchanged(scene,
                   changed(scene,
                           [](Scene s) {
                             for (Body& body : s.bodies) {
                               body.material.restitution = 1 - body.material.restitution;
                               body.material.friction += 0.5;
                             }
                             s.flight->law = Law::stronge;
                             s.flight->envelope = 0x1p10 * envelope(s);
                             return s.flight->envelope > 0 ? std::optional(s) : std::nullopt;
                           }),
                   subject, Defect::inconsistent);
}

/// A time of the flight of few bits, between its start and the meeting, or its end.
double cut(const FlightCase& asked) {
  const double until = asked.truth.meeting == Meeting::hit ? asked.truth.time.lo : asked.end;
  const double grid = std::exp2(std::floor(std::log2(std::max(until - asked.start, 0x1p-100))) - 3);
  return std::floor((asked.start + until) / 2 / grid) * grid;
}

// A flight that ends before the meeting ends without; one that ends after it does not see the rest.
Finding ends_early(const Scene& scene, Subject& subject) {
  return of_answered_flight(scene, subject, [&](const FlightCase& asked, const TimeOfImpact& whole) {
    const std::optional<Sure> sure = surely(asked);
    if (!sure || !sure->hit || asked.truth.at_start) return judge::outside("no clear meeting after the start");
    const double before = cut(asked), after = (*asked.latest() + asked.end) / 2;
    const auto until = [&](double time, auto&& judge_it) {
      Scene shorter = scene;
      shorter.flight->times = {time};
      return judge::given(subject.time_of_impact(shorter), judge_it);
    };
    if (!(before > asked.start && before < *asked.earliest())) return judge::outside("it meets as soon as it starts");
    const Finding first = until(before, [&](const TimeOfImpact& said) {
      return said.meeting != Meeting::hit
                 ? judge::holds()
                 : judge::wrong(Defect::inconsistent, text(said), "no meeting before " + oracle::words::text(before));
    });
    if (first.outcome != oracle::Outcome::holds) return first;
    return until(after,
                 [&](const TimeOfImpact& said) { return one_meeting(asked, whole, said, Defect::inconsistent); });
  });
}

Finding taken_up(const Scene& scene, Subject& subject) {
  return of_flight(scene, subject, [&](const FlightCase& asked) {
    const bool open = asked.truth.meeting == Meeting::undecided;
    if (asked.truth.at_start || open) return judge::outside("no time between the start and the meeting");
    return unchanged(scene, taken_up_at(scene, cut(asked)), subject, Defect::inconsistent);
  });
}

Finding reversible(const Scene& scene, Subject& subject) {
  return of_answered_flight(scene, subject, [&](const FlightCase& asked, const TimeOfImpact& there) {
    if (asked.truth.meeting != Meeting::miss || asked.earliest()) return judge::outside("not a clear miss");
    return of_moved(backwards(scene), subject, [&](const Scene& reversed) {
      return judge::given(subject.time_of_impact(reversed), [&](const TimeOfImpact& back) {
        return one_meeting(asked, there, back, Defect::inconsistent);
      });
    });
  });
}

Finding survives_any(const Scene& scene, Subject& subject) {
  if (!scene.flight || scene.bodies.size() != 2) return judge::outside("not two bodies in flight");
  return survives<TimeOfImpact>(&Subject::time_of_impact, scene, subject, [&](const TimeOfImpact& said) -> std::string {
    if (said.time && (*said.time < 0 || *said.time > (1 + 0x1p-20) * end_of(scene))) return "a time beyond the flight";
    if (said.enclosure && said.enclosure->lo > said.enclosure->hi) return "an enclosure whose ends are exchanged";
    if (said.gap && *said.gap < 0) return "a gap below 0";
    return {};
  });
}

Finding repeats_itself(const Scene& scene, Subject& subject) {
  if (!scene.flight || scene.bodies.size() != 2) return judge::outside("not two bodies in flight");
  return repeats<TimeOfImpact>(&Subject::time_of_impact, scene, swapped(scene), subject);
}

}  // namespace

std::vector<Property> time_of_impact_properties() {
  const std::string stem = "time_of_impact", clause = "TS-TIME-OF-IMPACT-";
  return {
      {"time_of_impact.agrees", stem, {clause + "1"}, "they meet when they do, or miss each other", agrees},
      {"time_of_impact.decided", stem, {clause + "2"}, "what is clear is decided", decided},
      {"time_of_impact.enclosure", stem, {clause + "3"}, "a claimed enclosure is never late, and holds", enclosure},
      {"time_of_impact.tight", stem, {clause + "4"}, "an enclosure is as narrow as rounding allows", tight},
      {"time_of_impact.start", stem, {clause + "5"}, "contact at the start counts if they approach", start},
      {"time_of_impact.symmetric", stem, {clause + "6"}, "swapping the bodies changes nothing", symmetric},
      {"time_of_impact.rotated", stem, {clause + "7"}, "turning the world changes nothing", rotated},
      {"time_of_impact.translated", stem, {clause + "7"}, "moving the world changes nothing", shifted},
      {"time_of_impact.galilean", stem, {clause + "8"}, "a velocity of all bodies changes nothing", galilean},
      {"time_of_impact.gravity", stem, {clause + "9"}, "gravity that both feel changes nothing", gravity},
      {"time_of_impact.scaled", stem, {clause + "10"}, "the unit of length does not matter", length},
      {"time_of_impact.hastened", stem, {clause + "11"}, "the unit of time does not matter", pace},
      {"time_of_impact.later", stem, {clause + "12"}, "a later start is a later meeting", clock},
      {"time_of_impact.shortened", stem, {clause + "13"}, "the flight's end decides what is seen alone", ends_early},
      {"time_of_impact.taken_up", stem, {clause + "13"}, "a flight taken up on its way goes on", taken_up},
      {"time_of_impact.reversible", stem, {clause + "14"}, "a flight that misses does so backwards", reversible},
      {"time_of_impact.mass", stem, {clause + "15"}, "mass does not matter to bodies in free fall", mass},
      {"time_of_impact.spin_of_balls", stem, {clause + "16"}, "a ball's spin does not matter", spin_of_balls},
      {"time_of_impact.coefficients", stem, {clause + "17"}, "what rules impacts does not matter", coefficients},
      {"time_of_impact.survives", stem, {clause + "18"}, "any valid question ends with sense", survives_any},
      {"time_of_impact.repeats", stem, {clause + "19"}, "the same question, the same answer", repeats_itself},
  };
}

}  // namespace touchstone::properties
