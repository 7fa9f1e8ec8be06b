// Canaries that lie about the time of impact, one for each error of continuous collision detection.
#include <algorithm>
#include <cmath>
#include <functional>

#include "model/limits.h"
#include "oracle/subjects/canaries/lie.h"
#include "oracle/truth/motion_in_doubles.h"

namespace touchstone::oracle::subjects {
namespace {

using Status = TimeOfImpact::Status;

Lies meetings(Lie<TimeOfImpact> lie) {
  Lies lies;
  lies.time_of_impact = std::move(lie);
  return lies;
}

// Answers the truth about a changed motion.
Lies as_if(const std::function<void(Scene&)>& change) {
  return meetings([change](Subject& truthful, const Scene& scene, TimeOfImpact& said) {
    Scene other = scene;
    change(other);
    with(truthful.time_of_impact(other), [&](const TimeOfImpact& answer) { said = answer; });
  });
}

// Replaces the time, and its enclosure, by a function of the true time.
Lies with_time(const std::function<double(double, const Scene&)>& other) {
  return meetings([other](Subject&, const Scene& scene, TimeOfImpact& said) {
    if (!said.time) return;
    said.time = other(*said.time, scene);
    said.enclosure = Interval{*said.time, *said.time};
  });
}

double start_of(const Scene& scene) {
  const std::vector<double>& since = scene.motion->start_times;
  return since.empty() ? 0 : *std::ranges::max_element(since);
}

void spin_forgotten(Scene& scene) {
  for (Body& body : scene.bodies) body.velocity.w_WB.setZero();
}

void gravity_forgotten(Scene& scene) { scene.gravity.setZero(); }

// Keeps ω constant, as if all moments of inertia were equal.
void gyroscopic_term_forgotten(Scene& scene) {
  for (Body& body : scene.bodies) {
    auto* given = std::get_if<MassProperties>(&body.mass);
    if (given != nullptr) given->I_BBcm_B = given->I_BBcm_B.trace() / 3 * Mat3::Identity();
  }
}

void fixed_bodies_stand(Scene& scene) {
  for (Body& body : scene.bodies) {
    if (is_fixed(body)) body.velocity = {};
  }
}

void pushes_forgotten(Scene& scene) { scene.motion->forces.clear(); }

void air_drag(Scene& scene) {
  for (Body& body : scene.bodies) body.velocity.v_WBcm *= 1 - 1e-6;
}

void bounding_balls(Scene& scene) {
  for (Body& body : scene.bodies) {
    if (const auto* box = std::get_if<Box>(&body.shape)) body.shape = Sphere{box->half_extents.minCoeff()};
  }
}

void since_forgotten(Scene& scene) { scene.motion->start_times.clear(); }

// Samples 32 steps of the motion and detects only overlap.
void steps(Subject& truthful, const Scene& scene, TimeOfImpact& said) {
  const double start = start_of(scene), step = (scene.motion->sample_times.back() - start) / 32;
  said = {Status::miss, {}, {}, {}};
  for (int i = 0; i <= 32; ++i) {
    bool overlapping = false;
    with(truthful.distance(pair_at(scene, start + i * step)),
         [&](const Distance& d) { overlapping = d.verdict == Verdict::overlapping; });
    if (!overlapping) continue;
    said = {Status::hit, start + i * step, Interval{start + i * step, start + i * step}, {}};
    return;
  }
}

void touching_at_start_counts(Subject& truthful, const Scene& scene, TimeOfImpact& said) {
  if (distance_by(truthful, pair_at(scene, start_of(scene))) > 0) return;
  said = {Status::hit, start_of(scene), Interval{start_of(scene), start_of(scene)}, {}};
}

void touching_at_start_ignored(Subject&, const Scene& scene, TimeOfImpact& said) {
  if (said.time && *said.time <= start_of(scene)) said = {Status::miss, {}, {}, {}};
}

// Reports a hit for every pair that approaches.
void ahead_is_hit(Subject& truthful, const Scene& scene, TimeOfImpact& said) {
  if (said.status != Status::miss) return;
  const double start = start_of(scene), end = scene.motion->sample_times.back();
  const double first = distance_by(truthful, pair_at(scene, start));
  const double soon = distance_by(truthful, pair_at(scene, start + (end - start) / 64));
  if (soon < first) said = {Status::hit, (start + end) / 2, Interval{start, end}, {}};
}

void shrugs(Subject&, const Scene& scene, TimeOfImpact& said) {
  said = {Status::undecided, {}, Interval{start_of(scene), scene.motion->sample_times.back()}, 1e6};
}

void wide(Subject&, const Scene& scene, TimeOfImpact& said) {
  if (said.enclosure) said.enclosure = Interval{start_of(scene), scene.motion->sample_times.back()};
}

// s: in which two bodies that start as these do move one rounding of a length relative to each other.
double rounding_of_time(const Scene& scene) {
  const double speed = (scene.bodies[0].velocity.v_WBcm - scene.bodies[1].velocity.v_WBcm).norm();
  return speed > 0 ? rounding_of_length(scene) / speed : 0;
}

// Twice as wide as the enclosure of a careful subject may be.
void slightly_wide_enclosure(Subject&, const Scene& scene, TimeOfImpact& said) {
  if (said.time) said.enclosure = Interval{*said.time - 8000 * rounding_of_time(scene), *said.time};
}

double mass_of(const Body& body) {
  const auto* density = std::get_if<Density>(&body.mass);
  return density != nullptr ? density->value : 0;
}

}  // namespace

std::vector<Canary> canaries_about_motion() {
  return {
      lying("canary.turns_forgotten", "moves bodies without their spin", [] { return as_if(spin_forgotten); }),
      lying("canary.gravity_forgotten", "moves bodies along straight lines", [] { return as_if(gravity_forgotten); }),
      lying("canary.gyroscopic_term_forgotten", "keeps the angular velocity of a body whose moments differ",
            [] { return as_if(gyroscopic_term_forgotten); }),
      lying("canary.fixed_bodies_stand", "keeps moving fixed bodies at rest", [] { return as_if(fixed_bodies_stand); }),
      lying("canary.pushes_forgotten", "applies no force but gravity", [] { return as_if(pushes_forgotten); }),
      lying("canary.thick_air", "slows what moves by a millionth", [] { return as_if(air_drag); }),
      lying("canary.balls_for_boxes", "takes a box for the ball in it", [] { return as_if(bounding_balls); }),
      lying("canary.since_forgotten", "starts every motion at 0", [] { return as_if(since_forgotten); }),
      lying("canary.tunnels", "samples each motion 32 times, and sees overlap alone", [] { return meetings(steps); }),
      lying(
          "canary.late", "is late by a millionth of the motion",
          [] { return with_time([](double t, const Scene& s) { return t + 1e-6 * s.motion->sample_times.back(); }); }),
      lying(
          "canary.early", "is early by a millionth of the motion",
          [] { return with_time([](double t, const Scene& s) { return t - 1e-6 * s.motion->sample_times.back(); }); }),
      lying("canary.whole_microseconds", "counts time in whole millionths of a second",
            [] { return with_time([](double t, const Scene&) { return std::floor(t * 1e6) / 1e6; }); }),
      lying("canary.envelope_is_contact", "takes bodies within the contact tolerance for touching",
            [] { return with_time([](double t, const Scene& s) { return t * (1 - envelope(s)); }); }),
      lying("canary.feels_gravity", "is later, the stronger gravity is",
            [] { return with_time([](double t, const Scene& s) { return t * (1 + 1e-6 * s.gravity.norm()); }); }),
      lying("canary.feels_mass", "is later, the denser the bodies are",
            [] { return with_time([](double t, const Scene& s) { return t * (1 + 1e-6 * mass_of(s.bodies[0])); }); }),
      lying("canary.balls_rub", "is later for balls that turn",
            [] {
              return with_time([](double t, const Scene& s) {
                return t * (1 + 1e-6 * (s.bodies[0].velocity.w_WB - s.bodies[1].velocity.w_WB).norm());
              });
            }),
      lying("canary.touching_counts", "reports a hit of bodies that touch at the start and separate",
            [] { return meetings(touching_at_start_counts); }),
      lying("canary.touching_ignored", "overlooks bodies that touch at the start and approach",
            [] { return meetings(touching_at_start_ignored); }),
      lying("canary.ahead_is_hit", "reports a hit of all bodies that approach", [] { return meetings(ahead_is_hit); }),
      lying("canary.shrugs_at_flights", "decides no time of impact", [] { return meetings(shrugs); }),
      lying("canary.slightly_early", "is early by a few thousand roundings",
            [] { return with_time([](double t, const Scene& s) { return t - 4000 * rounding_of_time(s); }); }),
      lying("canary.slightly_late", "is late by a few thousand roundings",
            [] { return with_time([](double t, const Scene& s) { return t + 2400 * rounding_of_time(s); }); }),
      lying("canary.slightly_wide_meeting", "gives an enclosure that begins 8000 roundings too early",
            [] { return meetings(slightly_wide_enclosure); }),
      lying("canary.wide_meeting", "gives the whole motion as the enclosure of the time of impact",
            [] { return meetings(wide); }),
  };
}

}  // namespace touchstone::oracle::subjects
