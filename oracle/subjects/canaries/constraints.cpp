// Canaries that lie about balls on tables: the faults of an implementation that does not follow the changing set of
// constraints.
#include <cmath>
#include <functional>

#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {
namespace {

Lies trajectories(Lie<Trajectory> lie) {
  Lies lies;
  lies.constraint = std::move(lie);
  return lies;
}

// Answers the truth about a changed scene; if the truthful subject has no answer for it, keeps the answer as it was.
Lies as_if(const std::function<void(Scene&)>& change) {
  return trajectories([change](Subject& truthful, const Scene& scene, Trajectory& said) {
    Scene other = scene;
    change(other);
    with(truthful.constraint(other), [&](const Trajectory& answer) { said = answer; });
  });
}

// Changes the states of all bodies that are not fixed.
Lies each_state(const std::function<void(State&, const Body&)>& change) {
  return trajectories([change](Subject&, const Scene& scene, Trajectory& said) {
    for (std::vector<State>& states : said.states) {
      for (std::size_t i = 0; i < states.size(); ++i) {
        if (!is_fixed(scene.bodies[i])) change(states[i], scene.bodies[i]);
      }
    }
  });
}

Lies each_event(const std::function<void(Event&)>& change) {
  return trajectories([change](Subject&, const Scene&, Trajectory& said) {
    if (!said.events) return;
    for (Event& event : *said.events) change(event);
  });
}

template <class Change>
void each_body(Scene& scene, bool fixed, Change&& change) {
  for (Body& body : scene.bodies) {
    if (is_fixed(body) == fixed) change(body);
  }
}

void endless_table(Scene& scene) {
  each_body(scene, true, [](Body& table) {
    if (Box* box = std::get_if<Box>(&table.shape)) {
      box->half_extents.x() *= 64;
      box->half_extents.y() *= 64;
    }
  });
}

void hollow(Scene& scene) {
  each_body(scene, false, [](Body& ball) {
    const Sphere* sphere = std::get_if<Sphere>(&ball.shape);
    if (sphere == nullptr) return;
    const double I = 2.0 / 3 * sphere->radius * sphere->radius;
    ball.mass = MassProperties{1, Vec3::Zero(), Mat3(I * Mat3::Identity())};
  });
}

void without_obstacle(Scene& scene) {
  if (scene.bodies.size() > 2) scene.bodies[2].X_WB.p_WB.x() += 1024;
}

void forgets_releases(Subject&, const Scene&, Trajectory& said) {
  if (said.events) std::erase_if(*said.events, [](const Event& e) { return e.kind == Event::Kind::release; });
}

void as_fast_as_at_first(Subject&, const Scene&, Trajectory& said) {
  for (std::size_t i = 0; said.states.size() > 2 && i < said.states.back().size(); ++i)
    said.states.back()[i].velocity = said.states.front()[i].velocity;
}

void ends_without_saying(Subject&, const Scene&, Trajectory& said) {
  if (!said.states.empty()) said.states.pop_back();
}

void far_is_elsewhere(Subject&, const Scene& scene, Trajectory& said) {
  const Vec3& start = scene.bodies.front().X_WB.p_WB;
  for (std::vector<State>& states : said.states) {
    for (State& state : states) state.X_WB.p_WB.x() += (std::abs(start.x()) + std::abs(start.y())) / 20;
  }
}

void to_the_right(State& state, const Body& body) {
  if (const Sphere* sphere = std::get_if<Sphere>(&body.shape)) state.X_WB.p_WB.x() += sphere->radius / 2;
}

void last_ball_to_the_right(Subject&, const Scene& scene, Trajectory& said) {
  for (std::vector<State>& states : said.states) {
    if (!is_fixed(scene.bodies.back())) to_the_right(states.back(), scene.bodies.back());
  }
}

void pulls_down(State& state, const Body& body) {
  if (const Sphere* sphere = std::get_if<Sphere>(&body.shape)) state.X_WB.p_WB.z() -= sphere->radius / 2;
}

}  // namespace

