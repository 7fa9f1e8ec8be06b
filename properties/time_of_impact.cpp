// The clauses of docs/spec/time_of_impact.md as executable properties.
#include <algorithm>
#include <cmath>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/truth/truth.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/judging/pair_laws.h"
#include "properties/queries.h"
#include "properties/transforms/body.h"
#include "properties/transforms/motion.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
using Status = TimeOfImpact::Status;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;

double rounding(const MotionCase& asked) { return 4 * oracle::unit_roundoff(asked.precision) * asked.end; }

Finding wrong(Defect defect, const TimeOfImpact& said, const MotionCase& asked) {
  return judge::wrong(defect, text(said), text(asked.truth));
}

bool in(const Interval& interval, double x) { return interval.lo <= x && x <= interval.hi; }

// At the claimed time the two bodies touch to within rounding, and have not overlapped deeper than that before.
Finding touches_at(const MotionCase& asked, const TimeOfImpact& said) {
  if (!said.time) return judge::silent("the time of impact");
  const double time = std::clamp(*said.time, asked.start, asked.end);
  if (std::abs(time - *said.time) > rounding(asked)) {
    return judge::wrong(Defect::inconsistent, text(said), "a time within the motion");
  }
  if (asked.truth.status == Status::hit && in(asked.truth.time, time)) return judge::holds();
  const double apart = asked.gap(time), deep = -asked.deepest(time);
  return judge::at_most(
      std::max(apart, deep), in_ulps_of_place(asked, asked.slack),
      asked.truth.status == Status::miss ? Defect::phantom
      : apart > deep                     ? Defect::too_early
                                         : Defect::too_late,
      [&] { return text(said); }, [&] { return text(asked.truth); });
}

Finding no_miss(const MotionCase& asked, const TimeOfImpact& said) {
  if (asked.truth.status == Status::undecided) return judge::outside("the bodies graze: the reference does not decide");
  return judge::at_most(
      -asked.deepest(asked.end), in_ulps_of_place(asked, asked.slack), Defect::missed, [&] { return text(said); },
      [&] { return text(asked.truth); });
}

Finding agrees(const Scene& scene, Subject& subject) {
  return of_answered_motion(scene, subject, [](const MotionCase& asked, const TimeOfImpact& said) {
    if (said.status == Status::undecided) return judge::silent("whether the bodies touch");
    return said.status == Status::hit ? touches_at(asked, said) : no_miss(asked, said);
  });
}

Finding decided(const Scene& scene, Subject& subject) {
  return of_answered_motion(scene, subject, [](const MotionCase& asked, const TimeOfImpact& said) {
    if (said.status != Status::undecided) return judge::holds();
    const bool clear_hit = asked.certainly_met(asked.end);
    const bool clear_miss = asked.truth.status == Status::miss && !asked.earliest();
    return clear_hit || clear_miss ? wrong(Defect::inconsistent, said, asked) : judge::holds();
  });
}

// Judges the claims of an enclosure, which need no allowance: no contact before lo; for a hit, a contact no later than
// hi; for a miss, no contact; for an undecided answer, a distance within the claimed gap no later than hi.
Finding enclosure(const Scene& scene, Subject& subject) {
  return of_answered_motion(scene, subject, [](const MotionCase& asked, const TimeOfImpact& said) {
    if (!said.enclosure) return judge::silent("an enclosure");
    const bool hits = asked.truth.status == Status::hit;
    if (hits && said.enclosure->lo > asked.truth.time.hi) return wrong(Defect::too_late, said, asked);
    if (said.status == Status::hit) {
      const bool met = asked.truth.status != Status::miss && said.enclosure->hi >= asked.truth.time.lo;
      return met ? judge::holds() : wrong(Defect::broken_enclosure, said, asked);
    }
    if (said.status == Status::miss) return hits ? wrong(Defect::missed, said, asked) : judge::holds();
    if (!said.gap) return judge::silent("the gap to which the bodies come");
    const auto near = oracle::truth::time_of_distance(asked.scene, *said.gap);
    const bool comes_near = near.status != Status::miss && near.time.lo <= said.enclosure->hi;
    return comes_near ? judge::holds() : wrong(Defect::broken_enclosure, said, asked);
  });
}

