// Bullet in single precision, as most users get it from packages.
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include "tests/bench/broad_phase/contestant.h"

namespace touchstone::bench {
namespace {

btVector3 bt(const Vec3& p) {
  return {static_cast<btScalar>(p.x()), static_cast<btScalar>(p.y()), static_cast<btScalar>(p.z())};
}

class Bullet final : public Contestant {
 public:
  Bullet(std::unique_ptr<btBroadphaseInterface> broad_phase, const std::vector<Aabb>& boxes)
      : broad_phase_(std::move(broad_phase)) {
    for (const Aabb& box : boxes)
      proxies_.push_back(broad_phase_->createProxy(bt(box.lo), bt(box.hi), 0, nullptr, 1, 1, nullptr));
    broad_phase_->calculateOverlappingPairs(nullptr);
  }

  ~Bullet() override {
    for (btBroadphaseProxy* proxy : proxies_) broad_phase_->destroyProxy(proxy, nullptr);
  }

  std::size_t pairs_after(const Frame& frame) override {
    for (const Change& change : frame)
      broad_phase_->setAabb(proxies_[change.body], bt(change.box.lo), bt(change.box.hi), nullptr);
    broad_phase_->calculateOverlappingPairs(nullptr);
    return static_cast<std::size_t>(broad_phase_->getOverlappingPairCache()->getNumOverlappingPairs());
  }

 private:
  std::unique_ptr<btBroadphaseInterface> broad_phase_;
  std::vector<btBroadphaseProxy*> proxies_;
};

}  // namespace

std::vector<Entrant> bullet() {
  return {
      {"bullet.dbvt", true, "",
       [](const auto& boxes, const Aabb&) {
         return std::make_unique<Bullet>(std::make_unique<btDbvtBroadphase>(), boxes);
       }},
      {"bullet.axis_sweep", true, "",
       [](const auto& boxes, const Aabb& world) {
         const auto handles = static_cast<unsigned>(boxes.size() + 2);
         return std::make_unique<Bullet>(
             std::make_unique<bt32BitAxisSweep3>(bt(world.lo), bt(world.hi), handles, nullptr, true), boxes);
       }},
  };
}

}  // namespace touchstone::bench
