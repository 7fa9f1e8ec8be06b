#include <fcl/broadphase/broadphase_SSaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/broadphase/broadphase_interval_tree.h>
#include <fcl/broadphase/broadphase_spatialhash.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include "tests/bench/broad_phase/contestant.h"

namespace touchstone::bench {
namespace {

bool count(::fcl::CollisionObjectd*, ::fcl::CollisionObjectd*, void* pairs) {
  ++*static_cast<std::size_t*>(pairs);
  return false;
}

using Manager = ::fcl::BroadPhaseCollisionManagerd;

class Fcl final : public Contestant {
 public:
  Fcl(std::unique_ptr<Manager> manager, const std::vector<Aabb>& boxes) : manager_(std::move(manager)) {
    std::vector<::fcl::CollisionObjectd*> all;
    for (const Aabb& box : boxes) {
      shapes_.push_back(std::make_shared<::fcl::Boxd>(1, 1, 1));
      objects_.push_back(std::make_unique<::fcl::CollisionObjectd>(shapes_.back()));
      place(objects_.size() - 1, box);
      all.push_back(objects_.back().get());
    }
    manager_->registerObjects(all);
    manager_->setup();
  }

  std::size_t pairs_after(const Frame& frame) override {
    moved_.clear();
    for (const Change& change : frame) {
      place(change.body, change.box);
      moved_.push_back(objects_[change.body].get());
    }
    if (moved_.size() == objects_.size())
      manager_->update();
    else
      manager_->update(moved_);
    std::size_t pairs = 0;
    manager_->collide(&pairs, count);
    return pairs;
  }

 private:
  void place(std::size_t body, const Aabb& box) {
    const Vec3 half = (box.hi - box.lo) / 2;
    shapes_[body]->aabb_local = ::fcl::AABBd(-half, half);
    shapes_[body]->aabb_center.setZero();
    objects_[body]->setTranslation((box.lo + box.hi) / 2);
    objects_[body]->computeAABB();
  }

  std::vector<std::shared_ptr<::fcl::Boxd>> shapes_;
  std::vector<std::unique_ptr<::fcl::CollisionObjectd>> objects_;
  std::vector<::fcl::CollisionObjectd*> moved_;
  std::unique_ptr<Manager> manager_;
};

template <class M>
Entrant entrant(const std::string& name) {
  return {name, true, "",
          [](const auto& boxes, const Aabb&) { return std::make_unique<Fcl>(std::make_unique<M>(), boxes); }};
}

/// The user chooses the cell size: here twice the mean extent.
std::unique_ptr<Contestant> spatial_hash(const std::vector<Aabb>& boxes, const Aabb& world) {
  double mean = 0;
  for (const Aabb& box : boxes) mean += (box.hi - box.lo).mean() / static_cast<double>(boxes.size());
  return std::make_unique<Fcl>(
      std::make_unique<::fcl::SpatialHashingCollisionManager<double>>(2 * mean, world.lo, world.hi), boxes);
}

}  // namespace

/// Omits the naive manager, and SaPCollisionManager, whose update() does not return on the coherent workload.
std::vector<Entrant> fcl_managers() {
  return {entrant<::fcl::DynamicAABBTreeCollisionManagerd>("fcl.dynamic_tree"),
          entrant<::fcl::DynamicAABBTreeCollisionManager_Array<double>>("fcl.dynamic_tree_array"),
          entrant<::fcl::IntervalTreeCollisionManagerd>("fcl.interval_tree"),
          entrant<::fcl::SSaPCollisionManagerd>("fcl.ssap"),
          {"fcl.spatial_hash", true, "", spatial_hash}};
}

}  // namespace touchstone::bench
