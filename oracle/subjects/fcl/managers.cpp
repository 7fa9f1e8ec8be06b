#include "oracle/subjects/fcl/managers.h"

#include <fcl/broadphase/broadphase_SSaP.h>
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_bruteforce.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/broadphase/broadphase_interval_tree.h>
#include <fcl/broadphase/broadphase_spatialhash.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "model/input_error.h"
#include "oracle/subject.h"
#include "oracle/subjects/common/broad_phase_world.h"
#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/fcl/input.h"
#include "oracle/tolerance/tolerance.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_fcl;
using Manager = std::unique_ptr<::fcl::BroadPhaseCollisionManagerd>;
using Object = ::fcl::CollisionObjectd;

/// The spatial hash calls back for all objects that share a cell or a key, however far apart: a callback is expected to
/// look closer. The other managers have compared the boxes, so for them the comparison changes nothing.
bool note_pair(Object* a, Object* b, void* pairs) {
  const auto name = [](const Object* object) { return *static_cast<const int*>(object->getUserData()); };
  if (a->getAABB().overlap(b->getAABB())) static_cast<PairSet*>(pairs)->push_back(std::minmax(name(a), name(b)));
  return false;  // continue the traversal
}

class FclWorld : public World {
 public:
  FclWorld(Manager manager, const Scene& scene)
      : manager_(std::move(manager)), scene_(scene), names_(scene.bodies.size()), objects_(scene.bodies.size()) {
    if (has_compound(scene)) throw Declined(no_compounds.why);
    std::iota(names_.begin(), names_.end(), 0);
  }

  void put(int body, const Pose& X_WB) override {
    const auto i = static_cast<std::size_t>(body);
    const Geometry geometry = std::visit(MakeGeometry{}, scene_.bodies[i].shape);
    objects_[i] = std::make_unique<Object>(geometry, transform(X_WB));
    objects_[i]->setUserData(&names_[i]);
    new_.push_back(objects_[i].get());
  }

  void move(int body, const Pose& X_WB) override {
    Object* object = objects_[static_cast<std::size_t>(body)].get();
    object->setTransform(transform(X_WB));
    object->computeAABB();
    moved_ = true;
  }

  void take(int body) override {
    std::unique_ptr<Object>& object = objects_[static_cast<std::size_t>(body)];
    manager_->unregisterObject(object.get());
    object.reset();
  }

  PairFrame end_frame() override {
    if (!new_.empty()) manager_->registerObjects(new_);
    manager_->setup();
    if (moved_) manager_->update();
    new_.clear();
    moved_ = false;
    PairFrame frame;
    manager_->collide(&frame.pairs, note_pair);
    std::ranges::sort(frame.pairs);
    return frame;
  }

 private:
  Manager manager_;
  const Scene& scene_;
  std::vector<int> names_;
  std::vector<std::unique_ptr<Object>> objects_;
  std::vector<Object*> new_;  ///< added in this frame
  bool moved_ = false;
};

template <class M>
Manager made(const Scene&) {
  return std::make_unique<M>();
}

/// The user chooses the cell size and the world's extent: here, a cell as large as the largest body, and a world that
/// contains all bodies. SpatialHash numbers the cells in 32 bits, so there are some 2⁹ at most along an axis.
Manager spatial_hash(const Scene& scene) {
  double radius = 0, furthest = 0;
  for (const Body& body : scene.bodies) {
    radius = std::max(radius, tolerance::radius(body));
    furthest = std::max(furthest, body.X_WB.p_WB.cwiseAbs().maxCoeff());
  }
  for (const SequenceFrame& frame : scene.frames) {
    for (const Placement& placement : frame) {
      if (placement.X_WB) furthest = std::max(furthest, placement.X_WB->p_WB.cwiseAbs().maxCoeff());
    }
  }
  const double cell = radius > 0 ? std::max(2 * radius, furthest / 0x1p8) : 1;
  const Vec3 corner = Vec3::Constant(furthest + cell);
  return std::make_unique<::fcl::SpatialHashingCollisionManager<double>>(cell, -corner, corner);
}

struct Entry {
  std::string about;
  Manager (*make)(const Scene&);
};

const std::map<std::string, Entry>& managers() {
  static const std::map<std::string, Entry> all = {
      {"naive", {"NaiveCollisionManager", made<::fcl::NaiveCollisionManagerd>}},
      {"sap", {"SaPCollisionManager", made<::fcl::SaPCollisionManagerd>}},
      {"ssap", {"SSaPCollisionManager", made<::fcl::SSaPCollisionManagerd>}},
      {"interval_tree", {"IntervalTreeCollisionManager", made<::fcl::IntervalTreeCollisionManagerd>}},
      {"spatial_hash",
       {"SpatialHashingCollisionManager, a cell as large as the largest body or 1/512 of the world, boxes compared in "
        "the callback",
        spatial_hash}},
      {"dynamic_tree", {"DynamicAABBTreeCollisionManager", made<::fcl::DynamicAABBTreeCollisionManagerd>}},
      {"dynamic_tree_array",
       {"DynamicAABBTreeCollisionManager_Array", made<::fcl::DynamicAABBTreeCollisionManager_Array<double>>}}};
  return all;
}

}  // namespace

std::unique_ptr<Subject> make_fcl_manager(const std::string& name) {
  const auto found = managers().find(name);
  if (found == managers().end()) throw InputError("FCL manager " + name, "unknown");
  Card card;
  card.name = "fcl." + name;
  card.version = FCL_VERSION;
  card.about =
      found->second.about + ", FCL's own settings; a frame ends with registerObjects(new), setup() and update()";
  card.homepage = "https://github.com/flexible-collision-library/fcl";
  card.domain = customary_domain();
  card.boxes = BoxKind::of_ball;  // CollisionObject::computeAABB of a rotated object; also FCL's issue 509
  return broad_phase_subject(std::move(card), [make = found->second.make](const Scene& scene) {
    return std::make_unique<FclWorld>(make(scene), scene);
  });
}

}  // namespace touchstone::oracle::subjects
