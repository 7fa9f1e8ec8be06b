#include "app/adapter/mistakes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/input_error.h"
#include "oracle/query.h"
#include "oracle/rotation.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/reference.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

using Asked = std::function<void(Scene&)>;
using Said = std::function<void(AnyAnswer&, const Scene&)>;

constexpr double degree = std::numbers::pi / 180;

Mat3 rotation(const Body& body) { return oracle::rotation(body.X_WB.q_WB).toRotationMatrix(); }

/// The same change of each body, or of each shape, which may be a part of a compound.
Asked each_body(const std::function<void(Body&)>& change) {
  return [=](Scene& scene) { std::ranges::for_each(scene.bodies, change); };
}

void change_lengths(Shape& shape, double of_boxes, double of_spheres) {
  if (auto* box = std::get_if<Box>(&shape)) box->half_extents *= of_boxes;
  if (auto* sphere = std::get_if<Sphere>(&shape)) sphere->radius *= of_spheres;
  if (auto* compound = std::get_if<Compound>(&shape)) {
    for (Part& part : compound->parts) {
      if (auto* box = std::get_if<Box>(&part.shape)) box->half_extents *= of_boxes;
      if (auto* sphere = std::get_if<Sphere>(&part.shape)) sphere->radius *= of_spheres;
    }
  }
}

Asked lengths_times(double of_boxes, double of_spheres) {
  return each_body([=](Body& body) { change_lengths(body.shape, of_boxes, of_spheres); });
}

/// In poses of bodies and in those of a sequence.
Asked each_pose(const std::function<void(Pose&)>& change) {
  return [=](Scene& scene) {
    for (Body& body : scene.bodies) change(body.X_WB);
    for (SequenceFrame& frame : scene.frames) {
      for (Placement& placement : frame) {
        if (placement.X_WB) change(*placement.X_WB);
      }
    }
  };
}

Asked each_turn(const std::function<Quaternion(const Quaternion&)>& change) {
  return each_pose([=](Pose& pose) { pose.q_WB = change(pose.q_WB); });
}

/// The rotation about the same axis by another angle.
Asked angles_times(double factor) {
  return each_turn([=](const Quaternion& q) {
    const Eigen::AngleAxisd turn(oracle::rotation(q));
    return oracle::quaternion(Eigen::Quaterniond(Eigen::AngleAxisd(factor * turn.angle(), turn.axis())));
  });
}

Asked each_velocity(const std::function<void(Velocity&, const Body&)>& change) {
  return each_body([=](Body& body) { change(body.velocity, body); });
}

/// Makes of the answer, which is of type T, another one.
template <class T>
Said of(const std::function<void(T&, const Scene&)>& change) {
  return [=](AnyAnswer& answer, const Scene& scene) {
    if (T* said = std::get_if<T>(&answer)) change(*said, scene);
  };
}

Said each_mass(const std::function<void(MassProperties&, const Body&)>& change) {
  return of<Masses>([=](Masses& masses, const Scene& scene) {
    for (std::size_t i = 0; i < masses.size(); ++i) {
      if (masses[i]) change(*masses[i], scene.bodies[i]);
    }
  });
}

Said each_velocity_after(const std::function<void(Velocity&, const Body&)>& change) {
  return of<Impulse>([=](Impulse& answer, const Scene& scene) {
    for (std::size_t i = 0; i < 2; ++i) change(answer.after[i], scene.bodies[i]);
  });
}

Said each_state(const std::function<void(State&, const Body&)>& change) {
  return of<Trajectory>([=](Trajectory& answer, const Scene& scene) {
    for (auto& states : answer.states) {
      for (std::size_t i = 0; i < states.size(); ++i) change(states[i], scene.bodies[i]);
    }
  });
}

Said witnesses(const std::function<void(Vec3& a, Vec3& b, const Scene&)>& change) {
  return of<Distance>([=](Distance& answer, const Scene& scene) {
    if (answer.p_WCa && answer.p_WCb) change(*answer.p_WCa, *answer.p_WCb, scene);
  });
}

Said normal(const std::function<void(Vec3& n, const Scene&)>& change) {
  return of<Penetration>([=](Penetration& answer, const Scene& scene) {
    if (answer.nhat_BA_W) change(*answer.nhat_BA_W, scene);
  });
}

