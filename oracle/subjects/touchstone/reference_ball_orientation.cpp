#include "oracle/subjects/touchstone/reference_ball_orientation.h"

#include <Eigen/Geometry>
#include <cstddef>

#include "oracle/truth/impact.h"
#include "oracle/truth/turn.h"

namespace touchstone::oracle::subjects {
namespace {

using Rotation = Eigen::Quaternion<Real>;

Point middle(const std::array<Interval, 3>& v) { return {v[0].middle(), v[1].middle(), v[2].middle()}; }

class Turning {
 public:
  Turning(const ImpactBody& ball, const Quaternion& q)
      : ball_(ball), turned_(Rotation(q.w, q.x, q.y, q.z).normalized()), w_(ball.w_WB) {}

  void until(Real time, const Point& w) {
    const Real seconds = time - time_;
    if (seconds > 0) turned_ = (by(w, seconds) * turned_).normalized();
    time_ = time;
    w_ = w;
  }

  /// The impulse of a change acts at C, a radius away along −n̂.
  void until(const reference::ConstraintTruth::Change& change, Real radius) {
    const Point after = middle(change.after.w_WB), arm = -radius * change.nhat_W.cast<Real>();
    until(change.time.middle(), after - ball_.spin(arm.cross(change.P_W.cast<Real>())));
    w_ = after;
  }

  Quaternion now() const {
    return {static_cast<double>(turned_.w()), static_cast<double>(turned_.x()), static_cast<double>(turned_.y()),
            static_cast<double>(turned_.z())};
  }

 private:
  Rotation by(const Point& w, Real seconds) const {
    const Real angle = w.norm() * seconds;
    if (w == w_) return angle > 0 ? Rotation(Eigen::AngleAxis<Real>(angle, w.normalized())) : Rotation::Identity();
    return is_short_turn(w_, w, seconds) ? Rotation(turn(w_, w, seconds)) : Rotation::Identity();
  }

  const ImpactBody& ball_;
  Rotation turned_;
  Real time_ = 0;
  Point w_;
};

}  // namespace

std::vector<Quaternion> orientations(const reference::ConstraintTruth& truth, const Scene& scene) {
  const auto index = static_cast<std::size_t>(truth.ball);
  const Body& body = scene.bodies[index];
  const ImpactBody ball = impact_body(scene, index, Vec3::Zero());
  Turning turning(ball, body.X_WB.q_WB);
  std::vector<Quaternion> at_samples;
  auto change = truth.changes.begin();
  for (std::size_t i = 0; i < truth.states.size(); ++i) {
    const double sample = scene.motion->sample_times[i];
    for (; change != truth.changes.end() && change->time.middle() <= sample; ++change) {
      turning.until(*change, std::get<Sphere>(body.shape).radius);
    }
    turning.until(sample, middle(truth.states[i].w_WB));
    at_samples.push_back(turning.now());
  }
  return at_samples;
}

}  // namespace touchstone::oracle::subjects
