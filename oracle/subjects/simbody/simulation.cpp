#include "oracle/subjects/simbody/simulation.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "model/box_vertices.h"
#include "oracle/subject.h"
#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/common/simulation_world.h"
#include "oracle/subjects/simbody/input.h"
#include "oracle/subjects/simbody/rigid_bodies.h"

namespace touchstone::oracle::subjects {
namespace {

using in_simbody::Coefficients;

/// Thrown if Simbody has no contact for the scene; the message becomes the abstention's reason.
struct Declined : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A ball, or a corner (radius 0), of a moving body.
struct Knob {
  Vec3 p_BC;
  double radius;
};

std::vector<Knob> knobs(const Body& body) {
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) return {{Vec3::Zero(), sphere->radius}};
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr) throw Declined("only contacts of balls and of corners are offered");
  std::vector<Knob> corners;
  for (const Vec3& corner : vertices_of(*box)) corners.push_back({corner, 0});
  return corners;
}

Vec3 centre_of(const Body& body) {
  const auto* given = std::get_if<MassProperties>(&body.mass);
  return given != nullptr ? given->p_BBcm : Vec3::Zero();
}

/// A face of a fixed box. Simbody treats it as an infinite plane, so a point that touches it must lie above the face.
class Face {
 public:
  /// Axis 0, 1 or 2 of the box; sign −1 or 1.
  Face(const Body& box, int axis, int sign) : box_(box), axis_(axis), sign_(sign) {}

  in_simbody::Face plane() const {
    const Vec3 n = sign_ * Vec3::Unit(axis_);
    const Eigen::Quaterniond q = rotation(box_.X_WB.q_WB);
    return {box_.X_WB.p_WB + q * (half()[axis_] * n), q * n};
  }
  double height(const Vec3& p_WC) const { return sign_ * in_box(p_WC)[axis_] - half()[axis_]; }
  bool is_below(const Vec3& p_WC) const {
    Vec3 beyond = in_box(p_WC).cwiseAbs() - half();
    beyond[axis_] = 0;
    return beyond.maxCoeff() <= 0;
  }

 private:
  const Vec3& half() const { return std::get<Box>(box_.shape).half_extents; }
  Vec3 in_box(const Vec3& p_WC) const { return rotation(box_.X_WB.q_WB).conjugate() * (p_WC - box_.X_WB.p_WB); }

  const Body& box_;
  int axis_, sign_;
};

double lowest(const Face& face, const Body& body) {
  double height = INFINITY;
  for (const Knob& knob : knobs(body)) {
    const Vec3 p_WC = body.X_WB.p_WB + rotation(body.X_WB.q_WB) * knob.p_BC;
    height = std::min(height, face.height(p_WC) - knob.radius);
  }
  return height;
}

/// The face from which the body is farthest on the outer side.
Face nearest_face(const Body& box, const Body& body) {
  std::array<Face, 6> faces = {Face(box, 0, -1), Face(box, 0, 1),  Face(box, 1, -1),
                               Face(box, 1, 1),  Face(box, 2, -1), Face(box, 2, 1)};
  return *std::ranges::max_element(faces,
                                   [&](const Face& a, const Face& b) { return lowest(a, body) < lowest(b, body); });
}