Vec3 in_frame_of(const Body& body, const Vec3& p_WQ) { return rotation(body).transpose() * (p_WQ - body.X_WB.p_WB); }

/// What all queries share: how shapes and poses are handed over.
std::vector<Mistake> of_shapes_and_poses() {
  return {
      {"half extents taken for extents: the engine's boxes have half the size", lengths_times(0.5, 1), {}},
      {"extents taken for half extents: the engine's boxes have twice the size", lengths_times(2, 1), {}},
      {"radius taken for diameter: the engine's balls have half the size", lengths_times(1, 0.5), {}},
      {"diameter taken for radius: the engine's balls have twice the size", lengths_times(1, 2), {}},
      {"quaternion order: the engine takes x, y, z, w and got w, x, y, z",
       each_turn([](const Quaternion& q) {
         return Quaternion{q.z, q.w, q.x, q.y};
       }),
       {}},
      {"quaternion order: the engine takes w, x, y, z and got x, y, z, w",
       each_turn([](const Quaternion& q) {
         return Quaternion{q.x, q.y, q.z, q.w};
       }),
       {}},
      {"pose transposed: the inverse rotation was handed over",
       each_turn([](const Quaternion& q) {
         return Quaternion{q.w, -q.x, -q.y, -q.z};
       }),
       {}},
      {"rotation not handed over", each_turn([](const Quaternion&) { return Quaternion{}; }), {}},
      {"degrees for radians: the engine takes degrees and got radians", angles_times(degree), {}},
      {"radians for degrees: the engine takes radians and got degrees", angles_times(1 / degree), {}},
      {"position not handed over", each_pose([](Pose& pose) { pose.p_WB = Vec3::Zero(); }), {}},
  };
}

/// What impacts and motions share.
std::vector<Mistake> of_dynamics() {
  return {
      {"fixed body moved: it was handed over as a body with mass",
       each_body([](Body& body) {
         if (std::holds_alternative<Fixed>(body.mass)) body.mass = Density{};
       }),
       {}},
      {"fixed body stands: its velocity was not handed over",
       each_body([](Body& body) {
         if (std::holds_alternative<Fixed>(body.mass)) body.velocity = {};
       }),
       {}},
      {"density taken for mass: bodies weigh as many kg as their density is",
       each_body([](Body& body) {
         Scene alone;
         alone.bodies = {body};
         const auto truth = oracle::subjects::make_reference()->mass(alone);
         const auto* density = std::get_if<Density>(&body.mass);
         if (!density || !std::holds_alternative<Masses>(truth)) return;
         MassProperties known = *std::get<Masses>(truth)[0];
         known.I_BBcm_B *= density->value / known.mass;
         known.mass = density->value;
         body.mass = known;
       }),
       {}},
      {"density ignored: each body has density 1",
       each_body([](Body& body) {
         if (std::holds_alternative<Density>(body.mass)) body.mass = Density{};
       }),
       {}},
      {"given mass properties ignored: each body has density 1",
       each_body([](Body& body) {
         if (std::holds_alternative<MassProperties>(body.mass)) body.mass = Density{};
       }),
       {}},
      {"centre of mass taken to be the body's origin",
       each_body([](Body& body) {
         if (auto* known = std::get_if<MassProperties>(&body.mass)) known->p_BBcm.setZero();
       }),
       {}},
      {"velocity of the centre of mass taken for that of the body's origin",
       each_velocity([](Velocity& velocity, const Body& body) {
         const auto* known = std::get_if<MassProperties>(&body.mass);
         if (known) velocity.v_WBcm += velocity.w_WB.cross(rotation(body) * known->p_BBcm);
       }),
       {}},
      {"radians for degrees: the engine takes radians a second and got degrees a second",
       each_velocity([](Velocity& velocity, const Body&) { velocity.w_WB /= degree; }),
       {}},
      {"degrees for radians: the engine takes degrees a second and got radians a second",
       each_velocity([](Velocity& velocity, const Body&) { velocity.w_WB *= degree; }),
       {}},
      {"angular velocity not handed over",
       each_velocity([](Velocity& velocity, const Body&) { velocity.w_WB.setZero(); }),
       {}},
      {"frame of the angular velocity: it is in the world's axes and was taken to be in the body's",
       each_velocity([](Velocity& velocity, const Body& body) { velocity.w_WB = rotation(body) * velocity.w_WB; }),
       {}},
      {"velocity not handed over",
       each_velocity([](Velocity& velocity, const Body&) { velocity.v_WBcm.setZero(); }),
       {}},
  };
}

