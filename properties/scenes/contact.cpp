// Impacts: two bodies in contact at a point, with any velocities there. Most numbers are small integers, so that K and
// u are exact.
//
// A family draws the velocity u of A's contact point relative to B's, and the bodies' arms, orientations and spins; the
// velocity of A's centre follows. The normal is along z until the whole scene is rotated.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/infinity.h"
#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

/// A body and the position r of C relative to its centre of mass.
struct Arm {
  Body body;
  Vec3 r = Vec3::Zero();
};

double some_restitution(Random& random) { return random.pick({0.0, 0.0, 1.0, 1.0, 0.5, 0.25, 0.75, 0.875}); }

double some_friction(Random& random) { return random.pick({0.0, 0.125, 0.25, 0.5, 0.75, 1.0, 2.0, 10.0, infinity}); }

Contact some_contact(Random& random) {
  Contact contact;
  contact.law = random.pick({Law::poisson, Law::poisson, Law::stronge, Law::newton});
  contact.restitution = some_restitution(random);
  contact.friction = some_friction(random);
  contact.p_WC = small_vector(random, 4);
  return contact;
}

/// Approaching at 1 to 8, with any slip.
Vec3 some_approach(Random& random) { return {random.whole(-8, 8), random.whole(-8, 8), -random.whole(1, 8)}; }

/// The scene under a random rotation that maps axes to axes, with either body first.
Scene seen_somehow(Random& random, Scene scene) {
  for (int turns = random.below(3); turns > 0; --turns) scene = turned(scene).value_or(scene);
  if (random.one_in(2)) scene = half_turned(std::move(scene));
  return random.one_in(2) ? swapped(std::move(scene)) : scene;
}

/// Puts A and B in contact at C. Keeps B's velocity and both spins, and sets A's velocity such that its contact point
/// moves by u relative to B's.
Scene meeting(Random& random, Arm A, Arm B, const Vec3& u, const Contact& contact) {
  const auto place = [&](Arm& arm) {
    const auto* given = std::get_if<MassProperties>(&arm.body.mass);
    arm.body.X_WB.p_WB = contact.p_WC - arm.r;
    // Bodies whose centre of mass is off their origin are turned by axes_quaternion alone.
    if (given != nullptr) arm.body.X_WB.p_WB -= turned_by_axes(arm.body.X_WB.q_WB, given->p_BBcm);
  };
  place(A);
  place(B);
  const Vec3 at_B = B.body.velocity.v_WBcm + B.body.velocity.w_WB.cross(B.r);
  A.body.velocity.v_WBcm = u + at_B - A.body.velocity.w_WB.cross(A.r);
  Scene scene;
  scene.contact = contact;
  scene.bodies = {std::move(A.body), std::move(B.body)};
  return seen_somehow(random, std::move(scene));
}

Arm fixed_ground() {
  Body body = at_rest(Box{Vec3(16, 16, 1)});
  body.mass = Fixed{};
  return {body, {0, 0, 1}};
}

Body with_spin(Random& random, Body body) {
  body.velocity.w_WB = small_vector(random, 3);
  return body;
}

/// A fixed body at rest, or one that moves and turns.
Arm some_ground(Random& random) {
  Arm ground = fixed_ground();
  if (random.one_in(2)) return ground;
  ground.body = with_spin(random, std::move(ground.body));
  ground.body.velocity.v_WBcm = small_vector(random, 4);
  const double x = random.whole(-8, 8), y = random.whole(-8, 8);
  ground.r = {x, y, 1};
  return ground;
}

Arm ball(Random& random, double towards) {
  const double radius = random.whole(1, 4);
  Body body = with_spin(random, at_rest(Sphere{radius}));
  body.mass = Density{dyadic(random, 1, 4, -2, 2)};
  return {body, {0, 0, towards * radius}};
}