std::vector<Canary> canaries_about_constraints() {
  return {
      lying("canary.endless_table", "never lets a ball roll off", [] { return as_if(endless_table); }),
      lying("canary.hollow_ball", "takes every ball for a shell", [] { return as_if(hollow); }),
      lying(
          "canary.frictionless_table", "lets balls slide for ever",
          [] { return as_if([](Scene& scene) { each_body(scene, true, [](Body& b) { b.material.friction = 0; }); }); }),
      lying("canary.rubber", "doubles all friction",
            [] {
              return as_if([](Scene& scene) {
                for (Body& body : scene.bodies) body.material.friction *= 2;
              });
            }),
      lying("canary.no_bounce", "takes 0 for every e",
            [] {
              return as_if([](Scene& scene) { each_body(scene, false, [](Body& b) { b.material.restitution = 0; }); });
            }),
      lying("canary.obstacle_forgotten", "does not see the third body", [] { return as_if(without_obstacle); }),
      lying("canary.gravity_along_z", "lets gravity pull along −z, wherever it points",
            [] { return as_if([](Scene& scene) { scene.gravity = Vec3(0, 0, -scene.gravity.norm()); }); }),
      lying("canary.half_gravity", "halves gravity", [] { return as_if([](Scene& scene) { scene.gravity *= 0.5; }); }),
      lying("canary.releases_forgotten", "never reports that a contact ends",
            [] { return trajectories(forgets_releases); }),
      lying("canary.last_look_missing", "leaves out the last sample, and does not say so",
            [] { return trajectories(ends_without_saying); }),
      lying("canary.sinks", "lets balls sink by half their radius", [] { return each_state(pulls_down); }),
      lying("canary.far_is_elsewhere",
            "puts bodies off by a twentieth of how far the first one started from the z axis",
            [] { return trajectories(far_is_elsewhere); }),
      lying("canary.veers", "puts balls half their radius too far to the right",
            [] { return each_state(to_the_right); }),
      lying("canary.last_ball_lags", "puts a ball half its radius too far to the right if no body is listed after it",
            [] { return trajectories(last_ball_to_the_right); }),
      lying("canary.speeds_up", "makes every ball twice as fast as it is",
            [] { return each_state([](State& state, const Body&) { state.velocity.v_WBcm *= 2; }); }),
      lying("canary.spin_forgotten", "reports no spin of any ball",
            [] { return each_state([](State& state, const Body&) { state.velocity.w_WB.setZero(); }); }),
      lying("canary.fixed_body_creeps", "lets fixed bodies creep by 1e-9 m",
            [] {
              return trajectories([](Subject&, const Scene& scene, Trajectory& said) {
                for (std::vector<State>& states : said.states) {
                  for (std::size_t i = 0; i < states.size(); ++i) {
                    if (is_fixed(scene.bodies[i])) states[i].X_WB.p_WB.x() += 1e-9;
                  }
                }
              });
            }),
      lying("canary.second_wind", "says that bodies are as fast at the last sample as at the first",
            [] { return trajectories(as_fast_as_at_first); }),
      lying("canary.early_events", "tells events at nine tenths of their times",
            [] { return each_event([](Event& event) { event.time *= 0.9; }); }),
      lying("canary.point_at_centre", "takes the first body's centre for the point of contact",
            [] { return each_event([](Event& event) { event.p_WC = event.after_a.X_WB.p_WB; }); }),
      lying("canary.contacts_pull", "lets contacts pull",
            [] { return each_event([](Event& event) { event.P_A_W = -event.P_A_W; }); }),
      lying("canary.triple_friction", "triples the friction of impacts",
            [] {
              return each_event([](Event& event) {
                const Vec3 normal = event.nhat_BA_W.dot(event.P_A_W) * event.nhat_BA_W;
                event.P_A_W = normal + 3 * (event.P_A_W - normal);
              });
            }),
  };
}

}  // namespace touchstone::oracle::subjects