// Allows four times the slack: a subject's bound on its own error is seldom tight, so each of the two sides gets twice
// the allowance. Where a body turns about a point in which the two touch, the reference may prove the overlap late too.
Finding tight(const Scene& scene, Subject& subject) {
  return of_answered_motion(scene, subject, [](const MotionCase& asked, const TimeOfImpact& said) {
    if (said.status != Status::hit || !said.enclosure) return judge::silent("an enclosure of the time of impact");
    if (asked.truth.status != Status::hit) return judge::outside("the bodies do not touch, or only graze");
    const double slack = tolerance::moving_distance(asked.scene, asked.truth.time.hi,
                                                    std::max(asked.precision, oracle::Precision::binary64));
    const double lo = std::clamp(said.enclosure->lo, asked.start, asked.end);
    const double hi = std::clamp(said.enclosure->hi, asked.start, asked.end);
    double deep = -asked.deepest(hi);
    if (deep > 0) deep -= std::max(0.0, -asked.gap(asked.truth.time.hi));
    return judge::at_most(
        std::max(asked.gap(lo), deep), in_ulps_of_place(asked, 4 * slack), Defect::loose_enclosure,
        [&] { return text(said); }, [&] { return text(asked.truth); });
  });
}

// Poses and velocities at the start are given exactly. So rounding cannot change whether bodies that touch there
// approach, unless their approach speed is itself a rounding error.
Finding start(const Scene& scene, Subject& subject) {
  return of_answered_motion(scene, subject, [](const MotionCase& asked, const TimeOfImpact& said) {
    if (asked.gap(asked.start) != 0) return judge::outside("the bodies do not touch at the start");
    if (asked.truth.status == Status::hit && asked.truth.at_start) {
      if (said.status == Status::hit) return touches_at(asked, said);
      return said.status == Status::miss ? no_miss(asked, said) : judge::silent("whether the bodies touch");
    }
    if (asked.truth.at_start) return judge::outside("neither separating nor approaching at the start");
    if (asked.truth.time.lo == asked.start) return judge::outside("the poses at the start are not known exactly");
    if (asked.granted > 0) return judge::outside("the subject declares that it takes bodies so near for touching");
    const double until =
        asked.truth.status == Status::miss ? asked.end : asked.truth.time.lo;  // they may come together
    for (double after = asked.moment; asked.start + after < until; after *= 2) {
      const double apart = asked.gap(asked.start + after);
      if (apart <= asked.slack) continue;
      if (said.status != Status::hit) return judge::holds();
      if (!said.time) return judge::silent("the time of impact");
      return *said.time >= asked.start + after ? judge::holds() : wrong(Defect::phantom, said, asked);
    }
    return judge::outside("the bodies do not separate at the start by more than rounding");
  });
}

/// A certain verdict about the first contact.
struct Sure {
  bool hit = false;
  double window = 0;  ///< s: the width within which rounding keeps the time of impact
};

// An exact subject gets the window of binary64: a subject with exact poses still encloses the time of impact only as
// narrowly as doubles do (TS-TIME-OF-IMPACT-4), and reports some time in the enclosure.
std::optional<Sure> surely(const MotionCase& given) {
  MotionCase asked(given.scene, std::max(given.precision, oracle::Precision::binary64));
  asked.slack += given.granted;
  const std::optional<double> earliest = asked.earliest();
  if (asked.truth.status == Status::miss && !earliest) return Sure{false, 0};
  if (asked.truth.status != Status::hit || !earliest) return std::nullopt;
  const std::optional<double> latest = asked.latest();
  if (!latest) return std::nullopt;
  return Sure{true, *latest - *earliest + rounding(asked)};
}

/// Compares two answers with the same truth, the second one's time already mapped to the first scene. Each may be off
/// by the window.
Finding one_meeting(const MotionCase& asked, const TimeOfImpact& first, const TimeOfImpact& second, Defect defect) {
  if (first.status == Status::undecided || second.status == Status::undecided) {
    return judge::silent("whether the bodies touch");
  }
  const std::optional<Sure> sure = surely(asked);
  if (!sure) return judge::outside("the bodies graze: rounding decides");
  if (first.status != second.status) return judge::wrong(defect, text(second), text(first) + ", as before");
  if (first.status == Status::miss || !sure->hit) return judge::holds();
  if (!first.time || !second.time) return judge::silent("the time of impact");
  return judge::at_most(
      std::abs(*first.time - *second.time), {2 * sure->window, sure->window, "uncertainties of the time of impact"},
      defect, [&] { return text(second); }, [&] { return text(first) + ", as before"; });
}

