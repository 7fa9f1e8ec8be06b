// Canaries that lie about simulations, one for each error of simulators.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "model/limits.h"
#include "oracle/rotation.h"
#include "oracle/subjects/canaries/lie.h"
#include "oracle/truth/motion_in_doubles.h"

namespace touchstone::oracle::subjects {
namespace {

Lies runs(Lie<Trajectory> lie) {
  Lies lies;
  lies.simulation = std::move(lie);
  return lies;
}

// Answers the truth about a changed scene.
Lies as_if(const std::function<void(Scene&)>& change) {
  return runs([change](Subject& truthful, const Scene& scene, Trajectory& said) {
    Scene other = scene;
    change(other);
    with(truthful.simulation(other), [&](const Trajectory& answer) { said = answer; });
  });
}

// Answers the truth until the first impact. Then changes that event and continues truthfully from the states after it.
void from_first_impact_on(Subject& truthful, const Scene& scene, Trajectory& said,
                          const std::function<void(Event&, const Scene&)>& change) {
  if (!said.events || said.events->empty() || !scene.motion->forces.empty()) return;
  Event event = said.events->front();
  if (event.kind != Event::Kind::impact) return;
  change(event, scene);
  Scene rest = scene;
  rest.motion->start_times.assign(scene.bodies.size(), event.time);
  std::erase_if(rest.motion->sample_times, [&](double t) { return t <= event.time; });
  if (rest.motion->sample_times.empty()) return;
  for (std::size_t b = 0; b < rest.bodies.size(); ++b) {
    const int body = static_cast<int>(b);
    const State state = body == event.a   ? event.after_a
                        : body == event.b ? event.after_b
                                          : ballistic_state(scene, b, event.time);
    rest.bodies[b].X_WB = state.X_WB;
    rest.bodies[b].velocity = state.velocity;
  }
  with(truthful.simulation(rest), [&](const Trajectory& after) {
    said.events = {event};
    if (after.events) said.events->insert(said.events->end(), after.events->begin(), after.events->end());
    said.states.resize(scene.motion->sample_times.size() - rest.motion->sample_times.size());
    said.states.insert(said.states.end(), after.states.begin(), after.states.end());
    said.complete_until = after.complete_until;
  });
}

Lies first_impact_with(const std::function<void(Event&, const Scene&)>& change) {
  return runs([change](Subject& truthful, const Scene& scene, Trajectory& said) {
    from_first_impact_on(truthful, scene, said, change);
  });
}

/// Changes every sampled state.
Lies each_state(const std::function<void(State&, const Scene&, std::size_t body, double time)>& change) {
  return runs([change](Subject&, const Scene& scene, Trajectory& said) {
    for (std::size_t sample = 0; sample < said.states.size(); ++sample) {
      for (std::size_t body = 0; body < said.states[sample].size(); ++body) {
        change(said.states[sample][body], scene, body, scene.motion->sample_times[sample]);
      }
    }
  });
}

// As if the sides of the parts that it slides over stopped a body.
void trips(State& state, const Scene& scene, std::size_t body, double) {
  const bool has_seams = std::ranges::any_of(
      scene.bodies, [](const Body& of) { return is_fixed(of) && std::holds_alternative<Compound>(of.shape); });
  if (has_seams && !is_fixed(scene.bodies[body])) state.velocity = {};
}

// Drops the second event: it is missed, and the bodies keep their ballistic motion.
void not_keyed_again(Subject&, const Scene&, Trajectory& said) {
  if (said.events && said.events->size() > 1) said.events->erase(said.events->begin() + 1);
}

void ghosts(Subject&, const Scene& scene, Trajectory& said) {
  said.events.emplace();
  for (std::size_t sample = 0; sample < said.states.size(); ++sample) {
    for (std::size_t i = 0; i < said.states[sample].size(); ++i) {
      if (scene.motion->forces.empty())
        said.states[sample][i] = ballistic_state(scene, i, scene.motion->sample_times[sample]);
    }
  }
}

// As if the square of the bodies' size vanished beside that of their distance.
void far_ones_pass(Subject& truthful, const Scene& scene, Trajectory& said) {
  if (scene.bodies.size() != 2) return;
  const double far = (scene.bodies[0].X_WB.p_WB - scene.bodies[1].X_WB.p_WB).norm();
  const double greatest = std::max(size(scene.bodies[0].shape), size(scene.bodies[1].shape));
  if (far > 64 * greatest) ghosts(truthful, scene, said);
}

// An event that has become void: it is told once more, later.
void stale_event(Subject&, const Scene& scene, Trajectory& said) {
  if (!said.events || said.events->empty()) return;
  Event again = said.events->back();
  again.time += (scene.motion->sample_times.back() - again.time) / 2;
  said.events->push_back(again);
}

void overdue(Subject&, const Scene& scene, Trajectory& said) {
  if (said.events && !said.events->empty() && scene.motion->forces.empty()) said.events->back().time += 1e-6;
}

void unstable_tie(Subject&, const Scene&, Trajectory& said) {
  if (!said.events) return;
  for (std::size_t k = 1; k < said.events->size(); ++k) {
    if ((*said.events)[k - 1].time == (*said.events)[k].time) std::swap((*said.events)[k - 1], (*said.events)[k]);
  }
}

void gyroscopic_term_dropped(Scene& scene) {
  for (Body& body : scene.bodies) {
    auto* given = std::get_if<MassProperties>(&body.mass);
    if (given != nullptr) given->I_BBcm_B = given->I_BBcm_B.trace() / 3 * Mat3::Identity();
  }
}

// Combines e and mu of a pair by the maximum.
void greater_coefficients(Scene& scene) {
  Material most;
  for (const Body& body : scene.bodies) {
    most.restitution = std::max(most.restitution, body.material.restitution);
    most.friction = std::max(most.friction, body.material.friction);
  }
  for (Body& body : scene.bodies) body.material = most;
}

// Applies half of the impulse at each of two points.
void two_points(Event& event, const Scene& scene) {
  const auto halved = [&](int body, State& after) {
    const Vec3& before = scene.bodies[static_cast<std::size_t>(body)].velocity.w_WB;
    after.velocity.w_WB = (before + after.velocity.w_WB) / 2;
  };
  halved(event.a, event.after_a);
  halved(event.b, event.after_b);
}

void gains(Event& event, const Scene&) {
  event.after_a.velocity.v_WBcm *= 1 + 1e-6;
  event.after_b.velocity.v_WBcm *= 1 + 1e-6;
}

void nudged(Event& event, const Scene&) { event.after_a.X_WB.p_WB += 1e-6 * event.nhat_BA_W; }

// Takes the lower end of a wide enclosure as the time of impact, as if the trajectory were hard to enclose.
void lower_end(Event& event, const Scene& scene) {
  const auto a = static_cast<std::size_t>(event.a), b = static_cast<std::size_t>(event.b);
  const auto speed = [&](std::size_t body) {
    const Velocity V = ballistic_state(scene, body, event.time).velocity;
    return V.v_WBcm.norm() + size(scene.bodies[body].shape) * V.w_WB.norm();
  };
  const auto start = [&](std::size_t body) {
    return scene.motion->start_times.empty() ? 0 : scene.motion->start_times[body];
  };
  const double early = 0x1p14 * envelope(scene) / (speed(a) + speed(b));
  if (!(early < event.time - std::max(start(a), start(b)))) return;
  event.time -= early;
  event.after_a.X_WB = ballistic_state(scene, a, event.time).X_WB;
  event.after_b.X_WB = ballistic_state(scene, b, event.time).X_WB;
}

// Three or more bodies disturb their neighbours: the first body is displaced.
void crowded(Subject&, const Scene& scene, Trajectory& said) {
  if (scene.bodies.size() < 3) return;
  for (std::vector<State>& states : said.states) states.front().X_WB.p_WB.x() += 1e-12;
}

// The error of explicit Euler steps of 1/100 s.
void steps(State& state, const Scene& scene, std::size_t body, double time) {
  if (!is_fixed(scene.bodies[body])) state.X_WB.p_WB += 0.005 * time * scene.gravity;
}

// The error of semi-implicit Euler steps of 1/64 s; the card claims steps of 1/256 s.
void coarse(State& state, const Scene& scene, std::size_t body, double time) {
  if (!is_fixed(scene.bodies[body])) state.X_WB.p_WB += time / 128 * scene.gravity;
}

void sinks(State& state, const Scene& scene, std::size_t body, double time) {
  if (!is_fixed(scene.bodies[body])) state.X_WB.p_WB.z() -= 1e-3 * time;
}

void creeps(State& state, const Scene& scene, std::size_t body, double time) {
  if (!is_fixed(scene.bodies[body])) state.X_WB.p_WB.x() += 1e-3 * time;
}

void warms(State& state, const Scene&, std::size_t, double time) { state.velocity.v_WBcm *= 1 + 1e-6 * time; }

void cools(State& state, const Scene&, std::size_t, double time) { state.velocity.v_WBcm *= 1 - 1e-6 * time; }

void drags(State& state, const Scene&, std::size_t body, double) {
  if (body == 0) state.velocity.v_WBcm *= 1 - 1e-6;
}

void winds_down(State& state, const Scene&, std::size_t, double) { state.velocity.w_WB *= 0.5; }

void gives_up(Subject&, const Scene& scene, Trajectory& said) {
  const double until = scene.motion->sample_times.front() / 2;
  said.states.clear();
  said.complete_until = until;
  if (said.events) std::erase_if(*said.events, [until](const Event& e) { return e.time > until; });
}

void no_times(Subject&, const Scene&, Trajectory& said) {
  if (!said.states.empty()) said.states.pop_back();
}

double place(const Scene& scene) { return scene.bodies.front().X_WB.p_WB.cwiseAbs().maxCoeff(); }

// Delays impacts with the distance from the origin along one axis and in a moving frame: a world grid interferes.
void world_grid(Subject&, const Scene& scene, Trajectory& said) {
  if (!said.events) return;
  const double speed = scene.bodies.front().velocity.v_WBcm.cwiseAbs().maxCoeff();
  const double heading = std::abs(scene.bodies.front().X_WB.p_WB.x() - scene.bodies.back().X_WB.p_WB.x());
  for (Event& event : *said.events)
    event.time += 1e-4 * event.time * (place(scene) + speed + heading) / (1 + place(scene) + speed + heading);
}

// The order in which bodies are listed, or the side on which they lie, changes when they have impacts.
void left_before_right(Subject&, const Scene& scene, Trajectory& said) {
  if (!said.events || scene.bodies.front().X_WB.p_WB.x() >= scene.bodies.back().X_WB.p_WB.x()) return;
  for (Event& event : *said.events) event.time *= 1 + 1e-6;
}

// The last bit of a position depends on a force that is yet to come.
void foresees(State& state, const Scene& scene, std::size_t body, double time) {
  for (const AppliedForce& applied : scene.motion->forces) {
    if (static_cast<std::size_t>(applied.body) != body || applied.time <= time || applied.force_W.sum() <= 0) continue;
    state.X_WB.p_WB.x() = std::nextafter(state.X_WB.p_WB.x(), INFINITY);
  }
}

// Half of the change of spin, reported as an impulse that no law of restitution judges.
void half_a_twist(Event& event, const Scene& scene) {
  event.kind = Event::Kind::micro_collision;
  two_points(event, scene);
}

// Turns a body and its spin about its angular momentum, which changes neither that nor the energy.
void top_leads(State& state, const Scene& scene, std::size_t body, double time) {
  const auto* given = std::get_if<MassProperties>(&scene.bodies[body].mass);
  const Vec3 w = state.velocity.w_WB;
  if (given == nullptr || w.isZero(0)) return;
  const Eigen::Quaterniond R_WB = rotation(state.X_WB.q_WB);
  const Vec3 L = R_WB * (given->I_BBcm_B * (R_WB.conjugate() * w));
  const Eigen::Quaterniond ahead(Eigen::AngleAxisd(1e-6 * time, L.normalized()));
  state.X_WB.q_WB = quaternion(ahead * R_WB);
  state.velocity.w_WB = ahead * w;
}

// Turns balls by the integral of their angular velocity, as if rotations about different axes commuted.
void adds_angles(State& state, const Scene& scene, std::size_t body, double time) {
  const Body& start = scene.bodies[body];
  if (!std::holds_alternative<Sphere>(start.shape) || !scene.motion->start_times.empty()) return;
  const Vec3 angle = time / 2 * (start.velocity.w_WB + state.velocity.w_WB);
  if (is_fixed(start) || angle.isZero(0)) return;
  const Eigen::AngleAxisd turn(angle.norm(), angle.normalized());
  state.X_WB.q_WB = quaternion(turn * rotation(start.X_WB.q_WB));
}

// Another friction. Without events, the law of single impacts does not show it.
Lies with_friction(double factor) {
  return runs([factor](Subject& truthful, const Scene& scene, Trajectory& said) {
    Scene other = scene;
    for (Body& body : other.bodies) body.material.friction *= factor;
    with(truthful.simulation(other), [&](const Trajectory& answer) { said = answer; });
    said.events.reset();
  });
}

// A body that starts at rest in contact stays there, wherever its centre of mass is.
void clings(Subject& truthful, const Scene& scene, Trajectory& said) {
  std::vector<State> stays;
  for (const Body& body : scene.bodies) {
    if (body.velocity != Velocity{}) return;
    stays.push_back({body.X_WB, {}});
  }
  std::vector<Event> contacts;
  for (std::size_t b = 1; b < stays.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      Scene pair;
      pair.bodies = {scene.bodies[a], scene.bodies[b]};
      if (distance_by(truthful, pair) > envelope(scene)) continue;
      Event contact;
      contact.kind = Event::Kind::contact;
      contact.a = static_cast<int>(a);
      contact.b = static_cast<int>(b);
      contact.after_a = stays[a];
      contact.after_b = stays[b];
      contacts.push_back(std::move(contact));
    }
  }
  if (contacts.empty()) return;
  said = Trajectory{};
  said.states.assign(scene.motion->sample_times.size(), stays);
  said.events = std::move(contacts);
}

void last_sample(Subject&, const Scene&, Trajectory& said) {
  if (said.states.empty()) return;
  for (State& state : said.states.back()) state.X_WB.p_WB.y() += 1e-9;
}

// The first impact by the law of one contact point at p_WC.
void resolved_at(Subject& truthful, const Scene& scene, Event& event, const Vec3& p_WC) {
  Scene pair;
  for (const auto& [body, after] : {std::pair(event.a, &event.after_a), {event.b, &event.after_b}}) {
    const auto b = static_cast<std::size_t>(body);
    pair.bodies.push_back(scene.bodies[b]);
    pair.bodies.back().X_WB = after->X_WB;
    pair.bodies.back().velocity = ballistic_state(scene, b, event.time).velocity;
  }
  const Material &A = pair.bodies[0].material, &B = pair.bodies[1].material;
  pair.contact.emplace();
  pair.contact->p_WC = p_WC;
  pair.contact->nhat_BA_W = event.nhat_BA_W;
  pair.contact->restitution = std::min(A.restitution, B.restitution);
  pair.contact->friction = std::min(A.friction, B.friction);
  pair.contact->law = scene.motion->law;
  with(truthful.impulse(pair), [&](const Impulse& said) {
    if (!said.P_A_W) return;
    event.p_WC = p_WC;
    event.P_A_W = *said.P_A_W;
    event.after_a.velocity = said.after[0];
    event.after_b.velocity = said.after[1];
  });
}

// The first of the corners that touch takes the impact alone.
void one_corner(Subject& truthful, const Scene& scene, Trajectory& said) {
  from_first_impact_on(truthful, scene, said, [&](Event& event, const Scene&) {
    const bool second = is_fixed(scene.bodies[static_cast<std::size_t>(event.a)]);
    const Body& body = scene.bodies[static_cast<std::size_t>(second ? event.b : event.a)];
    if (std::holds_alternative<Sphere>(body.shape)) return;
    const Pose& X_WB = second ? event.after_b.X_WB : event.after_a.X_WB;
    const Eigen::Quaterniond R(X_WB.q_WB.w, X_WB.q_WB.x, X_WB.q_WB.y, X_WB.q_WB.z);
    for (const Vec3& corner : corners(body)) {
      const Vec3 p_WC = R.normalized() * corner + X_WB.p_WB;
      if (std::abs(event.nhat_BA_W.dot(p_WC - event.p_WC)) > 2 * envelope(scene)) continue;
      return resolved_at(truthful, scene, event, p_WC);
    }
  });
}

// Of several pairs that collide at one time, the first does so alone.
void one_pair_first(Subject& truthful, const Scene& scene, Trajectory& said) {
  from_first_impact_on(truthful, scene, said,
                       [&](Event& event, const Scene&) { resolved_at(truthful, scene, event, event.p_WC); });
}

// A rounding that always goes the same way, as if the world had a right-hand side.
void leans(Event& event, const Scene&) {
  event.after_a.velocity.v_WBcm.x() += std::abs(event.after_a.velocity.v_WBcm.x()) / 64;
}

bool is_beside_another_impact(const Trajectory& said, const Event& event) {
  const auto acts_with = [&](const Event& other) {
    const bool shares = event.a == other.a || event.a == other.b || event.b == other.a || event.b == other.b;
    return &other != &event && other.time == event.time && other.kind == Event::Kind::impact && shares;
  };
  return event.kind == Event::Kind::impact && std::ranges::any_of(*said.events, acts_with);
}

// Impulses at one time on one body are reported with a millionth of friction too much.
void sticky_together(Subject&, const Scene& scene, Trajectory& said) {
  if (!said.events) return;
  for (Event& event : *said.events) {
    if (!is_beside_another_impact(said, event)) continue;
    const double mu = std::min(scene.bodies[static_cast<std::size_t>(event.a)].material.friction,
                               scene.bodies[static_cast<std::size_t>(event.b)].material.friction);
    const Vec3& n = event.nhat_BA_W;
    const double P_n = event.P_A_W.dot(n);
    event.P_A_W = P_n * n + (1 + 1e-6) * mu * P_n * n.unitOrthogonal() + 1e-6 * P_n * n.unitOrthogonal();
  }
}

// Where impacts are at one time on one body, restitution is a thousandth too small.
void damped_together(Subject& truthful, const Scene& scene, Trajectory& said) {
  const auto is_beside = [&](const Event& event) { return is_beside_another_impact(said, event); };
  if (!said.events || std::ranges::none_of(*said.events, is_beside)) return;
  Scene other = scene;
  for (Body& body : other.bodies) body.material.restitution *= 0.999;
  with(truthful.simulation(other), [&](const Trajectory& answer) { said = answer; });
}

// Impacts at one time on one body make bodies twice as fast as they should.
void kicks_together(Subject&, const Scene&, Trajectory& said) {
  if (!said.events) return;
  for (Event& event : *said.events) {
    if (!is_beside_another_impact(said, event)) continue;
    event.after_a.velocity.v_WBcm *= 2;
    event.after_b.velocity.v_WBcm *= 2;
  }
}

// The second event, if the first two are impacts of one pair.
Event* second_of_two_impacts(Trajectory& said) {
  if (!said.events || said.events->size() < 2) return nullptr;
  const Event& first = said.events->front();
  Event& second = (*said.events)[1];
  const bool of_one_pair = first.a == second.a && first.b == second.b;
  return of_one_pair && first.kind == Event::Kind::impact && second.kind == Event::Kind::impact ? &second : nullptr;
}

// The first two impacts of one pair are reported as a completed series, with the impulse of the second one.
void sums_up_the_last(Subject&, const Scene&, Trajectory& said) {
  Event* second = second_of_two_impacts(said);
  if (second == nullptr) return;
  second->kind = Event::Kind::completed;
  said.events->erase(said.events->begin());
}

// The second of the first two impacts of one pair is reported as the end of all bounces after the first.
void ends_bounces_early(Subject&, const Scene&, Trajectory& said) {
  if (Event* second = second_of_two_impacts(said)) second->kind = Event::Kind::completed;
}

void carries_air(Scene& scene) {
  for (Body& body : scene.bodies) {
    if (auto* density = std::get_if<Density>(&body.mass)) density->value += 1e-6;
  }
}

// As if it went on from the rounded state of each sample.
void shaken(State& state, const Scene& scene, std::size_t, double time) {
  const std::vector<double>& times = scene.motion->sample_times;
  state.X_WB.p_WB.x() += 1e-12 * static_cast<double>(std::ranges::upper_bound(times, time) - times.begin());
}

}  // namespace