using Rule = double (*)(double, double);

struct NamedRule {
  const char* name;
  Rule rule;
};

const std::vector<NamedRule>& rules() {
  static const std::vector<NamedRule> all = {
      {"max", [](double a, double b) { return std::max(a, b); }},
      {"product", [](double a, double b) { return a * b; }},
      {"average", [](double a, double b) { return (a + b) / 2; }},
      {"geometric mean", [](double a, double b) { return std::sqrt(a * b); }},
  };
  return all;
}

/// The coefficient that the pair gets by another rule than min, both for impacts at a contact and for motions.
void combine(Scene& scene, Rule rule, double Material::*coefficient) {
  Material &a = scene.bodies[0].material, &b = scene.bodies[1].material;
  const double combined = rule(a.*coefficient, b.*coefficient);
  a.*coefficient = b.*coefficient = combined;
  if (!scene.contact) return;
  (coefficient == &Material::restitution ? scene.contact->restitution : scene.contact->friction) = combined;
}

std::vector<Mistake> of_coefficients() {
  std::vector<Mistake> all;
  for (const auto& [name, rule] : rules()) {
    all.push_back({std::string("e combined by ") + name,
                   [rule = rule](Scene& scene) { combine(scene, rule, &Material::restitution); },
                   {}});
  }
  for (const auto& [name, rule] : rules()) {
    all.push_back({std::string("μ combined by ") + name,
                   [rule = rule](Scene& scene) { combine(scene, rule, &Material::friction); },
                   {}});
  }
  const auto zero = [](double, double) { return 0.0; };
  all.push_back({"e not handed over", [zero](Scene& scene) { combine(scene, zero, &Material::restitution); }, {}});
  all.push_back({"μ not handed over", [zero](Scene& scene) { combine(scene, zero, &Material::friction); }, {}});
  const auto square = [](double a, double b) { return std::min(a, b) * std::min(a, b); };
  all.push_back({"e combined by product: both bodies got the contact's e",
                 [square](Scene& scene) { combine(scene, square, &Material::restitution); },
                 {}});
  all.push_back({"μ combined by product: both bodies got the contact's μ",
                 [square](Scene& scene) { combine(scene, square, &Material::friction); },
                 {}});
  return all;
}

std::vector<Mistake> of_mass() {
  return {
      {"density taken for mass: bodies weigh as many kg as their density is",
       {},
       each_mass([](MassProperties& m, const Body& body) {
         const auto* density = std::get_if<Density>(&body.mass);
         if (!density) return;
         m.I_BBcm_B *= density->value / m.mass;
         m.mass = density->value;
       })},
      {"density ignored: each body has density 1", {}, each_mass([](MassProperties& m, const Body& body) {
         const auto* density = std::get_if<Density>(&body.mass);
         if (!density) return;
         m.mass /= density->value;
         m.I_BBcm_B /= density->value;
       })},
      {"given mass properties ignored: each body has density 1",
       each_body([](Body& body) {
         if (std::holds_alternative<MassProperties>(body.mass)) body.mass = Density{};
       }),
       {}},
      {"inertia about the origin instead of the centre of mass", {}, each_mass([](MassProperties& m, const Body&) {
         const Vec3 c = m.p_BBcm;
         m.I_BBcm_B += m.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
       })},
      {"inertia in the world's axes instead of the body's", {}, each_mass([](MassProperties& m, const Body& body) {
         m.I_BBcm_B = rotation(body) * m.I_BBcm_B * rotation(body).transpose();
       })},
      {"centre of mass in the world's frame instead of the body's",
       {},
       each_mass([](MassProperties& m, const Body& body) { m.p_BBcm = rotation(body) * m.p_BBcm + body.X_WB.p_WB; })},
      {"centre of mass taken to be the body's origin", {}, each_mass([](MassProperties& m, const Body&) {
         m.p_BBcm.setZero();
       })},
      {"sign of the products of inertia: Ixy = −∫ x y dm", {}, each_mass([](MassProperties& m, const Body&) {
         m.I_BBcm_B = 2 * Mat3(m.I_BBcm_B.diagonal().asDiagonal()) - m.I_BBcm_B;
       })},
      {"products of inertia left out", {}, each_mass([](MassProperties& m, const Body&) {
         m.I_BBcm_B = Mat3(m.I_BBcm_B.diagonal().asDiagonal());
       })},
      {"principal moments instead of the inertia in the body's axes", {}, each_mass([](MassProperties& m, const Body&) {
         m.I_BBcm_B = Mat3(Eigen::SelfAdjointEigenSolver<Mat3>(m.I_BBcm_B).eigenvalues().asDiagonal());
       })},
      {"∫ x² dm and so on (the covariance) instead of the inertia", {}, each_mass([](MassProperties& m, const Body&) {
         m.I_BBcm_B = m.I_BBcm_B.trace() / 2 * Mat3::Identity() - m.I_BBcm_B;
       })},
      {"inertia of a unit mass", {}, each_mass([](MassProperties& m, const Body&) { m.I_BBcm_B /= m.mass; })},
      {"inverses of mass and inertia", {}, each_mass([](MassProperties& m, const Body&) {
         m.mass = 1 / m.mass;
         m.I_BBcm_B = m.I_BBcm_B.inverse().eval();
       })},
      {"fixed body moved: it got a mass instead of null",
       each_body([](Body& body) {
         if (std::holds_alternative<Fixed>(body.mass)) body.mass = Density{};
       }),
       {}},
  };
}