/// Queries both scenes and compares the answers. `told` maps the second answer's time to the first scene.
template <class MapTime>
Finding unchanged(const Scene& scene, const std::optional<Scene>& other, Subject& subject, Defect defect,
                  MapTime&& map_time) {
  return of_answered_motion(scene, subject, [&](const MotionCase& asked, const TimeOfImpact& first) {
    return of_moved(other, subject, [&](const Scene& moved) {
      return judge::given(subject.time_of_impact(moved), [&](TimeOfImpact second) {
        if (second.time) second.time = map_time(*second.time);
        return one_meeting(asked, first, second, defect);
      });
    });
  });
}

Finding unchanged(const Scene& scene, const std::optional<Scene>& other, Subject& subject, Defect defect) {
  return unchanged(scene, other, subject, defect, [](double time) { return time; });
}

/// Applies `change` only to scenes with two bodies and a motion.
template <class Change>
std::optional<Scene> changed(const Scene& scene, Change&& change) {
  return scene.motion && scene.bodies.size() == 2 ? change(scene) : std::nullopt;
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

// The delay is shorter than the motion, since a later time is rounded more coarsely.
Finding clock(const Scene& scene, Subject& subject) {
  const double delay = scene.motion ? 0.75 * std::exp2(std::floor(std::log2(end_of(scene)))) : 0;
  return unchanged(scene, changed(scene, [delay](const Scene& s) { return later(s, delay); }), subject,
                   Defect::moved_with_frame, [delay](double time) { return time - delay; });
}

Finding mass(const Scene& scene, Subject& subject) {
  const bool pushed = scene.motion && !scene.motion->forces.empty();
  return unchanged(scene, pushed ? std::nullopt : denser(scene, 4), subject, Defect::inconsistent);
}

Finding spin_of_balls(const Scene& scene, Subject& subject) {
  return unchanged(scene, changed(scene, spun_balls), subject, Defect::inconsistent);
}

// Restitution, friction, impact law and envelope do not change the time of the first contact.
Finding coefficients(const Scene& scene, Subject& subject) {
  return unchanged(scene,
                   changed(scene,
                           [](Scene s) {
                             for (Body& body : s.bodies) {
                               body.material.restitution = 1 - body.material.restitution;
                               body.material.friction += 0.5;
                             }
                             s.motion->law = Law::stronge;
                             const double wider = 0x1p10 * envelope(s);
                             const bool is_valid = std::ranges::all_of(s.bodies, [wider](const Body& body) {
                               return is_fixed(body) || is_decisive(body, wider);
                             });
                             if (wider > 0 && is_valid) s.motion->envelope = wider;
                             return std::optional(s);
                           }),
                   subject, Defect::inconsistent);
}

/// A time with few bits, between the start and the time of impact, or the end of the motion if there is none.
double cut(const MotionCase& asked) {
  const double until = asked.truth.status == Status::hit ? asked.truth.time.lo : asked.end;
  const double grid = std::exp2(std::floor(std::log2(std::max(until - asked.start, 0x1p-100))) - 3);
  return std::floor((asked.start + until) / 2 / grid) * grid;
}

// A motion that ends before the first contact has none. One that ends after it has the same first contact.
Finding ends_early(const Scene& scene, Subject& subject) {
  return of_answered_motion(scene, subject, [&](const MotionCase& asked, const TimeOfImpact& whole) {
    const std::optional<Sure> sure = surely(asked);
    if (!sure || !sure->hit || asked.truth.at_start) return judge::outside("no clear time of impact after the start");
    const double before = cut(asked), after = (*asked.latest() + asked.end) / 2;
    const auto until = [&](double time, auto&& judge_it) {
      Scene shorter = scene;
      shorter.motion->sample_times = {time};
      return judge::given(subject.time_of_impact(shorter), judge_it);
    };
    if (!(before > asked.start && before < *asked.earliest()))
      return judge::outside("the contact comes too soon after the start");
    const Finding first = until(before, [&](const TimeOfImpact& said) {
      return said.status != Status::hit
                 ? judge::holds()
                 : judge::wrong(Defect::inconsistent, text(said), "no contact before " + oracle::words::text(before));
    });
    if (first.outcome != oracle::Outcome::holds) return first;
    return until(after,
                 [&](const TimeOfImpact& said) { return one_meeting(asked, whole, said, Defect::inconsistent); });
  });
}

Finding taken_up(const Scene& scene, Subject& subject) {
  return of_motion(scene, subject, [&](const MotionCase& asked) {
    const bool open = asked.truth.status == Status::undecided;
    if (asked.truth.at_start || open) return judge::outside("no time between the start and the contact");
    return unchanged(scene, taken_up_at(scene, cut(asked)), subject, Defect::inconsistent);
  });
}

Finding reversible(const Scene& scene, Subject& subject) {
  return of_answered_motion(scene, subject, [&](const MotionCase& asked, const TimeOfImpact& there) {
    if (asked.truth.status != Status::miss || asked.earliest()) return judge::outside("not a clear miss");
    return of_moved(backwards(scene), subject, [&](const Scene& reversed) {
      return judge::given(subject.time_of_impact(reversed), [&](const TimeOfImpact& back) {
        return one_meeting(asked, there, back, Defect::inconsistent);
      });
    });
  });
}

Finding survives_any(const Scene& scene, Subject& subject) {
  if (!scene.motion || scene.bodies.size() != 2) return judge::outside("not two bodies with a motion");
  return survives<TimeOfImpact>(&Subject::time_of_impact, scene, subject, [&](const TimeOfImpact& said) -> std::string {
    if (said.time && (*said.time < 0 || *said.time > (1 + 0x1p-20) * end_of(scene)))
      return "a time beyond the end of the motion";
    if (said.enclosure && said.enclosure->lo > said.enclosure->hi) return "an enclosure whose ends are exchanged";
    if (said.gap && *said.gap < 0) return "a gap below 0";
    return {};
  });
}

Finding repeats_itself(const Scene& scene, Subject& subject) {
  if (!scene.motion || scene.bodies.size() != 2) return judge::outside("not two bodies with a motion");
  return repeats<TimeOfImpact>(&Subject::time_of_impact, scene, swapped(scene), subject);
}

}  // namespace

