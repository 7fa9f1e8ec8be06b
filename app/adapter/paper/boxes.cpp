#include <algorithm>

#include "app/adapter/paper/build.h"

namespace touchstone::app {
namespace {

const std::vector<Vec3> tetrahedron = {{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}};

// The box of a ball has its radius on each side of its centre.
PaperScene box_of_ball(const Vec3& p, const Turn& turn) {
  const double r = 2;
  return {scene("a ball", {body(Sphere{r}, p, turn)}), Bounds{{p - Vec3(r, r, r), p + Vec3(r, r, r)}}};
}

// A box reaches Σ |R_ij| h_j along axis i.
PaperScene box_of_box(const Vec3& p, const Turn& turn) {
  const Vec3 h(1, 2, 3), reach = turn.R.cwiseAbs() * h;
  return {scene("a box", {body(Box{h}, p, turn)}), Bounds{{p - reach, p + reach}}};
}

// A hull reaches as far as its vertices R v.
PaperScene box_of_hull(const Vec3& p, const Turn& turn) {
  Aabb box{p, p};  // the first vertex is the body's origin
  for (const Vec3& v : tetrahedron) {
    box.lo = box.lo.cwiseMin(turn.R * v + p);
    box.hi = box.hi.cwiseMax(turn.R * v + p);
  }
  return {scene("a hull away from its origin", {body(Polytope{tetrahedron, {}}, p, turn)}), Bounds{box}};
}

// Balls of radius 1/2 at (0, 3, 0) and (0, −1, 0) of the body.
PaperScene box_of_compound(const Vec3& p, const Turn& turn) {
  const Vec3 a = turn.R * Vec3(0, 3, 0) + p, b = turn.R * Vec3(0, -1, 0) + p, half(0.5, 0.5, 0.5);
  const Compound two{{{{{0, 3, 0}, {}}, Sphere{0.5}}, {{{0, -1, 0}, {}}, Sphere{0.5}}}};
  return {scene("two balls as one body", {body(two, p, turn)}), Bounds{{a.cwiseMin(b) - half, a.cwiseMax(b) + half}}};
}

// A scene of three bodies has three boxes, in its order.
PaperScene three_bodies(const Vec3& p, const Turn& turn) {
  PaperScene all{scene("a ball, a box and a hull", {}), Bounds{}};
  for (const PaperScene& one : {box_of_ball(p, turn), box_of_box(2 * p, turn), box_of_hull(-p, quarter_about_x)}) {
    all.scene.bodies.push_back(one.scene.bodies[0]);
    std::get<Bounds>(all.expected).push_back(std::get<Bounds>(one.expected)[0]);
  }
  return all;
}

Body block(const Vec3& half, const Vec3& p, const Turn& turn = upright) { return body(Box{half}, p, turn); }

std::vector<PaperScene> pairs() {
  const Vec3 unit(1, 1, 1);
  std::vector<PaperScene> all;
  // boxes of half width 1 overlap when their centres are less than 2 apart
  all.push_back({scene("a row of boxes", {block(unit, {4.5, 0, 0}), block(unit, {0, 0, 0}), block(unit, {1.5, 0, 0}),
                                          block(unit, {3, 0, 0}), block(unit, {20, 0, 0})}),
                 PairSet{{0, 3}, {1, 2}, {2, 3}}});
  // balls that are apart, 1.7·√3 > 2, but whose boxes overlap: 1.7 < 2
  all.push_back({scene("balls whose boxes overlap",
                       {body(Sphere{1}, {0, 0, 0}), body(Sphere{1}, {1.7, 1.7, 1.7}), body(Sphere{1}, {0, 2.5, 0})}),
                 PairSet{{0, 1}, {1, 2}}});
  // after the turn about x the rod reaches 3 along z, and 0.5 along y
  all.push_back({scene("a rod that is turned", {block({0.5, 3, 0.5}, {0, 0, 0}, quarter_about_x),
                                                block(unit, {0, 0, 3.5}), block(unit, {0, 3.5, 0})}),
                 PairSet{{0, 1}}});
  // the 3-4-5 turn takes the reach 3 along x to 0.6 · 3 + 0.8 · 0.5 = 2.2 along x, and 0.8 · 3 + 0.6 · 0.5 = 2.7 along
  // y
  all.push_back(
      {scene("a rod that is turned askew", {block({3, 0.5, 0.5}, {0, 0, 0}, three_four_five), block(unit, {3.5, 0, 0}),
                                            block(unit, {0, 3.5, 0}), block(unit, {3, 0, 3})}),
       PairSet{{0, 2}}});
  // hulls away from their origins: [0, 4] and [3, 7] overlap along x, [0, 4] and [5, 9] do not
  all.push_back({scene("hulls away from their origins",
                       {hull(tetrahedron, {0, 0, 0}), hull(tetrahedron, {3, 0, 0}), hull(tetrahedron, {5, 1, 0})}),
                 PairSet{{0, 1}, {1, 2}}});
  all.push_back(
      {scene("bodies far apart", {block(unit, {0, 0, 0}), block(unit, {0, 9, 0}), body(Sphere{1}, {9, 0, 0})}),
       PairSet{}});
  all.push_back({scene("all overlap", {block(unit, {0, 0, 0}), block(unit, {1, 0, 0}), body(Sphere{2}, {0, 1, 0}),
                                       hull(corners(unit), {0, 0, 1})}),
                 PairSet{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}});
  return all;
}

/// Shifts change no pair.
std::vector<PaperScene> shifted(const std::vector<PaperScene>& papers) {
  std::vector<PaperScene> all;
  for (const PaperScene& paper : papers) {
    for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(-30, 5, 8), Vec3(1, -2, 60)}) {
      all.push_back(paper);
      for (Body& body : all.back().scene.bodies) body.X_WB.p_WB += shift;
      for (SequenceFrame& frame : all.back().scene.frames) {
        for (Placement& placement : frame) {
          if (placement.X_WB) placement.X_WB->p_WB += shift;
        }
      }
    }
  }
  return all;
}

}  // namespace

