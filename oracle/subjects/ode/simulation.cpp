#include "oracle/subjects/ode/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "oracle/subject.h"
#include "oracle/subjects/common/simulation_world.h"
#include "oracle/subjects/ode/input.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_ode;
using Stepper = int (*)(dWorldID, dReal);

Vec3 vec3(const dReal* v) { return {v[0], v[1], v[2]}; }

struct MakeGeom {
  dSpaceID space;

  dGeomID operator()(const Polytope&) const { return nullptr; }  // declined earlier
  dGeomID operator()(const auto& round_or_box) const { return geom(space, round_or_box); }
};

class World : public SimulationWorld {
 public:
  World(const Scene& scene, Stepper stepper) : scene_(scene), stepper_(stepper) {
    dWorldSetGravity(world_, real(scene.gravity.x()), real(scene.gravity.y()), real(scene.gravity.z()));
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) add(static_cast<int>(i));
  }
  ~World() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void step(double seconds, const std::vector<Vec3>& forces_W) override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Vec3& F = forces_W[i];
      if (bodies_[i] != nullptr) dBodyAddForce(bodies_[i], real(F.x()), real(F.y()), real(F.z()));
    }
    dSpaceCollide(space_, this, [](void* world, dGeomID a, dGeomID b) { static_cast<World*>(world)->touch(a, b); });
    stepper_(world_, real(seconds));
    dJointGroupEmpty(contacts_);
  }

  State state(int i) const override {
    const Body& body = scene_.bodies[static_cast<std::size_t>(i)];
    const dBodyID moved = bodies_[static_cast<std::size_t>(i)];
    if (moved == nullptr) return {body.X_WB, {}};
    const dReal* q = dBodyGetQuaternion(moved);
    return {pose_of_body(vec3(dBodyGetPosition(moved)), {q[0], q[1], q[2], q[3]}, {centre(body), {}}),
            velocity_of(moved)};
  }

 private:
  static Vec3 centre(const Body& body) {
    const auto* given = std::get_if<MassProperties>(&body.mass);
    return given != nullptr ? given->p_BBcm : Vec3::Zero();
  }

  void add(int i) {
    const Body& body = scene_.bodies[static_cast<std::size_t>(i)];
    const bool at_rest = is_fixed(body) && body.velocity == Velocity{};
    bodies_.push_back(at_rest ? nullptr : put(world_, body));
    if (!is_fixed(body)) {
      const dMass mass = mass_of(body);
      dBodySetMass(bodies_.back(), &mass);
    } else if (!at_rest) {
      dBodySetKinematic(bodies_.back());
    }
    for (const Part& part : parts_of(body.shape)) place(std::visit(MakeGeom{space_}, part.shape), i, part.X_BP);
  }

  void place(dGeomID geom, int i, const Pose& X_BP) {
    const Body& body = scene_.bodies[static_cast<std::size_t>(i)];
    dGeomSetData(geom, reinterpret_cast<void*>(static_cast<std::intptr_t>(i)));
    if (const dBodyID moved = bodies_.back()) {
      const Vec3 p = X_BP.p_WB - centre(body);
      dGeomSetBody(geom, moved);
      dGeomSetOffsetPosition(geom, real(p.x()), real(p.y()), real(p.z()));
      dGeomSetOffsetQuaternion(geom, turn(rotation(X_BP.q_WB)).data());
    } else {
      const Eigen::Quaterniond q_WB = rotation(body.X_WB.q_WB);
      const Vec3 p = body.X_WB.p_WB + q_WB * X_BP.p_WB;
      dGeomSetPosition(geom, real(p.x()), real(p.y()), real(p.z()));
      dGeomSetQuaternion(geom, turn(q_WB * rotation(X_BP.q_WB)).data());
    }
  }

  const Material& material(dGeomID geom) const {
    return scene_.bodies[reinterpret_cast<std::size_t>(dGeomGetData(geom))].material;
  }

  void touch(dGeomID a, dGeomID b) {
    if (dGeomGetBody(a) == dGeomGetBody(b)) return;
    std::array<dContact, 64> contacts{};
    const int count = dCollide(a, b, static_cast<int>(contacts.size()), &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      dSurfaceParameters& surface = contacts[static_cast<std::size_t>(i)].surface;
      surface.mode = dContactBounce | dContactApprox1;  // friction is a coefficient, not a maximum force
      surface.bounce = real(std::min(material(a).restitution, material(b).restitution));
      surface.bounce_vel = 0;
      surface.mu = real(std::min(material(a).friction, material(b).friction));
      const dJointID joint = dJointCreateContact(world_, contacts_, &contacts[static_cast<std::size_t>(i)]);
      dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
    }
  }

  const Scene& scene_;
  Stepper stepper_;
  dWorldID world_ = dWorldCreate();
  dSpaceID space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);  // the hash space misses pairs in a heap
  dJointGroupID contacts_ = dJointGroupCreate(0);
  std::vector<dBodyID> bodies_;
};

class OdeSimulation : public Subject {
 public:
  OdeSimulation(const std::string& settings, double dt)
      : stepper_(settings == "simulation" ? &dWorldStep : &dWorldQuickStep), dt_(dt) {
    card_ = in_ode::card(
        settings,
        std::string(settings == "simulation" ? "dWorldStep" : "dWorldQuickStep") + ", equal steps of at most 1/" +
            std::to_string(std::lround(1 / dt)) +
            " s between sample times; dSweepAndPruneSpace, contacts with dContactBounce, bounce_vel 0, "
            "dContactApprox1, e and mu of a pair the lesser; ERP, CFM and the rest as shipped, sleeping disabled");
    card_.answers = {"simulation"};
    card_.dynamics.friction_pyramid = true;
    card_.stepping = Stepping{dt, 1};
  }

  const Card& card() const override { return card_; }

  Answer<Trajectory> simulation(const Scene& scene) override {
    if (const auto declined = no_such_motion(scene)) return *declined;
    if (std::ranges::any_of(scene.bodies, has_hull)) return Abstains{no_hulls};
    start_random_numbers();
    World world(scene, stepper_);
    return follow(scene, dt_, world);
  }

 private:
  Stepper stepper_;
  double dt_;
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_ode_simulation(const std::string& stepper) {
  return make_ode_simulation(stepper, default_step);
}

std::unique_ptr<Subject> make_ode_simulation(const std::string& stepper, double dt) {
  return std::make_unique<OdeSimulation>(stepper, dt);
}

}  // namespace touchstone::oracle::subjects