/// A uniform box with a density, C at a corner or inside: cond(K) ≤ 7.
Arm box(Random& random, double towards) {
  const Vec3 half{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  Body body = with_spin(random, at_rest(Box{half}));
  body.mass = Density{dyadic(random, 1, 4, -3, 0)};
  Vec3 r = half;
  for (double& x : r) x *= random.pick({-1.0, 1.0, 0.5, 0.0});
  r.z() = towards * half.z();
  if (random.one_in(3)) {  // rotated; C stays inside, within the least half extent
    body.X_WB.q_WB = small_quaternion(random);
    r = 0.5 * half.minCoeff() * Vec3{random.whole(-1, 1), random.whole(-1, 1), towards};
  }
  return {body, r};
}

/// Given mass and moments that satisfy the triangle inequality.
Body stated(Random& random, double mass, const Vec3& moments) {
  MassProperties given;
  given.mass = mass;
  given.I_BBcm_B = moments.asDiagonal();
  Body body = with_spin(random, at_rest(Box{Vec3::Ones()}));
  body.mass = given;
  return body;
}

Arm some_stated(Random& random, double towards) {
  const double mass = dyadic(random, 1, 4, -1, 1);
  const double x = random.whole(2, 8), y = random.whole(2, 8), more = random.whole(0, 1);
  const Vec3 moments{x, y, std::max(x, y) + more};
  Body body = stated(random, mass, moments);
  Vec3 r = small_vector(random, 4);
  r.z() = towards * random.whole(1, 4);
  if (random.one_in(3)) body.X_WB.q_WB = small_quaternion(random);
  return {body, r};
}

Arm some_other(Random& random) {
  if (random.one_in(2)) return some_ground(random);
  Arm other = some_stated(random, 1);
  other.body.velocity.v_WBcm = small_vector(random, 4);
  return other;
}

Scene spheres(Random& random) {
  Arm A = ball(random, -1), B = ball(random, 1);
  if (random.one_in(2)) B = some_ground(random);
  const Vec3 u = some_approach(random);
  return meeting(random, A, B, u, some_contact(random));
}

Scene boxes(Random& random) {
  Arm A = box(random, -1), B = box(random, 1);
  B.body.velocity.v_WBcm = small_vector(random, 4);
  if (random.one_in(2)) B = some_ground(random);
  const Vec3 u = some_approach(random);
  return meeting(random, A, B, u, some_contact(random));
}

/// C near the end of a slender rod that is inclined by a rational angle about y: K couples normal and slip strongly.
Arm rod_end(Random& random) {
  const double w = random.whole(1, 4), y = random.whole(1, 4), length = w * w + y * y;
  const double across = std::ldexp(length * length, -random.between(2, 20));
  Body body = stated(random, 1, {across, length * length / 4, length * length / 4});
  body.X_WB.q_WB = {w, 0, y, 0};  // its x axis, `length` long, ends at (w² − y², 0, −2wy)
  return {body, {w * w - y * y, 0, -2 * w * y}};
}

/// C at the end of a needle that stands on the normal, or leans by 2^-4 to 2^-16, or beside its end by as much.
Arm needle_end(Random& random) {
  const double half = random.whole(1, 8), tiny = std::ldexp(1.0, -random.between(4, 16));
  const double across = half * half * std::ldexp(1.0, -random.between(8, 40));
  Body body = stated(random, 1, {half * half, half * half, across});
  Vec3 r{0, 0, -half};
  const int how = random.below(3);
  if (how == 1) body.X_WB.q_WB = {1, tiny, 0, 0};
  if (how == 2) r.x() = tiny;
  return {body, r};
}

Scene rods(Random& random) {
  const Arm A = random.one_in(3) ? needle_end(random) : rod_end(random);
  Contact contact = some_contact(random);
  contact.friction = dyadic(random, 1, 12, -2, -2);
  const Vec3 u = some_approach(random);
  return meeting(random, A, fixed_ground(), u, contact);
}

/// Everything in the xz plane, where the slip direction cannot change.
Scene planar(Random& random) {
  const auto flat = [&random](double towards) {
    Arm arm = some_stated(random, towards);
    arm.r.y() = 0;
    arm.body.X_WB.q_WB = {};
    arm.body.velocity = {{random.whole(-4, 4), 0, random.whole(-4, 4)}, {0, random.whole(-3, 3), 0}};
    return arm;
  };
  Arm A = flat(-1), B = flat(1);
  if (random.one_in(2)) B = fixed_ground();
  Vec3 u = some_approach(random);
  u.y() = 0;
  return meeting(random, A, B, u, some_contact(random));
}

Scene zero_slip(Random& random) {
  const Arm A = some_stated(random, -1), B = some_other(random);
  const Vec3 u{0, 0, -random.whole(1, 8)};
  return meeting(random, A, B, u, some_contact(random));
}

/// u_t of the order of 2^-8 to 2^-40, with an approach of 1 to 8.
Scene tiny_slip(Random& random) {
  const Arm A = some_stated(random, -1), B = some_other(random);
  Vec3 u = some_approach(random);
  const double tiny = std::ldexp(1.0, -random.between(8, 40));
  u.x() *= tiny;
  u.y() *= tiny;
  return meeting(random, A, B, u, some_contact(random));
}

/// Friction within an ulp of the least value that keeps a contact without slip from slipping.
Scene on_the_cone(Random& random) {
  Arm A = some_stated(random, -1);
  const Vec3 moments = std::get<MassProperties>(A.body.mass).I_BBcm_B.diagonal();
  const double mass = std::get<MassProperties>(A.body.mass).mass;
  A.r.y() = 0;
  A.body.X_WB.q_WB = {};
  Contact contact = some_contact(random);
  const double k = std::abs(A.r.x() * A.r.z()) / moments.y(), M = 1 / mass + A.r.z() * A.r.z() / moments.y();
  const double just = k / M;
  contact.friction = random.pick({just, std::nextafter(just, 0), std::nextafter(just, 1)});
  const Vec3 u{0, 0, -random.whole(1, 8)};
  return meeting(random, A, fixed_ground(), u, contact);
}

/// Only spin moves the bodies together: v = 0.
Scene spin_only(Random& random) {
  Arm A = some_stated(random, -1);
  A.r.x() = random.whole(1, 4);
  A.body.velocity.w_WB = {random.whole(-3, 3), random.whole(1, 4), random.whole(-3, 3)};
  A.r.y() = 0;
  const Vec3 u = A.body.velocity.w_WB.cross(A.r);  // downward at −w_y r_x, as r_y = 0
  return meeting(random, A, fixed_ground(), u, some_contact(random));
}

/// Parting or approaching by what rounding of v + w × r hides: at C the velocity along the normal is computed as 0.
Scene hidden_approach(Random& random) {
  const auto any = [&random] { return 8 * random.unit() - 4; };
  Arm A = some_stated(random, -1);
  A.r = {any(), any(), -1 - random.unit()};
  A.body.velocity.w_WB = {any(), any(), any()};
  Contact contact = some_contact(random);
  contact.p_WC.setZero();  // so that the body's place has all bits of r
  const Vec3 u{random.whole(0, 1), random.whole(0, 1), 0};
  return meeting(random, A, fixed_ground(), u, contact);
}

Scene separating(Random& random) {
  if (random.one_in(2)) return hidden_approach(random);
  const Arm A = some_stated(random, -1), B = some_other(random);
  Vec3 u = some_approach(random);
  u.z() = random.pick({0.0, 0x1p-30, 1.0, 4.0});
  return meeting(random, A, B, u, some_contact(random));
}

/// Masses and inertias that differ by up to 2^40.
Scene mass_ratios(Random& random) {
  Arm A = some_stated(random, -1), B = some_stated(random, 1);
  const double heavier = std::ldexp(1.0, random.between(10, 40));
  auto& mass = std::get<MassProperties>((random.one_in(2) ? A : B).body.mass);
  mass.mass *= heavier;
  mass.I_BBcm_B *= heavier;
  const Vec3 u = some_approach(random);
  return meeting(random, A, B, u, some_contact(random));
}

/// C far from the body compared with its radius of gyration: K is nearly singular, cond(K) from 10² to 10¹².
Scene levers(Random& random) {
  Arm A = some_stated(random, -1);
  A.r *= std::ldexp(1.0, random.between(3, 20));
  A.body.velocity.w_WB.setZero();
  const Vec3 u = some_approach(random);
  return meeting(random, A, fixed_ground(), u, some_contact(random));
}

/// How much C of a body of mass 1 with these moments is accelerated by an impulse at r from its centre: K times it.
Vec3 accelerated(const Vec3& moments, const Vec3& r, const Vec3& impulse) {
  const Vec3 spin = r.cross(impulse).cwiseQuotient(moments);
  return impulse + spin.cross(r);
}

/// How much u_n has risen at most while slip turned, and when it stopped; and its last direction.
struct Rise {
  double greatest = 0, last = 0;
  Vec3 direction = Vec3::Zero();
};

/// By small steps of Coulomb's law at r from the centre of a body of mass 1. An estimate: it only makes a scene likely
/// to be what it is for. `greatest` is infinite if slip does not stop.
Rise rise_in_slip(const Vec3& moments, const Vec3& r, double friction, const Vec3& slip_before) {
  const double least = 0x1p-10 * (std::abs(slip_before.x()) + std::abs(slip_before.y()));
  Vec3 slip{slip_before.x(), slip_before.y(), 0};
  Rise rise;
  for (int steps = 0; slip.norm() > least; ++steps) {
    if (steps == 2048) return {infinity, 0, Vec3::Zero()};
    rise.direction = slip / slip.norm();
    Vec3 rate = accelerated(moments, r, Vec3::UnitZ() - friction * rise.direction);
    const double rise_rate = rate.z();
    rate.z() = 0;
    const double step = slip.norm() / (64 * rate.norm());
    slip += step * rate;
    rise.last += step * rise_rate;
    rise.greatest = std::max(rise.greatest, rise.last);
  }
  return rise;
}

/// Slip across the plane of the arm first lets u_n rise. It turns towards the direction in which u_n falls, and keeps
/// falling until slip stops. The approach is slightly less than the rise: restitution begins shortly before u_n falls,
/// so Poisson's restitution ends with the bodies approaching again, and Stronge's on the way. (In one plane that cannot
/// be: while slip keeps its direction so does the rate of u_n, and after slip has stopped u_n rises.)
Scene compressed_again(Random& random) {
  const double x = random.whole(1, 4), z = -random.whole(2, 8), I = dyadic(random, 1, 3, -2, 1);
  const double K_nn = 1 + x * x / I, k = -x * z / I;
  Contact contact = some_contact(random);
  contact.law = random.pick({Law::poisson, Law::poisson, Law::stronge});
  contact.restitution = random.pick({0.25, 0.5, 0.5, 0.75, 0.75});
  contact.friction = std::ceil(8 * K_nn / k) / 8 * random.pick({1.25, 1.5, 2.0, 3.0});
  const double side = random.sign();
  Vec3 u{-random.whole(0, 1), side * random.whole(2, 8), 0};
  const double less = std::ldexp(1.0, -random.between(4, 6));
  const double rise = rise_in_slip(Vec3::Constant(I), {x, 0, z}, contact.friction, u).greatest;
  u.z() = -std::ceil(std::ldexp((1 - less) * rise, 12)) * 0x1p-12;
  Body body = stated(random, 1, Vec3::Constant(I));
  body.velocity.w_WB.setZero();
  return meeting(random, {body, {x, 0, z}}, fixed_ground(), u, contact);
}

/// Three unlike moments and an arm in no plane, where slip turns by less than 53°: u_n becomes 0 and is less again when
/// slip stops. About 1 of 60 draws can do that, given the right approach.
Scene comes_back(Random& random) {
  Contact contact = some_contact(random);
  contact.law = random.pick({Law::poisson, Law::poisson, Law::stronge});
  for (int tries = 0; tries < 100; ++tries) {
    const Vec3 r{random.whole(-8, 8), random.whole(-8, 8), -random.whole(1, 8)};
    const double a = dyadic(random, 1, 7, -3, 1), b = dyadic(random, 1, 7, -3, 1), c = dyadic(random, 1, 7, -3, 1);
    const Vec3 moments{b + c, c + a, a + b};
    contact.friction = dyadic(random, 3, 22, -3, -3);
    Vec3 u{random.whole(-8, 8), random.whole(-8, 8), 0};
    const Rise rise = rise_in_slip(moments, r, contact.friction, u);
    const double least = std::max(rise.last, 0.0);
    if (!(rise.greatest < infinity) || !(rise.greatest - least > 0x1p-6)) continue;
    if (!(u.dot(rise.direction) > 0.625 * u.norm())) continue;
    const double share = random.pick({0.5, 0.5, 0.75, 0.9375});
    u.z() = -std::ceil(std::ldexp(least + share * (rise.greatest - least), 12)) * 0x1p-12;
    Body body = stated(random, 1, moments);
    body.velocity.w_WB.setZero();
    return meeting(random, {body, r}, fixed_ground(), u, contact);
  }
  return compressed_again(random);
}

/// mu |K_tn| > K_nn: slip can press the bodies together faster than the normal impulse separates them.
Scene jamming(Random& random) {
  if (random.one_in(2)) return compressed_again(random);
  if (random.one_in(2)) return comes_back(random);
  const Arm A = rod_end(random);
  const double I = std::get<MassProperties>(A.body.mass).I_BBcm_B(1, 1);
  const double K_nn = 1 + A.r.x() * A.r.x() / I, k = std::abs(A.r.x() * A.r.z()) / I;
  Contact contact = some_contact(random);
  contact.friction = k > 0 ? std::ceil(8 * K_nn / k) / 8 * random.pick({1.0, 1.25, 2.0}) : 2;
  const Vec3 u = some_approach(random);
  return meeting(random, A, fixed_ground(), u, contact);
}

/// One or both with the centre of mass off the origin, turned such that the axes are mapped to axes.
Scene off_centre(Random& random) {
  Arm A = some_stated(random, -1), B = some_other(random);
  const auto shift = [&random](Arm& arm) {
    auto* given = std::get_if<MassProperties>(&arm.body.mass);
    if (given == nullptr) return;
    arm.body.X_WB.q_WB = axes_quaternion(random);
    given->p_BBcm = small_vector(random, 4);
  };
  shift(A);
  if (random.one_in(2)) shift(B);
  const Vec3 u = some_approach(random);
  return meeting(random, A, B, u, some_contact(random));
}

/// Velocities times up to 2^±300, or lengths times up to 2^±40 and velocities times up to 2^±120.
Scene times_powers(Random& random) {
  Scene scene = random.one_in(2) ? planar(random) : boxes(random);
  const bool much = random.one_in(2);
  const int faster = much ? random.between(-300, 300) : random.between(-120, 120);
  for (Body& body : scene.bodies) {
    for (Vec3* v : {&body.velocity.v_WBcm, &body.velocity.w_WB}) *v *= std::ldexp(1.0, faster);
  }
  const int larger = much ? 0 : random.between(-40, 40);
  return scaled(scene, larger).value_or(scene);
}

/// No small integers: random doubles, a normal in any direction.
Scene generic(Random& random) {
  const auto any = [&random](double limit) { return any_vector(random, limit); };
  // C near the needle's end, as far beside its axis as it is thick.
  const auto needle = [&] {
    const double thin = std::ldexp(1.0, -random.between(8, 24));
    Body body = at_rest(Box{Vec3(1, thin, thin)}, {Vec3::Zero(), small_quaternion(random)});
    body.mass = Density{(0.5 + random.unit()) / (thin * thin)};
    body.velocity.w_WB = any(3);
    const Vec3 beside = thin * any(1);
    return Arm{body, turned_by(body.X_WB.q_WB, Vec3(0.5 + random.unit() / 2, beside.y(), beside.z()))};
  };
  const auto arm = [&] {
    if (random.one_in(8)) return needle();
    const Vec3 half = any(1).cwiseAbs() + Vec3::Constant(0.25);
    Body body = at_rest(Box{half}, {Vec3::Zero(), small_quaternion(random)});
    body.mass = Density{0.5 + random.unit()};
    body.velocity.w_WB = any(3);
    return Arm{body, half.minCoeff() * any(1)};
  };
  const Arm A = arm();
  Arm B = arm();
  if (random.one_in(2)) B = fixed_ground();
  Contact contact = some_contact(random);
  contact.restitution = random.unit();
  contact.friction = 2 * random.unit();
  Vec3 u = any(4);
  u.z() = -std::abs(u.z());
  Scene scene = meeting(random, A, B, u, contact);
  // The velocities are kept: with a normal within 35° of the old one the bodies mostly still approach.
  scene.contact->nhat_BA_W = (scene.contact->nhat_BA_W + any(0.4)).normalized();
  return scene;
}

/// The same 2^8 to 2^24 m from the origin, with the centres of mass off the bodies' own origins.
Scene far_away(Random& random) {
  Scene scene = generic(random);
  const auto part = [&random] { return 0.5 + random.unit() / 2; };
  const double far = std::ldexp(1.0, random.between(8, 24));
  const Vec3 place(far * part(), far * part(), far * part());
  scene.contact->p_WC += place;
  for (Body& body : scene.bodies) {
    body.X_WB.p_WB += place;
    if (is_fixed(body)) continue;
    const Vec3 off(part() / 4, part() / 4, -part() / 4), moments(3, 4 + part(), 5 + part());
    body.mass = MassProperties{part(), off, Mat3((moments / 16).asDiagonal())};
  }
  return scene;
}

/// Impacts for which all results are known on paper (docs/spec/impulse.md names them).
Scene known(Random& random) {
  struct Known {
    Vec3 r;
    double inertia;
    Vec3 u;
    double mu, e;
  };
  const Known& it = random.pick<Known>({
      {{-3, 0, -3}, 6, {3, 0, -5}, 1, 1},        // slip stops, and Newton's law gains 9/80 of (5 m/s)²
      {{-3, 0, -6}, 15, {-100, 0, -1}, 2, 0.5},  // a rod in the range of Painlevé's paradox
      {{0, 0, -1}, 0.5, {1, 0, -1}, 0.25, 0.5},  // a hoop or ball, k = 0
      {{2, 0, -1}, 4, {0, 0, -1}, 1, 0.5},       // sticks from the start
  });
  Body body = stated(random, 1, Vec3::Constant(it.inertia));
  body.velocity.w_WB.setZero();
  Contact contact = some_contact(random);
  contact.restitution = it.e;
  contact.friction = it.mu;
  return meeting(random, {body, it.r}, fixed_ground(), it.u, contact);
}

}  // namespace

