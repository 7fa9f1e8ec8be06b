#include "fast/collider.h"

#include <algorithm>
#include <utility>

#include "fast/broad_phase/wrapped_grid.h"
#include "model/infinity.h"

namespace touchstone::fast {
namespace {

using lin_canny::Convex;

/// A bounding ball: all points of a part are within `radius` of `centre`, in the body's frame.
struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 0;
};

/// About the middle of the box in the body's axes, so that it is at most the ball about that box.
Ball ball_around(const lin_canny::Solid& solid) {
  const auto each = [&](auto&& see) {
    for (const Convex& part : solid.parts()) {
      for (const Vec3& v : part.core.vertices()) {
        see(part.is_posed ? Vec3(part.R_BP * v + part.X_BP.p_WB) : v, part.radius);
      }
    }
  };
  Vec3 lo = Vec3::Constant(infinity), hi = -lo;
  each([&](const Vec3& v, double r) {
    lo = lo.cwiseMin(v - Vec3::Constant(r));
    hi = hi.cwiseMax(v + Vec3::Constant(r));
  });
  Ball ball{lo / 2 + hi / 2, 0};
  each([&](const Vec3& v, double r) { ball.radius = std::max(ball.radius, (v - ball.centre).stableNorm() + r); });
  return ball;
}

}  // namespace

Collider::Collider(double margin) : Collider(std::make_unique<WrappedGrid>(), margin) {}

Collider::Collider(std::unique_ptr<BroadPhase> broad_phase, double margin)
    : broad_phase_(std::move(broad_phase)), margin_(margin) {}

/// Rounding: the parts' vertices and the ball's radius by 40u of the ball's reach from the origin; the centre's
/// position by turn_error times its length and by u of the sum with p. 64u of all lengths involved covers both, and the
/// rounding of the cube's ends.
Aabb Collider::cube(const Resident& body) const {
  const Vec3& p = body.cached_pose.X_WB.p_WB;
  const Vec3 centre = body.cached_pose.R_WB * body.centre + p;
  const double lengths = p.lpNorm<1>() + body.centre.lpNorm<1>() + body.radius;
  const Vec3 reach = Vec3::Constant(body.radius + margin_ / 2 + 64 * u * (lengths + margin_) + 0x1p-1000);
  return {centre - reach, centre + reach};
}

void Collider::insert(BodyId id, const Shape& shape, const Pose& X_WB) {
  lin_canny::Solid solid(shape);
  const Ball ball = ball_around(solid);
  auto body =
      std::make_unique<Resident>(Resident{std::move(solid), lin_canny::CachedPose(X_WB), ball.centre, ball.radius});
  broad_phase_->insert(id, cube(*body));
  if (id >= bodies_.size()) bodies_.resize(id + 1);
  bodies_[id] = std::move(body);
  // If a body was removed and inserted again within one frame its pairs may persist, but the walks' memory is void.
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const BodyPair& pair = near_[i].bodies;
    if (pair.a == id || pair.b == id) memory_[i] = places(pair);
  }
}

void Collider::move(BodyId id, const Pose& X_WB) {
  if (id >= bodies_.size() || !bodies_[id]) return broad_phase_->move(id, {});  // throws InputError: no such body
  const lin_canny::CachedPose before = bodies_[id]->cached_pose;
  bodies_[id]->cached_pose = lin_canny::CachedPose(X_WB);
  try {
    broad_phase_->move(id, cube(*bodies_[id]));
  } catch (...) {
    bodies_[id]->cached_pose = before;
    throw;
  }
}

/// The body is kept until its pairs have ended, in the next update.
void Collider::remove(BodyId id) { broad_phase_->remove(id); }

std::vector<lin_canny::FeaturePair> Collider::places(BodyPair pair) const {
  return std::vector<lin_canny::FeaturePair>(lin_canny::pairs_of_parts(bodies_[pair.a]->solid, bodies_[pair.b]->solid));
}

void Collider::begin(BodyPair pair) {
  position_[key(pair)] = near_.size();
  near_.push_back({pair, {}});
  memory_.push_back(places(pair));
}

/// Removes the pair; the last pair takes its place.
void Collider::end(BodyPair pair) {
  const auto found = position_.find(key(pair));
  const std::size_t at = found->second;
  position_.erase(found);
  if (at + 1 != near_.size()) {
    near_[at] = std::move(near_.back());
    memory_[at] = std::move(memory_.back());
    position_[key(near_[at].bodies)] = at;
  }
  near_.pop_back();
  memory_.pop_back();
}

void Collider::find_near() {
  broad_phase_->update();
  for (const BodyPair& pair : broad_phase_->ended()) end(pair);
  for (const BodyPair& pair : broad_phase_->begun()) begin(pair);
}

void Collider::measure_near() {
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const Resident& A = *bodies_[near_[i].bodies.a];
    const Resident& B = *bodies_[near_[i].bodies.b];
    near_[i].nearest = nearest_parts(A.solid, A.cached_pose, B.solid, B.cached_pose, memory_[i]);
  }
}

void Collider::update() {
  find_near();
  measure_near();
}

}  // namespace touchstone::fast