std::vector<Mistake> of_bounds() {
  return {
      {"centre and half size instead of lo and hi", {}, of<Bounds>([](Bounds& boxes, const Scene&) {
         for (Aabb& box : boxes) box = {(box.lo + box.hi) / 2, (box.hi - box.lo) / 2};
       })},
      {"lo and hi exchanged", {}, of<Bounds>([](Bounds& boxes, const Scene&) {
         for (Aabb& box : boxes) std::swap(box.lo, box.hi);
       })},
      {"frame of the body: the box is that of the shape in its own frame",
       each_pose([](Pose& pose) { pose = {}; }),
       {}},
  };
}

std::vector<Mistake> of_pairs() {
  const auto change = [](const std::function<void(PairSet&)>& each) -> Said {
    return [=](AnyAnswer& answer, const Scene&) {
      if (auto* pairs = std::get_if<PairSet>(&answer)) each(*pairs);
      if (auto* history = std::get_if<PairHistory>(&answer)) {
        for (PairFrame& frame : *history) each(frame.pairs);
      }
    };
  };
  return {
      {"bodies counted from 1 instead of 0", {}, change([](PairSet& pairs) {
         for (auto& [i, j] : pairs) ++i, ++j;
       })},
      {"each pair as j, i instead of i, j with i < j", {}, change([](PairSet& pairs) {
         for (auto& [i, j] : pairs) std::swap(i, j);
       })},
      {"a removed body was not removed",
       [](Scene& scene) {
         for (SequenceFrame& frame : scene.frames) {
           std::erase_if(frame, [](const Placement& placement) { return !placement.X_WB; });
         }
       },
       {}},
      {"bodies before their first frame: they are not present yet",
       [](Scene& scene) {
         if (scene.frames.empty()) return;
         std::vector<bool> placed(scene.bodies.size());
         for (const Placement& placement : scene.frames[0]) placed[static_cast<std::size_t>(placement.body)] = true;
         for (std::size_t i = 0; i < placed.size(); ++i) {
           if (!placed[i]) scene.frames[0].push_back({static_cast<int>(i), scene.bodies[i].X_WB});
         }
       },
       {}},
  };
}