std::vector<Family> contact_families() {
  const std::vector<std::string> queries = {"impulse"};
  return {
      {"contact.spheres", "balls, one against another or the ground", queries, true, spheres},
      {"contact.boxes", "uniform boxes, C in both, against another or the ground", queries, true, boxes},
      {"contact.rods", "the end of a leaning rod, or of a needle on the normal, friction to 3", queries, true, rods},
      {"contact.planar", "all velocities and arms in one plane", queries, true, planar},
      {"contact.zero_slip", "no slip before", queries, true, zero_slip},
      {"contact.tiny_slip", "slip 2^-8 to 2^-40 of the approach", queries, false, tiny_slip},
      {"contact.on_the_cone", "no slip before, and friction within an ulp of what holds", queries, false, on_the_cone},
      {"contact.spin_only", "nothing moves but by spin", queries, true, spin_only},
      {"contact.separating", "parting, or at rest along the normal but for rounding", queries, false, separating},
      {"contact.mass_ratios", "masses that differ by 2^10 to 2^40", queries, true, mass_ratios},
      {"contact.levers", "arms up to 2^20 times the radius of gyration: K near singular", queries, false, levers},
      {"contact.jamming", "friction that can press the bodies together, often twice", queries, true, jamming},
      {"contact.off_centre", "centres of mass off the bodies' origins, turned", queries, true, off_centre},
      {"contact.times_powers", "velocities and lengths times powers of two", queries, false, times_powers},
      {"contact.generic", "boxes and needles, velocities and normals at random", queries, false, generic},
      {"contact.far_away", "the same 2^8 to 2^24 m from the origin, centres of mass off the bodies' origins", queries,
       false, far_away},
      {"contact.known", "impacts that are known on paper", queries, true, known},
  };
}

}  // namespace touchstone::properties