std::vector<PaperScene> bounds_on_paper() {
  std::vector<PaperScene> all;
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(7, -3, 11)}) {
    for (const Turn* turn : {&upright, &quarter_about_x, &cyclic, &three_four_five, &general}) {
      all.push_back(box_of_ball(p, *turn));
      all.push_back(box_of_box(p, *turn));
    }
    // a hull that is turned askew may get the box of its turned local box, so its turns take axes to axes
    for (const Turn* turn : {&upright, &quarter_about_x, &cyclic}) {
      all.push_back(box_of_hull(p, *turn));
      all.push_back(box_of_compound(p, *turn));
      all.push_back(three_bodies(p, *turn));
    }
  }
  return all;
}

std::vector<PaperScene> broad_phase_on_paper() { return shifted(pairs()); }

/// Boxes of half width 1 on a line: they come, pass each other, are removed and return. They overlap when they are less
/// than 2 apart.
std::vector<PaperScene> pair_history_on_paper() {
  const auto at = [](double x) { return Pose{{x, 0.25, 0.5}, {}}; };
  const auto entry = [](PairSet pairs) { return PairFrame{std::move(pairs), {}, {}}; };
  Scene come = scene("boxes come and pass", {});
  for (int i = 0; i < 3; ++i) come.bodies.push_back(block({1, 1, 1}, {0, 0, 0}));
  Scene go = come, stay = come;
  come.frames = {{{1, at(0)}}, {{0, at(9)}}, {{0, at(1.5)}, {2, at(3)}}, {}};
  go.name = "a box is removed and returns";
  go.frames = {{{0, at(0)}, {1, at(1)}, {2, at(2.5)}}, {{1, {}}}, {{0, at(1.5)}}, {{1, at(3)}}};
  stay.name = "nothing changes";
  stay.frames = {{{0, at(0)}, {2, at(1)}}, {}, {}};
  return shifted(
      {{come, PairHistory{entry({}), entry({}), entry({{0, 1}, {0, 2}}), entry({{0, 1}, {0, 2}})}},
       {go, PairHistory{entry({{0, 1}, {1, 2}}), entry({}), entry({{0, 2}}), entry({{0, 1}, {0, 2}, {1, 2}})}},
       {stay, PairHistory{entry({{0, 2}}), entry({{0, 2}}), entry({{0, 2}})}}});
}

}  // namespace touchstone::app
