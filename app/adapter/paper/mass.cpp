#include <numbers>

#include "app/adapter/paper/build.h"

namespace touchstone::app {
namespace {

MassProperties with(double mass, const Vec3& p_BBcm, const Vec3& moments,
                    const Vec3& products_yz_zx_xy = Vec3::Zero()) {
  MassProperties known{mass, p_BBcm, Mat3(moments.asDiagonal())};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    known.I_BBcm_B(j, k) = known.I_BBcm_B(k, j) = products_yz_zx_xy[i];
  }
  return known;
}

PaperScene known(const std::string& name, const Body& body, const std::optional<MassProperties>& mass) {
  return {scene(name, {body}), Masses{mass}};
}

/// (b² + c², c² + a², a² + b²): moments are sums of two squares.
Vec3 sums(double a, double b, double c) { return {b * b + c * c, c * c + a * a, a * a + b * b}; }

// Box: m = 8 ρ hx hy hz, I = m/3 (hy² + hz², ...), since the mean of x² over [-h, h] is h²/3.
PaperScene box_of(const std::string& name, const Vec3& h, double density) {
  const double m = density * 8 * h.prod();
  return known(name, dense(body(Box{h}, {0, 0, 0}), density), with(m, {0, 0, 0}, m / 3 * sums(h.x(), h.y(), h.z())));
}

// Ball: m = 4/3 π ρ r³, I = 2/5 m r².
PaperScene ball_of(const std::string& name, double r, double density) {
  const double m = density * 4 / 3 * std::numbers::pi * r * r * r;
  return known(name, dense(body(Sphere{r}, {0, 0, 0}), density), with(m, {0, 0, 0}, 0.4 * m * r * r * Vec3(1, 1, 1)));
}

// Corner tetrahedron with the orthogonal edges a, b, c: m = ρ abc/6, centre (a, b, c)/4. The mean of x² is a²/10, and
// that of xy is ab/20; about the centre they are 3a²/80 and −ab/80, and Ixy is minus the latter.
PaperScene corner_tetrahedron() {
  const double a = 4, b = 2, c = 1, m = 3 * a * b * c / 6;
  const Body solid = body(Polytope{{{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}}, {}}, {0, 0, 0});
  return known("a tetrahedron", dense(solid, 3),
               with(m, {a / 4, b / 4, c / 4}, m * 3 / 80 * sums(a, b, c), m / 80 * Vec3(b * c, c * a, a * b)));
}

// The box (1, 2, 3) as a hull, shifted in its own frame by d: its centre is d, and its inertia about it that of the
// box.
PaperScene shifted_hull() {
  const Vec3 h(1, 2, 3), d(4, -1, 2);
  Polytope polytope{corners(h), {}};
  for (Vec3& vertex : polytope.vertices) vertex += d;
  const double m = 2 * 48;
  return known("a hull away from its origin", dense(body(polytope, {0, 0, 0}), 2), with(m, d, m / 3 * sums(1, 2, 3)));
}

// Prism over a right triangle with the short sides a, b, of length L: m = ρ abL/2, centre (a/3, b/3, L/2). About it the
// means of x², y², z², xy are a²/18, b²/18, L²/12, −ab/36.
PaperScene prism() {
  const double a = 3, b = 6, L = 2, m = 0.5 * a * b * L / 2;
  const Polytope solid{{{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, L}, {a, 0, L}, {0, b, L}}, {}};
  const double xx = a * a / 18, yy = b * b / 18, zz = L * L / 12;
  return known("a prism", dense(body(solid, {0, 0, 0}), 0.5),
               with(m, {a / 3, b / 3, L / 2}, m * Vec3(yy + zz, zz + xx, xx + yy), {0, 0, m * a * b / 36}));
}

// Octahedron with the semi-axes a, b, c: m = 4/3 ρ abc, and the mean of x² is a²/10.
PaperScene octahedron() {
  const double a = 1, b = 2, c = 3, m = 7 * 4 * a * b * c / 3;
  const Polytope solid{{{a, 0, 0}, {-a, 0, 0}, {0, b, 0}, {0, -b, 0}, {0, 0, c}, {0, 0, -c}}, {}};
  return known("an octahedron", dense(body(solid, {0, 0, 0}), 7), with(m, {0, 0, 0}, m / 10 * sums(a, b, c)));
}

// Two cubes of side 2 at (±3, 1, 0): each has m = 8 and the moments 16/3; Steiner adds 8 · 3² to those about y and z.
PaperScene dumbbell() {
  const Part left{{{-3, 1, 0}, {}}, Box{{1, 1, 1}}}, right{{{3, 1, 0}, {}}, Box{{1, 1, 1}}};
  return known("two boxes as one body", body(Compound{{left, right}}, {0, 0, 0}),
               with(16, {0, 1, 0}, 2 * (Vec3(16, 16, 16) / 3 + Vec3(0, 72, 72))));
}

}  // namespace

std::vector<PaperScene> mass_on_paper() {
  const Body box = body(Box{{1, 2, 3}}, {0, 0, 0});
  return in_all({box_of("a box", {1, 2, 3}, 1), box_of("a light box", {2, 1, 3}, 0.25),
                 box_of("a slab", {4, 2, 0.5}, 5), box_of("a small, heavy box", {0.25, 0.5, 1}, 800),
                 ball_of("a ball", 2, 1), ball_of("a small, heavy ball", 0.5, 300), corner_tetrahedron(),
                 shifted_hull(), prism(), octahedron(), dumbbell(),
                 // given mass properties are returned as they are
                 known("a given mass", given(box, 3, {4, 5, 6}, {1, 2, 3}), with(3, {1, 2, 3}, {4, 5, 6})),
                 // a fixed body has no mass
                 known("a fixed body", fixed(box), std::nullopt)},
                three_frames());
}

}  // namespace touchstone::app