std::vector<Property> time_of_impact_properties() {
  const std::string query = "time_of_impact", clause = "TS-TIME-OF-IMPACT-";
  return {
      {"time_of_impact.agrees",
       query,
       {clause + "1"},
       "the bodies are said to touch exactly if they do, and at the right time",
       agrees},
      {"time_of_impact.decided", query, {clause + "2"}, "a clear hit or a clear miss is decided", decided},
      {"time_of_impact.enclosure", query, {clause + "3"}, "a stated enclosure contains the time of impact", enclosure},
      {"time_of_impact.tight", query, {clause + "4"}, "an enclosure is as narrow as rounding allows", tight},
      {"time_of_impact.start",
       query,
       {clause + "5"},
       "contact at the start counts if the bodies approach there",
       start},
      {"time_of_impact.symmetric",
       query,
       {clause + "6"},
       "swapping the bodies does not change the time of impact",
       symmetric},
      {"time_of_impact.rotated",
       query,
       {clause + "7"},
       "rotating the world does not change the time of impact",
       rotated},
      {"time_of_impact.translated",
       query,
       {clause + "7"},
       "translating the world does not change the time of impact",
       shifted},
      {"time_of_impact.galilean",
       query,
       {clause + "8"},
       "a velocity added to both bodies does not change the time of impact",
       galilean},
      {"time_of_impact.gravity",
       query,
       {clause + "9"},
       "gravity that acts on both bodies does not change the time of impact",
       gravity},
      {"time_of_impact.scaled",
       query,
       {clause + "10"},
       "scaling all lengths does not change the time of impact",
       length},
      {"time_of_impact.hastened", query, {clause + "11"}, "scaling time by s scales the time of impact by s", pace},
      {"time_of_impact.later",
       query,
       {clause + "12"},
       "delaying both starts by s delays the time of impact by s",
       clock},
      {"time_of_impact.shortened",
       query,
       {clause + "13"},
       "a motion that ends earlier has the same time of impact, or a miss if it ends before",
       ends_early},
      {"time_of_impact.taken_up",
       query,
       {clause + "13"},
       "a motion restarted from its own later state has the same time of impact",
       taken_up},
      {"time_of_impact.reversible",
       query,
       {clause + "14"},
       "a motion that misses also misses when reversed in time",
       reversible},
      {"time_of_impact.mass", query, {clause + "15"}, "mass does not change the time of impact in free fall", mass},
      {"time_of_impact.spin_of_balls",
       query,
       {clause + "16"},
       "a ball's spin does not change the time of impact",
       spin_of_balls},
      {"time_of_impact.coefficients",
       query,
       {clause + "17"},
       "restitution and friction do not change the time of impact",
       coefficients},
      {"time_of_impact.survives",
       query,
       {clause + "18"},
       "every valid scene has an answer that is finite and consistent",
       survives_any},
      {"time_of_impact.repeats",
       query,
       {clause + "19"},
       "the same query has the same answer, bit for bit",
       repeats_itself},
  };
}

}  // namespace touchstone::properties
