#include "app/adapter/paper/build.h"

#include <utility>

#include "model/input_error.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

Mat3 rows(const Vec3& x, const Vec3& y, const Vec3& z) {
  Mat3 R;
  R << x.transpose(), y.transpose(), z.transpose();
  return R;
}

/// The rotation of `first`, followed by that of `then` (Hamilton's product then · first).
Quaternion product(const Quaternion& then, const Quaternion& first) {
  const auto& [w, x, y, z] = then;
  const auto& [a, b, c, d] = first;
  return {w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b,
          w * d + x * c - y * b + z * a};
}

struct MoveAnswer {
  const WorldMotion& by;

  Vec3 vector(const Vec3& v) const { return by.turn.R * v; }
  Vec3 point(const Vec3& p) const { return by.turn.R * p + by.shift; }
  Pose pose(const Pose& X) const { return {point(X.p_WB), product(by.turn.q, X.q_WB)}; }
  Velocity velocity(const Velocity& v) const { return {vector(v.v_WBcm), vector(v.w_WB)}; }

  template <class T>
  void operator()(T&) const {
    throw InputError("paper scene", "its answer does not move with the world");
  }
  void operator()(Masses&) const {}        // in the body's own frame
  void operator()(TimeOfImpact&) const {}  // a time
  void operator()(Distance& answer) const {
    if (answer.p_WCa) answer.p_WCa = point(*answer.p_WCa);
    if (answer.p_WCb) answer.p_WCb = point(*answer.p_WCb);
  }
  void operator()(Penetration& answer) const {
    if (answer.nhat_BA_W) answer.nhat_BA_W = vector(*answer.nhat_BA_W);
  }
  void operator()(Impulse& answer) const {
    for (Velocity& after : answer.after) after = velocity(after);
    if (answer.P_A_W) answer.P_A_W = vector(*answer.P_A_W);
  }
  void operator()(Trajectory& answer) const {
    for (std::vector<State>& states : answer.states) {
      for (State& state : states) state = {pose(state.X_WB), velocity(state.velocity)};
    }
  }
};

}  // namespace

const Turn upright{{1, 0, 0, 0}, Mat3::Identity()};
const Turn quarter_about_x{{3, 3, 0, 0}, rows({1, 0, 0}, {0, 0, -1}, {0, 1, 0})};
const Turn cyclic{{1, 1, 1, 1}, rows({0, 0, 1}, {1, 0, 0}, {0, 1, 0})};
const Turn three_four_five{{2, 0, 0, 1}, rows({0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1})};
const Turn general{{4, 2, 2, 1}, rows({0.6, 0, 0.8}, {0.64, 0.6, -0.48}, {-0.48, 0.8, 0.36})};

Body body(Shape shape, const Vec3& p_WB, const Turn& turn) {
  Body made;
  made.shape = std::move(shape);
  made.X_WB = {p_WB, turn.q};
  return made;
}

Body hull(const std::vector<Vec3>& vertices, const Vec3& p_WB, const Turn& turn) {
  Polytope polytope;
  for (const Vec3& vertex : vertices) polytope.vertices.push_back(turn.R.transpose() * vertex);
  return body(polytope, p_WB, turn);
}

std::vector<Vec3> corners(const Vec3& half_extents) {
  std::vector<Vec3> all;
  for (int i = 0; i < 8; ++i) {
    all.push_back(half_extents.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  }
  return all;
}

Body moving(Body body, const Vec3& v_WBcm, const Vec3& w_WB) {
  body.velocity = {v_WBcm, w_WB};
  return body;
}

Body dense(Body body, double density) {
  body.mass = Density{density};
  return body;
}

Body given(Body body, double mass, const Vec3& moments, const Vec3& p_BBcm) {
  body.mass = MassProperties{mass, p_BBcm, moments.asDiagonal()};
  return body;
}

Body fixed(Body body) {
  body.mass = Fixed{};
  return body;
}

Scene scene(const std::string& name, std::vector<Body> bodies) {
  Scene made;
  made.name = name;
  made.bodies = std::move(bodies);
  return made;
}

PaperScene moved(const PaperScene& paper, const WorldMotion& motion) {
  const MoveAnswer move{motion};
  PaperScene result = paper;
  for (Body& body : result.scene.bodies) {
    body.X_WB = move.pose(body.X_WB);
    body.velocity = move.velocity(body.velocity);
  }
  result.scene.gravity = move.vector(result.scene.gravity);
  if (auto& contact = result.scene.contact) {
    contact->p_WC = move.point(contact->p_WC);
    contact->nhat_BA_W = move.vector(contact->nhat_BA_W);
  }
  if (auto& asked = result.scene.motion) {
    for (AppliedForce& force : asked->forces) force.force_W = move.vector(force.force_W);
  }
  std::visit(move, result.expected);
  return result;
}

std::vector<PaperScene> in_all(const std::vector<PaperScene>& papers, const std::vector<WorldMotion>& motions) {
  std::vector<PaperScene> all;
  for (const PaperScene& paper : papers) {
    for (const WorldMotion& motion : motions) all.push_back(moved(paper, motion));
  }
  return all;
}

const std::vector<WorldMotion>& three_frames() {
  static const std::vector<WorldMotion> frames = {
      {upright, {0, 0, 0}}, {quarter_about_x, {1, 2, -3}}, {general, {-2, 1, 4}}};
  return frames;
}

const std::vector<WorldMotion>& five_frames() {
  static const std::vector<WorldMotion> frames = {{upright, {0, 0, 0}},
                                                  {quarter_about_x, {1, 2, -3}},
                                                  {general, {-2, 1, 4}},
                                                  {upright, {8, -4, 5}},
                                                  {cyclic, {3, -5, 2}}};
  return frames;
}

/// Faces are derived, as the judge does before it asks.
std::vector<PaperScene> paper_scenes(const std::string& query) {
  static const std::vector<std::pair<std::string, std::vector<PaperScene> (*)()>> all = {
      {"mass", mass_on_paper},
      {"bounds", bounds_on_paper},
      {"broad_phase", broad_phase_on_paper},
      {"pair_history", pair_history_on_paper},
      {"distance", distance_on_paper},
      {"penetration", penetration_on_paper},
      {"impulse", impulse_on_paper},
      {"pixel", pixel_on_paper},
      {"time_of_impact", time_of_impact_on_paper},
      {"simulation", simulation_on_paper},
      {"constraint", constraint_on_paper}};
  for (const auto& [name, make] : all) {
    if (name != query) continue;
    std::vector<PaperScene> papers = make();
    for (PaperScene& paper : papers) paper.scene = reference::completed(std::move(paper.scene));
    return papers;
  }
  throw InputError("query \"" + query + '"', "unknown");
}

}  // namespace touchstone::app