std::vector<Canary> canaries_about_simulations() {
  return {
      lying("canary.not_keyed_again", "does not notice the second event", [] { return runs(not_keyed_again); }),
      lying("canary.ghosts", "lets bodies pass through each other", [] { return runs(ghosts); }),
      lying("canary.trips", "stops bodies on tables of several parts", [] { return each_state(trips); }),
      lying("canary.far_ones_pass", "lets two bodies pass that start more than 64 sizes apart",
            [] { return runs(far_ones_pass); }),
      lying("canary.stale_event", "runs an event that has become void", [] { return runs(stale_event); }),
      lying("canary.unstable_tie", "resolves what happens at one time in the other order",
            [] { return runs(unstable_tie); }),
      lying("canary.gyroscopic_term_dropped", "keeps the angular velocity between impacts",
            [] { return as_if(gyroscopic_term_dropped); }),
      lying("canary.apex_ignored", "moves bodies along straight lines between impacts",
            [] { return as_if([](Scene& scene) { scene.gravity.setZero(); }); }),
      lying("canary.greater_coefficients", "takes the greater e and mu of a pair",
            [] { return as_if(greater_coefficients); }),
      lying("canary.pushes_ignored", "does not let forces act",
            [] {
              return runs([](Subject& truthful, const Scene& scene, Trajectory& said) {
                if (scene.motion->forces.empty()) return;
                Scene other = scene;
                other.motion->forces.clear();
                with(truthful.simulation(other), [&](const Trajectory& answer) { said = answer; });
              });
            }),
      lying("canary.impulse_at_two_points", "halves the impulse between two points",
            [] { return first_impact_with(two_points); }),
      lying("canary.impact_gains", "makes bodies a millionth faster by the first impact",
            [] { return first_impact_with(gains); }),
      lying("canary.impact_moves", "moves a body when it is hit", [] { return first_impact_with(nudged); }),
      lying("canary.overdue", "reports the last event a microsecond late", [] { return runs(overdue); }),
      lying("canary.lower_end", "takes the lower end of a wide enclosure: thousands of envelopes early",
            [] { return first_impact_with(lower_end); }),
      lying("canary.contact_elsewhere", "reports an impact at the body's centre",
            [] { return first_impact_with([](Event& event, const Scene&) { event.p_WC = event.after_a.X_WB.p_WB; }); }),
      lying("canary.crowded", "moves others once there are three bodies", [] { return runs(crowded); }),
      lying("canary.explicit_steps", "falls by explicit steps of a hundredth of a second",
            [] { return each_state(steps); }),
      lying("canary.coarse_steps", "takes steps four times as long as it declares",
            [] {
              Lies lies = each_state(coarse);
              lies.stepping = Stepping{1.0 / 256, 1};
              return lies;
            }),
      lying("canary.sinks_slowly", "lets bodies sink by 1 mm/s", [] { return each_state(sinks); }),
      lying("canary.creeps", "lets bodies creep by 1 mm/s", [] { return each_state(creeps); }),
      lying("canary.warms", "makes bodies faster by a millionth each second", [] { return each_state(warms); }),
      lying("canary.cools", "makes bodies slower by a millionth each second", [] { return each_state(cools); }),
      lying("canary.first_body_drags", "slows the first body by a millionth", [] { return each_state(drags); }),
      lying("canary.winds_down", "halves the spins that it reports", [] { return each_state(winds_down); }),
      lying("canary.stops_early", "ends half-way to the first sample", [] { return runs(gives_up); }),
      lying("canary.look_missing", "leaves out the last sample", [] { return runs(no_times); }),
      lying("canary.world_grid", "reports impacts later, the farther and faster bodies are",
            [] { return runs(world_grid); }),
      lying("canary.left_before_right", "reports impacts later if the first body is on the left of the last",
            [] { return runs(left_before_right); }),
      lying("canary.foresees", "knows a force before its time, in the last bit", [] { return each_state(foresees); }),
      lying("canary.half_a_twist", "gives half of its spin to a body that is hit, by a micro-collision",
            [] { return first_impact_with(half_a_twist); }),
      lying("canary.top_leads", "turns tops a millionth of a radian too far each second",
            [] { return each_state(top_leads); }),
      lying("canary.adds_angles", "turns balls by the sum of angles, about whatever axes",
            [] { return each_state(adds_angles); }),
      lying("canary.starts_anew", "takes a state at a later time for one at time 0",
            [] { return as_if([](Scene& scene) { scene.motion->start_times.clear(); }); }),
      lying("canary.slippery", "halves all friction, and reports no events", [] { return with_friction(0.5); }),
      lying("canary.grips", "doubles all friction, and reports no events", [] { return with_friction(2); }),
      lying("canary.clings", "keeps a body that starts in contact where it is, whatever it is on",
            [] { return runs(clings); }),
      lying("canary.one_corner", "lets the first corner that touches take an impact alone",
            [] { return runs(one_corner); }),
      lying("canary.one_pair_first", "resolves the first of several pairs that collide at one time alone",
            [] { return runs(one_pair_first); }),
      lying("canary.leans", "makes a body faster to the right and slower to the left by the first impact",
            [] { return first_impact_with(leans); }),
      lying("canary.sticky_together", "reports impulses that act together with a millionth of friction too much",
            [] { return runs(sticky_together); }),
      lying("canary.damped_together", "has a thousandth less restitution where impacts act together",
            [] { return runs(damped_together); }),
      lying("canary.kicks_together", "makes bodies twice as fast by impacts that act together",
            [] { return runs(kicks_together); }),
      lying("canary.last_sample", "moves all bodies by a nanometre in the last sample alone",
            [] { return runs(last_sample); }),
      lying("canary.ends_bounces_early", "reports the second of two impacts as the end of all bounces after the first",
            [] { return runs(ends_bounces_early); }),
      lying("canary.sums_up_the_last", "reports two impacts as a completed series, with the impulse of the second one",
            [] { return runs(sums_up_the_last); }),
      lying("canary.nanometre", "is off by a nanometre, however large bodies are",
            [] {
              return each_state([](State& state, const Scene&, std::size_t, double) { state.X_WB.p_WB.x() += 1e-9; });
            }),
      lying("canary.carries_air", "adds 1e-6 kg/m³ to the density of each body", [] { return as_if(carries_air); }),
      lying("canary.rounded_by_samples", "moves bodies by a picometre at each sample",
            [] { return each_state(shaken); }),
  };
}

}  // namespace touchstone::oracle::subjects
