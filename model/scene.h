// A Scene is the question: every input of every query is one. A pair is a scene of two bodies.
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

/// Coefficients of a body; how two bodies' coefficients combine is a clause, not a habit of an engine.
struct Material {
  double restitution = 0;  ///< e in [0, 1]
  double friction = 0;     ///< mu ≥ 0

  bool operator==(const Material&) const = default;
};

/// Uniform density (kg/m³), > 0: mass properties follow from the shape.
struct Density {
  double value = 1;

  bool operator==(const Density&) const = default;
};

/// Mass (kg, > 0), centre of mass in B (m), inertia about the centre of mass in B's axes (kg m²).
struct MassProperties {
  double mass = 0;
  Vec3 p_BBcm = Vec3::Zero();
  Mat3 I_BBcm_B = Mat3::Zero();

  bool operator==(const MassProperties& other) const {
    return mass == other.mass && p_BBcm == other.p_BBcm && I_BBcm_B == other.I_BBcm_B;
  }
};

/// A body whose velocity nothing changes: at rest, or a table that turns (w_WB is about B's origin, v_WBcm is that
/// origin's).
struct Fixed {
  bool operator==(const Fixed&) const = default;
};

using Mass = std::variant<Density, MassProperties, Fixed>;

struct Body {
  std::string name;
  Shape shape;
  Pose X_WB;
  Velocity velocity;
  Material material;
  Mass mass = Density{};

  bool operator==(const Body&) const = default;
};

/// What a frame does to one body: a pose puts it there from now on, none takes it away.
struct Placement {
  int body = 0;
  std::optional<Pose> X_WB;

  bool operator==(const Placement&) const = default;
};

/// Each body at most once; whom it does not name stays as it is.
using Frame = std::vector<Placement>;

/// How restitution is ruled. P_n: normal impulse, u_n: normal velocity of A's point against B's, W_n: work of P_n.
enum class Law {
  poisson,  ///< P_n of restitution = e · P_n of compression
  stronge,  ///< W_n of restitution = −e² · W_n of compression
  newton    ///< u_n after = −e · u_n before; with friction it can create energy
};

/// An impact at one point: bodies 0 (A) and 1 (B) meet at C.
struct Contact {
  Vec3 p_WC = Vec3::Zero();        ///< m
  Vec3 nhat_BA_W = Vec3(0, 0, 1);  ///< from B to A; of length 1 within rounding, read as n/|n| exactly
  Law law = Law::poisson;
  double restitution = 0;  ///< e in [0, 1]
  double friction = 0;     ///< mu ≥ 0; infinity: sticks

  bool operator==(const Contact& other) const {
    return p_WC == other.p_WC && nhat_BA_W == other.nhat_BA_W && law == other.law && restitution == other.restitution &&
           friction == other.friction;
  }
};

/// A picture's grid in W's xy-plane, looked at along −z without perspective: square (i, j), column i of row j, is
/// [x + i·pixel, x + (i+1)·pixel] × [y + j·pixel, y + (j+1)·pixel].
struct Raster {
  double x = 0, y = 0;  ///< m
  double pixel = 1;     ///< side of a square (m), > 0
  int columns = 1, rows = 1;
  int shift_x = 0, shift_y = 0;  ///< whole pixels by which B's picture is moved before it is laid over A's

  bool operator==(const Raster&) const = default;
};

/// From `time` on this force acts at the body's centre of mass, until its next push; before the first, none.
struct Push {
  double time = 0;  ///< s, ≥ 0
  int body = 0;
  Vec3 force_W = Vec3::Zero();  ///< N

  bool operator==(const Push&) const = default;
};

/// How long a scene is followed, and how it is looked at: docs/design/simulation.md says how bodies move.
struct Flight {
  std::vector<double> times;       ///< s, > 0, ascending: when the bodies are looked at; the last one ends the flight
  std::vector<double> since = {};  ///< s, by body: when it stands at X_WB with its velocity; empty: all at 0
  std::optional<double> envelope = {};  ///< m: bodies as near as this may count as in contact; touchstone::envelope
  Law law = Law::poisson;               ///< of the scene's impacts
  double force_bound = 0;               ///< N: no push is stronger
  std::vector<Push> pushes = {};        ///< ascending in time; what a subject knows of one before its time is the bound

  bool operator==(const Flight&) const = default;
};

struct Scene {
  std::string name;
  std::vector<Body> bodies;
  Vec3 gravity = Vec3::Zero();  ///< m/s², in W

  /// A film, for queries about sequences: before the first frame no body is there, and none stands at its own X_WB.
  /// Other queries do not see it.
  std::vector<Frame> frames = {};

  std::optional<Contact> contact = {};  ///< for queries about an impact
  std::optional<Raster> raster = {};    ///< for queries about pixels
  std::optional<Flight> flight = {};    ///< for queries about motion

  bool operator==(const Scene& other) const {
    return name == other.name && bodies == other.bodies && gravity == other.gravity && frames == other.frames &&
           contact == other.contact && raster == other.raster && flight == other.flight;
  }
};

}  // namespace touchstone