std::vector<Mistake> of_distance() {
  return {
      {"frame of A and B: each witness point is in its body's frame",
       {},
       witnesses([](Vec3& a, Vec3& b, const Scene& s) {
         a = in_frame_of(s.bodies[0], a);
         b = in_frame_of(s.bodies[1], b);
       })},
      {"frame of A: the witness points are in A's frame", {}, witnesses([](Vec3& a, Vec3& b, const Scene& s) {
         a = in_frame_of(s.bodies[0], a);
         b = in_frame_of(s.bodies[0], b);
       })},
      {"frame of B: the witness points are in B's frame", {}, witnesses([](Vec3& a, Vec3& b, const Scene& s) {
         a = in_frame_of(s.bodies[1], a);
         b = in_frame_of(s.bodies[1], b);
       })},
      {"frame of A: the witness point on A is in A's frame", {}, witnesses([](Vec3& a, Vec3&, const Scene& s) {
         a = in_frame_of(s.bodies[0], a);
       })},
      {"frame of B: the witness point on B is in B's frame", {}, witnesses([](Vec3&, Vec3& b, const Scene& s) {
         b = in_frame_of(s.bodies[1], b);
       })},
      {"witness points exchanged: p_WCa is on A", {}, witnesses([](Vec3& a, Vec3& b, const Scene&) { a.swap(b); })},
      {"witness points relative to the bodies' origins, in the world's axes",
       {},
       witnesses([](Vec3& a, Vec3& b, const Scene& s) {
         a -= s.bodies[0].X_WB.p_WB;
         b -= s.bodies[1].X_WB.p_WB;
       })},
      {"depth sign: the distance of bodies that are apart is positive", {}, of<Distance>([](Distance& d, const Scene&) {
         d.distance = -*d.distance;
       })},
      {"squared distance", {}, of<Distance>([](Distance& d, const Scene&) { d.distance = *d.distance * *d.distance; })},
      {"verdict reversed", {}, of<Distance>([](Distance& d, const Scene&) {
         d.verdict = *d.verdict == Verdict::separated ? Verdict::overlapping : Verdict::separated;
       })},
      {"distance of the centres", {}, of<Distance>([](Distance& d, const Scene& s) {
         d.distance = (s.bodies[0].X_WB.p_WB - s.bodies[1].X_WB.p_WB).norm();
       })},
  };
}

std::vector<Mistake> of_penetration() {
  return {
      {"normal reversed: nhat_BA_W is the direction along which A moves out of B",
       {},
       normal([](Vec3& n, const Scene&) { n = -n; })},
      {"depth sign: the depth of bodies that overlap is positive",
       {},
       of<Penetration>([](Penetration& p, const Scene&) { p.depth = -*p.depth; })},
      {"depth sign and normal reversed", {}, of<Penetration>([](Penetration& p, const Scene&) {
         p.depth = -*p.depth;
         if (p.nhat_BA_W) p.nhat_BA_W = -*p.nhat_BA_W;
       })},
      {"frame of A: the normal is in A's axes", {}, normal([](Vec3& n, const Scene& s) {
         n = rotation(s.bodies[0]).transpose() * n;
       })},
      {"frame of B: the normal is in B's axes", {}, normal([](Vec3& n, const Scene& s) {
         n = rotation(s.bodies[1]).transpose() * n;
       })},
      {"normal times depth: nhat_BA_W has length 1", {}, of<Penetration>([](Penetration& p, const Scene&) {
         if (p.nhat_BA_W) *p.nhat_BA_W *= *p.depth;
       })},
      {"half of the depth: A alone moves by the whole depth", {}, of<Penetration>([](Penetration& p, const Scene&) {
         p.depth = *p.depth / 2;
       })},
      {"verdict reversed", {}, of<Penetration>([](Penetration& p, const Scene&) {
         p.verdict = *p.verdict == Verdict::separated ? Verdict::overlapping : Verdict::separated;
       })},
  };
}

std::vector<Mistake> of_impulse() {
  return {
      {"normal reversed: nhat_BA_W points from B to A",
       [](Scene& s) { s.contact->nhat_BA_W = -s.contact->nhat_BA_W; },
       {}},
      {"no impulse: the velocities are those before",
       {},
       [](AnyAnswer& answer, const Scene& s) {
         answer = Impulse{{s.bodies[0].velocity, s.bodies[1].velocity}, {}, {}, {}};
       }},
      {"A and B exchanged in `after`", {}, of<Impulse>([](Impulse& i, const Scene&) {
         std::swap(i.after[0], i.after[1]);
       })},
      {"sign of P_A_W: it is the impulse on A", {}, of<Impulse>([](Impulse& i, const Scene&) {
         if (i.P_A_W) i.P_A_W = -*i.P_A_W;
       })},
      {"changes of the velocities instead of the velocities after",
       {},
       each_velocity_after([](Velocity& v, const Body& body) {
         v.v_WBcm -= body.velocity.v_WBcm;
         v.w_WB -= body.velocity.w_WB;
       })},
      {"radians for degrees: the angular velocities after are in degrees a second",
       {},
       each_velocity_after([](Velocity& v, const Body&) { v.w_WB /= degree; })},
      {"frame of the angular velocity: those after are in the bodies' axes",
       {},
       each_velocity_after([](Velocity& v, const Body& body) { v.w_WB = rotation(body).transpose() * v.w_WB; })},
      {"velocity of the body's origin instead of that of the centre of mass",
       {},
       each_velocity_after([](Velocity& v, const Body& body) {
         const auto* known = std::get_if<MassProperties>(&body.mass);
         if (known) v.v_WBcm -= v.w_WB.cross(rotation(body) * known->p_BBcm);
       })},
      {"C in the frame of A: the contact point is in the world's frame",
       [](Scene& s) { s.contact->p_WC = in_frame_of(s.bodies[0], s.contact->p_WC); },
       {}},
      {"lever arm forgotten: the impulse acts at the centres of mass",
       [](Scene& s) {
         for (Body& body : s.bodies) {
           if (auto* known = std::get_if<MassProperties>(&body.mass)) known->I_BBcm_B *= 1e9;
         }
       },
       {}},
  };
}

