#include "app/adapter/paper/build.h"

namespace touchstone::app {
namespace {

const Turn about_x{{2, 1, 0, 0}, (Mat3() << 1, 0, 0, 0, 0.6, -0.8, 0, 0.8, 0.6).finished()};  // cos = 3/5, sin = 4/5
const Turn about_y{{2, 0, 1, 0}, (Mat3() << 0.6, 0, 0.8, 0, 1, 0, -0.8, 0, 0.6).finished()};  // the same about y

/// A slender tetrahedron that stands on its apex, which is its origin.
const std::vector<Vec3> spike = {{0, 0, 0}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2}};

PaperScene apart(const std::string& name, const Body& A, const Body& B, double distance, const Vec3& p_WCa,
                 const Vec3& p_WCb) {
  Distance known;
  known.verdict = Verdict::separated;
  known.distance = distance;
  known.p_WCa = p_WCa;
  known.p_WCb = p_WCb;
  return {scene(name, {A, B}), known};
}

PaperScene deep(const std::string& name, const Body& A, const Body& B, double depth, const Vec3& nhat_BA_W) {
  return {scene(name, {A, B}), Penetration{Verdict::overlapping, depth, nhat_BA_W}};
}

/// The same with A and B exchanged.
PaperScene exchanged(PaperScene paper) {
  std::swap(paper.scene.bodies[0], paper.scene.bodies[1]);
  if (auto* d = std::get_if<Distance>(&paper.expected)) std::swap(d->p_WCa, d->p_WCb);
  if (auto* p = std::get_if<Penetration>(&paper.expected)) p->nhat_BA_W = -*p->nhat_BA_W;
  return paper;
}

PaperScene overlapping(const std::string& name, const Body& A, const Body& B) {
  Distance known;
  known.verdict = Verdict::overlapping;
  known.distance = 0;
  return {scene(name, {A, B}), known};
}

Body ball(double r, const Vec3& p) { return body(Sphere{r}, p, general); }
Body box(const Vec3& h, const Vec3& p, const Turn& turn = upright) { return body(Box{h}, p, turn); }

}  // namespace

std::vector<PaperScene> distance_on_paper() {
  const Vec3 o(0, 0, 0), h(1, 2, 3);
  return in_all(
      {// centres (3, 4, 0) apart, so 5: d = 5 − 1 − 2, along (3, 4, 0)/5
       apart("two balls", ball(1, {3, 4, 0}), ball(2, o), 2, {2.4, 3.2, 0}, {1.2, 1.6, 0}),
       // above the face x = 1: d = 3 − 1 − 0.5
       apart("a ball above a face", ball(0.5, {3, 0.5, 0.25}), box(h, o), 1.5, {2.5, 0.5, 0.25}, {1, 0.5, 0.25}),
       // (2, 3, 6) = 7 (2, 3, 6)/7 away from the corner (1, 2, 3): d = 7 − 1
       exchanged(apart("a ball off a corner", ball(1, {3, 5, 9}), box(h, o), 6, {19.0 / 7, 32.0 / 7, 57.0 / 7}, h)),
       // A's lowest edge runs along x through (y, z) = (1, −7)/5 + (0, 5), B's highest along y through (x, z) = (1,
       // 7)/5
       apart("an edge above an edge", box({2, 1, 1}, {0, 0, 5}, about_x), box({1, 2, 1}, o, about_y), 2.2,
             {0.2, 0.2, 3.6}, {0.2, 0.2, 1.4}),
       // the apex is 2 above the face z = 1
       apart("a hull's apex above a box", hull(spike, {0.25, 0.5, 3}, about_x), box({4, 3, 1}, o), 2, {0.25, 0.5, 3},
             {0.25, 0.5, 1}),
       exchanged(apart("a hull's apex above a hull", hull(spike, {1, -1, 2.5}, cyclic),
                       hull(corners({4, 3, 1}), o, about_y), 1.5, {1, -1, 2.5}, {1, -1, 1})),
       // the part at (0, 2, 0) of the body is at (0, 0, 2) in the world: d = 6 − 2 − 0.5 − 1
       apart("a ball above two balls that are one body", ball(1, {0, 0, 6}),
             body(Compound{{{{{0, 2, 0}, {}}, Sphere{0.5}}, {{{0, -2, 0}, {}}, Sphere{0.5}}}}, o, quarter_about_x), 2.5,
             {0, 0, 5}, {0, 0, 2.5}),
       // 2 < 1 + 2, and 1.5 < 1 + 1
       overlapping("two balls in each other", ball(1, {0, 2, 0}), ball(2, o)),
       overlapping("boxes in each other", box({1, 1, 1}, {0.5, 0.5, 1.5}), box({1, 1, 1}, o))},
      five_frames());
}

std::vector<PaperScene> penetration_on_paper() {
  const Vec3 o(0, 0, 0), h(1, 2, 3);
  // Each box or hull below overlaps its partner by 0.25 along one axis, and by more along all others.
  return in_all(
      {// centres 2 apart along (3, 4, 0)/5: 1 + 1.5 − 2
       deep("two balls", ball(1, {1.2, 1.6, 0}), ball(1.5, o), 0.5, {0.6, 0.8, 0}),
       // its lowest point, x = 1.25 − 0.5, is 0.25 below the face x = 1
       deep("a ball in a face", ball(0.5, {1.25, 0.5, 0.25}), box(h, o), 0.25, {1, 0, 0}),
       // along z: 1 + 3 − 3.75
       deep("boxes on each other", box({1, 1, 1}, {0.25, 0.5, 3.75}), box(h, o), 0.25, {0, 0, 1}),
       // along y, in which the turned box reaches 3: 2 + 3 − 4.75
       exchanged(deep("a turned box beside a box", box(h, {0.25, 4.75, 0.5}, quarter_about_x), box({2, 2, 2}, o), 0.25,
                      {0, 1, 0})),
       // along x, between the hulls' faces: 1 + 1.5 − 2.25
       deep("hulls beside each other", hull(corners({1, 1, 1}), {-2.25, 0.5, 0.25}, about_x),
            hull(corners({1.5, 2, 2}), o, cyclic), 0.25, {-1, 0, 0}),
       // the edges of distance's scene, A lower by 2.2 + 0.25; the next least depth, along A's face (0, 3, 4)/5,
       // is 1.28
       deep("an edge in an edge", box({2, 1, 1}, {0, 0, 2.55}, about_x), box({1, 2, 1}, o, about_y), 0.25, {0, 0, 1}),
       // the apex is 0.25 below the face z = 1
       exchanged(
           deep("a hull's apex in a box", hull(spike, {0.25, 0.5, 0.75}, about_x), box({4, 3, 1}, o), 0.25, {0, 0, 1})),
       // bodies that are apart have the depth 0
       {scene("boxes apart", {box({1, 1, 1}, {4, 0, 0}), box({1, 1, 1}, o)}),
        Penetration{Verdict::separated, 0.0, std::nullopt}}},
      five_frames());
}

}  // namespace touchstone::app