class World : public SimulationWorld {
 public:
  explicit World(const Scene& scene) : scene_(scene) {
    std::vector<in_simbody::RigidBody> bodies;
    for (const Body& body : scene.bodies) {
      if (is_fixed(body) && !(body.velocity == Velocity{})) throw Declined("moving fixed bodies are not offered");
      bodies.push_back(in_simbody::rigid(body));
    }
    for (std::size_t a = 0; a < bodies.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) declare(a, b);
    }
    const auto law =
        scene.motion->law == Law::newton ? in_simbody::Restitution::newton : in_simbody::Restitution::poisson;
    rigid_bodies_.emplace(bodies, on_faces_, on_balls_, scene.gravity, law);
  }

  void step(double seconds, const std::vector<Vec3>& forces_W) override {
    rigid_bodies_->step(seconds, forces_W);
    for (std::size_t i = 0; i < on_faces_.size(); ++i) stay_on(faces_[i], on_faces_[i]);
  }

  State state(int i) const override {
    const Body& body = scene_.bodies[static_cast<std::size_t>(i)];
    const in_simbody::Place place = rigid_bodies_->place(static_cast<std::size_t>(i));
    return {pose_of_body(place.p_WBcm, place.q_WB, {centre_of(body), {}}), {place.twist.v_WBcm, place.twist.w_WB}};
  }

 private:
  void declare(std::size_t a, std::size_t b) {
    const Body &A = scene_.bodies[a], &B = scene_.bodies[b];
    if (is_fixed(A) && is_fixed(B)) return;
    const Coefficients pair{std::min(A.material.restitution, B.material.restitution),
                            std::min(A.material.friction, B.material.friction)};
    const auto *ball_A = std::get_if<Sphere>(&A.shape), *ball_B = std::get_if<Sphere>(&B.shape);
    if (ball_A != nullptr && ball_B != nullptr) {
      if (!centre_of(A).isZero(0) || !centre_of(B).isZero(0))
        throw Declined("a ball's centre of mass must be its centre");
      on_balls_.push_back({a, b, ball_A->radius, ball_B->radius, pair});
    } else if (is_fixed(A) && std::holds_alternative<Box>(A.shape)) {
      put_on(A, b, pair);
    } else if (is_fixed(B) && std::holds_alternative<Box>(B.shape)) {
      put_on(B, a, pair);
    } else {
      throw Declined("only contacts between balls, and of balls and corners with fixed bodies, are offered");
    }
  }

  void put_on(const Body& box, std::size_t i, const Coefficients& pair) {
    const Body& body = scene_.bodies[i];
    const Face face = nearest_face(box, body);
    for (const Knob& knob : knobs(body)) {
      on_faces_.push_back({i, knob.p_BC - centre_of(body), knob.radius, face.plane(), pair});
      faces_.push_back(face);
    }
  }

  /// Declines when a contact within Simbody's tolerance leaves its face.
  void stay_on(const Face& face, const in_simbody::OnFace& contact) const {
    const in_simbody::Place place = rigid_bodies_->place(contact.body);
    const Vec3 p_WC = place.p_WBcm + place.q_WB * contact.p_BC;
    const bool touches = face.height(p_WC) - contact.radius <= in_simbody::default_tolerance;
    if (touches && !face.is_below(p_WC))
      throw Declined("contacts are declared in advance, and this one leaves its face");
  }

  const Scene& scene_;
  std::vector<in_simbody::OnFace> on_faces_;
  std::vector<Face> faces_;  ///< faces_[i] belongs to on_faces_[i]
  std::vector<in_simbody::BallOnBall> on_balls_;
  std::optional<in_simbody::RigidBodies> rigid_bodies_;
};

class SimbodySimulation : public Subject {
 public:
  explicit SimbodySimulation(double dt) : dt_(dt) {
    card_.name = "simbody.simulation";
    card_.version = in_simbody::version();
    card_.answers = {"simulation"};
    card_.stepping = Stepping{dt, 1};
    card_.about =
        "SemiExplicitEulerTimeStepper with the PLUS solver, equal steps of at most 1/" +
        std::to_string(std::lround(1 / dt)) +
        " s between sample times; contacts declared in advance: balls, and balls and corners on the faces of fixed "
        "boxes, e and mu of a pair the lesser; settings as shipped: constraint tolerance 1e-3, below 2e-3 m/s "
        "nothing is restored";
    card_.dynamics.restitution_threshold = in_simbody::default_capture;
    card_.homepage = "https://github.com/simbody/simbody";
    card_.domain = customary_domain();
  }

  const Card& card() const override { return card_; }

  Answer<Trajectory> simulation(const Scene& scene) override try {
    const bool by_newton = scene.motion && scene.motion->law == Law::newton;
    if (const auto declined = no_such_motion(scene, by_newton ? Law::newton : Law::poisson)) return *declined;
    for (const Body& body : scene.bodies) {
      if (std::isinf(body.material.friction)) return Abstains{"infinite friction is not offered"};
    }
    World world(scene);
    return follow(scene, dt_, world);
  } catch (const Declined& why) {
    return Abstains{why.what()};
  }

 private:
  double dt_;
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_simbody_simulation() { return make_simbody_simulation(default_step); }

std::unique_ptr<Subject> make_simbody_simulation(double dt) { return std::make_unique<SimbodySimulation>(dt); }

}  // namespace touchstone::oracle::subjects