std::vector<Mistake> of_pixel() {
  const auto each_mask = [](const std::function<void(Mask&)>& change) {
    return of<Pixels>([=](Pixels& p, const Scene&) {
      for (std::vector<Mask>* masks : {&p.sampled, &p.conservative}) std::ranges::for_each(*masks, change);
      change(p.meet_sampled);
      change(p.meet_conservative);
    });
  };
  const auto origin_by = [](double pixels) {
    return [=](Scene& s) {
      s.raster->x += pixels * s.raster->pixel;
      s.raster->y += pixels * s.raster->pixel;
    };
  };
  return {
      {"rows upside down: the lowest row comes first", {}, each_mask([](Mask& mask) { std::ranges::reverse(mask); })},
      {"columns from right to left", {}, each_mask([](Mask& mask) {
         for (std::string& row : mask) std::ranges::reverse(row);
       })},
      {"corners of pixels instead of their centres", origin_by(-0.5), {}},
      {"sign of the shift: B's image is moved",
       [](Scene& s) {
         s.raster->shift_x = -s.raster->shift_x;
         s.raster->shift_y = -s.raster->shift_y;
       },
       {}},
      {"shift not handed over", [](Scene& s) { s.raster->shift_x = s.raster->shift_y = 0; }, {}},
      {"origin of the raster not handed over", [](Scene& s) { s.raster->x = s.raster->y = 0; }, {}},
      {"size of a pixel not handed over", [](Scene& s) { s.raster->pixel = 1; }, {}},
      {"masks inverted: 1 is a pixel in the set", {}, each_mask([](Mask& mask) {
         for (std::string& row : mask) {
           for (char& c : row) c = c == '1' ? '0' : '1';
         }
       })},
  };
}

std::vector<Mistake> of_motion() {
  const auto gravity_times = [](double factor) { return [=](Scene& s) { s.gravity *= factor; }; };
  return {
      {"gravity not handed over", gravity_times(0), {}},
      {"sign of gravity", gravity_times(-1), {}},
      {"gravity along −z whatever the scene says",
       [](Scene& s) {
         s.gravity = {0, 0, -s.gravity.norm()};
       },
       {}},
      {"gravity of 9.81 m/s² along −z whatever the scene says",
       [](Scene& s) {
         s.gravity = {0, 0, -9.81};
       },
       {}},
      {"applied forces not handed over", [](Scene& s) { s.motion->forces.clear(); }, {}},
      {"force taken for acceleration",
       [](Scene& s) {
         for (AppliedForce& force : s.motion->forces) {
           const auto& body = s.bodies[static_cast<std::size_t>(force.body)];
           if (const auto* known = std::get_if<MassProperties>(&body.mass)) force.force_W *= known->mass;
         }
       },
       {}},
  };
}

std::vector<Mistake> of_time() {
  return {
      {"fraction of the motion instead of seconds", {}, of<TimeOfImpact>([](TimeOfImpact& t, const Scene& s) {
         if (t.time) t.time = *t.time / s.motion->sample_times.back();
       })},
      {"milliseconds instead of seconds", {}, of<TimeOfImpact>([](TimeOfImpact& t, const Scene&) {
         if (t.time) t.time = 1000 * *t.time;
       })},
      {"the end of the motion ignored", [](Scene& s) { s.motion->sample_times = {1000}; }, {}},
  };
}

