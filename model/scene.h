// A Scene is the input of every query. A pair is a scene of two bodies.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/frame.h"
#include "model/shape.h"

namespace touchstone {

/// v_WBcm: velocity of the centre of mass (m/s); w_WB: angular velocity (rad/s); both measured and expressed in W.
struct Velocity {
  Vec3 v_WBcm = Vec3::Zero();
  Vec3 w_WB = Vec3::Zero();

  bool operator==(const Velocity& other) const { return v_WBcm == other.v_WBcm && w_WB == other.w_WB; }
};

/// Coefficients of a body. How the coefficients of two bodies combine is a clause of the specification, not a choice of
/// the engine.
struct Material {
  double restitution = 0;  ///< e in [0, 1]
  double friction = 0;     ///< mu ≥ 0

  bool operator==(const Material&) const = default;
};

/// Uniform density (kg/m³), > 0. The mass properties follow from the shape.
struct Density {
  double value = 1;

  bool operator==(const Density&) const = default;
};

/// Mass (kg, > 0), centre of mass in B (m), inertia about the centre of mass in the axes of B (kg m²).
struct MassProperties {
  double mass = 0;
  Vec3 p_BBcm = Vec3::Zero();
  Mat3 I_BBcm_B = Mat3::Zero();

  bool operator==(const MassProperties& other) const {
    return mass == other.mass && p_BBcm == other.p_BBcm && I_BBcm_B == other.I_BBcm_B;
  }
};

/// A body whose velocity nothing changes: it is at rest, or moves at a constant rate like a turntable (then w_WB is
/// about the origin of B, and v_WBcm is the velocity of that origin).
struct Fixed {
  bool operator==(const Fixed&) const = default;
};

using Mass = std::variant<Density, MassProperties, Fixed>;

/// A solid with its pose, velocity, material and mass. Bodies are known by their index in Scene::bodies; the name is
/// for messages.
struct Body {
  std::string name;
  Shape shape;
  Pose X_WB;
  Velocity velocity;
  Material material;
  Mass mass = Density{};

  bool operator==(const Body&) const = default;
};

/// Whether nothing changes its velocity.
inline bool is_fixed(const Body& body) { return std::holds_alternative<Fixed>(body.mass); }

/// The change that a frame makes to one body: it gets this pose until its next placement; without a pose it is removed.
struct Placement {
  int body = 0;
  std::optional<Pose> X_WB;

  bool operator==(const Placement&) const = default;
};

/// Names each body at most once; a body that is not named stays as it is.
using SequenceFrame = std::vector<Placement>;

/// The law of restitution. P_n: normal impulse, u_n: normal velocity of A's point relative to B's, W_n: work of P_n.
enum class Law {
  poisson,  ///< P_n of restitution = e · P_n of compression
  stronge,  ///< W_n of restitution = −e² · W_n of compression
  newton    ///< u_n after = −e · u_n before; with friction it can create energy
};

/// An impact at one point C, where bodies 0 (A) and 1 (B) are in contact.
struct Contact {
  Vec3 p_WC = Vec3::Zero();        ///< m
  Vec3 nhat_BA_W = Vec3(0, 0, 1);  ///< from B to A; of length 1 within rounding, taken as n/|n| exactly
  Law law = Law::poisson;
  double restitution = 0;  ///< e in [0, 1]
  double friction = 0;     ///< mu ≥ 0; infinity: no slip

  bool operator==(const Contact& other) const {
    return p_WC == other.p_WC && nhat_BA_W == other.nhat_BA_W && law == other.law && restitution == other.restitution &&
           friction == other.friction;
  }
};

/// The grid of an image in W's xy-plane. The bodies are projected along −z without perspective. Square (i, j), column i
/// of row j, is [x + i·pixel, x + (i+1)·pixel] × [y + j·pixel, y + (j+1)·pixel].
struct Raster {
  double x = 0, y = 0;  ///< m
  double pixel = 1;     ///< side of a square (m), > 0
  int columns = 1, rows = 1;
  int shift_x = 0, shift_y = 0;  ///< whole pixels by which B's image is moved before it is compared with A's

  bool operator==(const Raster&) const = default;
};

/// This force acts at the body's centre of mass from `time` until the body's next force; before the first one, no force
/// acts.
struct AppliedForce {
  double time = 0;  ///< s, ≥ 0
  int body = 0;
  Vec3 force_W = Vec3::Zero();  ///< N

  bool operator==(const AppliedForce&) const = default;
};

/// How long a scene moves, and when its states are sampled; docs/design/simulation.md defines how bodies move.
struct Motion {
  std::vector<double> sample_times;       ///< s, > 0, ascending: when states are sampled; the last is the end
  std::vector<double> start_times = {};   ///< s, by body: when it is at X_WB with its velocity; empty: 0 for all
  std::optional<double> envelope = {};    ///< m: bodies this close may be in contact; default: touchstone::envelope
  Law law = Law::poisson;                 ///< of the scene's impacts
  double force_bound = 0;                 ///< N: no applied force is stronger
  std::vector<AppliedForce> forces = {};  ///< ascending; in advance, a subject knows only the bound

  bool operator==(const Motion&) const = default;
};

/// The bodies of a query, and what else it asks about. Which scenes are valid: model/limits.h for the conditions that
/// floating point decides, reference/validity.h for the others.
struct Scene {
  std::string name;
  std::vector<Body> bodies;
  Vec3 gravity = Vec3::Zero();  ///< m/s², in W

  /// A sequence of poses, for queries about sequences. Before the first frame no body is present, and X_WB of a body is
  /// not used. Other queries ignore it.
  std::vector<SequenceFrame> frames = {};

  std::optional<Contact> contact = {};  ///< for queries about an impact
  std::optional<Raster> raster = {};    ///< for queries about pixels
  std::optional<Motion> motion = {};    ///< for queries about motion

  bool operator==(const Scene& other) const {
    return name == other.name && bodies == other.bodies && gravity == other.gravity && frames == other.frames &&
           contact == other.contact && raster == other.raster && motion == other.motion;
  }
};

}  // namespace touchstone
