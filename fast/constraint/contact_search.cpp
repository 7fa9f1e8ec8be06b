#include "fast/constraint/contact_search.h"

#include <algorithm>
#include <string>

#include "model/input_error.h"

namespace touchstone::fast::constraint {
namespace {

using contact::index;

/// Where an impulse acts, in gaps from the middle towards A. If one body is fixed, at the point of the moving body,
/// which is where contact will be once the gap is closed. If both move, midway, so that equal impulses have opposite
/// moments.
double from_middle(const StepperBody& A, const StepperBody& B) {
  if (A.is_fixed()) return -0.5;
  return B.is_fixed() ? 0.5 : 0;
}

/// Adds each impulse of the last step to the nearest contact point of this one. The corners of a common face come in
/// any order and number, and under a heavy body a guess with the load at the wrong points is worse than none.
void guess(const ContactPair& pair, StepContacts& found) {
  for (const TrackedPair::Loaded& before : pair.tracked->loaded) {
    std::size_t nearest = pair.first;
    const auto apart = [&](std::size_t i) { return (found.points[i].p_WC - before.p_WC).squaredNorm(); };
    for (std::size_t i = pair.first; i < pair.first + pair.count; ++i) {
      if (apart(i) < apart(nearest)) nearest = i;
    }
    found.rows[nearest].P += before.P;
  }
}

lin_canny::Proximity proximity_of(const StepperBody& A, const StepperBody& B,
                                  std::vector<lin_canny::FeaturePair>& walk) {
  return nearest_parts(A.solid(), lin_canny::CachedPose(A.pose()), B.solid(), lin_canny::CachedPose(B.pose()), walk)
      .proximity;
}

}  // namespace

ContactSearch::ContactSearch(const Scene& scene, const std::vector<StepperBody>& bodies, double skin,
                             double longest_step)
    : scene_(scene), skin_(skin), margin_(skin + 2 * longest_step * greatest_speed(bodies)) {
  for (std::size_t i = 0; i < bodies.size(); ++i) boxes_.insert(static_cast<BodyId>(i), around(bodies[i]));
}

Aabb ContactSearch::around(const StepperBody& body) const {
  const Vec3 reach = Vec3::Constant(body.reach() + margin_);
  return {body.centre() - reach, body.centre() + reach};
}

/// An upper bound of any point's speed over the motion, unless forces or impacts add energy from elsewhere; contacts
/// are then detected late.
double ContactSearch::greatest_speed(const std::vector<StepperBody>& bodies) const {
  double greatest = 0, acceleration = 0;
  for (const StepperBody& body : bodies) {
    greatest = std::max(greatest, body.twist().v.norm() + body.reach() * body.twist().w.norm());
    acceleration = std::max(acceleration, scene_.motion->force_bound * body.inverse_mass());
  }
  return 2 * greatest + scene_.motion->sample_times.back() * (scene_.gravity.norm() + acceleration);
}

/// Approximately how far a point of the body may move in a step.
double ContactSearch::greatest_shift(const StepperBody& body, double h) const {
  const double speed = body.twist().v.norm() + body.reach() * body.twist().w.norm();
  const double acceleration =
      body.is_fixed() ? 0 : scene_.gravity.norm() + scene_.motion->force_bound * body.inverse_mass();
  return h * (speed + h * acceleration);
}

/// Bodies that have not moved since the last step are not queried again: where they touch, exact arithmetic decides.
const lin_canny::Proximity& ContactSearch::proximity(TrackedPair& tracked, const StepperBody& A,
                                                     const StepperBody& B) const {
  const Pose X_WA = A.pose(), X_WB = B.pose();
  if (!tracked.proximity || X_WA != tracked.X_WA || X_WB != tracked.X_WB) {
    tracked.X_WA = X_WA;
    tracked.X_WB = X_WB;
    tracked.proximity = proximity_of(A, B, tracked.walk);
  }
  return *tracked.proximity;
}

void ContactSearch::find(const std::vector<StepperBody>& bodies, int a, int b, double h, StepContacts& found) {
  const StepperBody &A = bodies[index(a)], &B = bodies[index(b)];
  if (A.is_fixed() && B.is_fixed()) return;
  const double reach = skin_ + greatest_shift(A, h) + greatest_shift(B, h);
  TrackedPair& tracked = tracked_[{a, b}];
  const lin_canny::Proximity& proximity = this->proximity(tracked, A, B);
  if (first_step_ && proximity.verdict == Verdict::overlapping) {
    throw InputError("bodies[" + std::to_string(b) + "]", "overlaps bodies[" + std::to_string(a) + "] at the start");
  }
  if (proximity.distance > reach) return;
  const contact::GapManifold manifold = gap_manifold(A.part(), B.part(), proximity, tracked.nhat_BA_W);
  tracked.seen = true;
  tracked.nhat_BA_W = manifold.nhat_BA_W;
  const Material &of_A = scene_.bodies[index(a)].material, &of_B = scene_.bodies[index(b)].material;
  ContactPair pair{&tracked, found.rows.size(), 0, a, b};
  for (contact::GapPoint point : manifold.points) {
    if (point.gap > reach) continue;
    point.p_WC += from_middle(A, B) * point.gap * manifold.nhat_BA_W;
    contact::ContactRow row;
    row.a = a;
    row.b = b;
    row.n = manifold.nhat_BA_W;
    row.arm_A = point.p_WC - A.centre();
    row.arm_B = point.p_WC - B.centre();
    row.friction = std::min(of_A.friction, of_B.friction);
    row.least_u_n = -std::max(point.gap - skin_, 0.0) / h;
    found.rows.push_back(row);
    found.points.push_back(point);
  }
  pair.count = found.rows.size() - pair.first;
  if (pair.count > 0) guess(pair, found);
  found.pairs.push_back(pair);
}

StepContacts ContactSearch::find(const std::vector<StepperBody>& bodies, double h) {
  for (auto& [ids, tracked] : tracked_) tracked.seen = false;
  boxes_.update();
  near_ = boxes_.pairs();
  std::ranges::sort(near_);
  StepContacts found;
  for (const BodyPair& pair : near_) find(bodies, static_cast<int>(pair.a), static_cast<int>(pair.b), h, found);
  first_step_ = false;
  return found;
}

Vec3 ContactSearch::normal(const ContactPair& pair, const std::vector<StepperBody>& bodies, std::size_t moved,
                           const Vec3& way) {
  const StepperBody there = bodies[moved].moved(way);
  const StepperBody& A = index(pair.a) == moved ? there : bodies[index(pair.a)];
  const StepperBody& B = index(pair.b) == moved ? there : bodies[index(pair.b)];
  const lin_canny::Proximity proximity = proximity_of(A, B, pair.tracked->walk);
  return gap_manifold(A.part(), B.part(), proximity, pair.tracked->nhat_BA_W).nhat_BA_W;
}

void ContactSearch::move(std::size_t body, const StepperBody& moved) {
  boxes_.move(static_cast<BodyId>(body), around(moved));
}

void ContactSearch::forget_distant() {
  std::erase_if(tracked_, [&](const auto& entry) {
    const BodyPair ids{static_cast<BodyId>(entry.first.first), static_cast<BodyId>(entry.first.second)};
    return !std::ranges::binary_search(near_, ids);
  });
}

}  // namespace touchstone::fast::constraint