std::vector<Mistake> of_states() {
  return {
      {"place of the centre of mass instead of the body's origin", {}, each_state([](State& state, const Body& body) {
         const auto* known = std::get_if<MassProperties>(&body.mass);
         if (known) state.X_WB.p_WB += oracle::rotation(state.X_WB.q_WB) * known->p_BBcm;
       })},
      {"velocity of the body's origin instead of that of the centre of mass",
       {},
       each_state([](State& state, const Body& body) {
         const auto* known = std::get_if<MassProperties>(&body.mass);
         if (!known) return;
         state.velocity.v_WBcm -= state.velocity.w_WB.cross(oracle::rotation(state.X_WB.q_WB) * known->p_BBcm);
       })},
      {"quaternion order of the states: x, y, z, w was given as w, x, y, z",
       {},
       each_state([](State& state, const Body&) {
         const Quaternion q = oracle::quaternion(oracle::rotation(state.X_WB.q_WB));
         state.X_WB.q_WB = {q.x, q.y, q.z, q.w};
       })},
      {"pose transposed: the inverse rotation was given in the states", {}, each_state([](State& state, const Body&) {
         const Quaternion q = state.X_WB.q_WB;
         state.X_WB.q_WB = {q.w, -q.x, -q.y, -q.z};
       })},
      {"radians for degrees: the angular velocities of the states are in degrees a second",
       {},
       each_state([](State& state, const Body&) { state.velocity.w_WB /= degree; })},
      {"frame of the angular velocity: those of the states are in the bodies' axes",
       {},
       each_state([](State& state, const Body&) {
         state.velocity.w_WB = oracle::rotation(state.X_WB.q_WB).conjugate() * state.velocity.w_WB;
       })},
      {"order of the bodies", {}, of<Trajectory>([](Trajectory& t, const Scene&) {
         for (auto& states : t.states) std::ranges::reverse(states);
       })},
  };
}

/// No value if the subject abstains.
std::optional<AnyAnswer> asked(oracle::Subject& subject, const std::string& query, const Scene& scene) {
  return std::visit(
      [&](auto ask) -> std::optional<AnyAnswer> {
        const auto said = (subject.*ask)(scene);
        if (const auto* known = std::get_if<0>(&said)) return *known;
        return std::nullopt;
      },
      oracle::find_query(query)->ask);
}

void append(std::vector<Mistake>& all, std::vector<Mistake> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<Mistake> mistakes(const std::string& query) {
  std::vector<Mistake> all;
  if (query == "mass") append(all, of_mass());
  if (query == "bounds") append(all, of_bounds());
  if (query == "broad_phase" || query == "pair_history") append(all, of_pairs());
  if (query == "distance") append(all, of_distance());
  if (query == "penetration") append(all, of_penetration());
  if (query == "impulse") append(all, of_impulse());
  if (query == "pixel") append(all, of_pixel());
  if (query == "time_of_impact") append(all, of_time());
  const bool is_motion = query == "simulation" || query == "constraint";
  if (query == "impulse" || is_motion) append(all, of_coefficients());
  if (query == "impulse" || query == "time_of_impact" || is_motion) append(all, of_dynamics());
  if (query == "time_of_impact" || is_motion) append(all, of_motion());
  if (is_motion) append(all, of_states());
  append(all, of_shapes_and_poses());
  return all;
}

std::optional<AnyAnswer> predicted(const Mistake& mistake, const std::string& query, const PaperScene& paper) {
  Scene scene = paper.scene;
  if (mistake.asked) mistake.asked(scene);
  std::optional<AnyAnswer> answer = paper.expected;
  if (scene != paper.scene) {
    try {
      scene = reference::completed(std::move(scene));
      answer = asked(*oracle::subjects::make_fast(), query, scene);
      if (!answer) answer = asked(*oracle::subjects::make_reference(), query, scene);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }
  if (auto* distance = answer && mistake.asked ? std::get_if<Distance>(&*answer) : nullptr) {
    distance->p_WCa = distance->p_WCb = std::nullopt;  // the changed scene may have many closest points
  }
  if (answer && mistake.said) mistake.said(*answer, paper.scene);
  return answer;
}

}  // namespace touchstone::app
