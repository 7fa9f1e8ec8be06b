#include "oracle/subjects/bullet/broad_phase.h"

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/sequence.h"
#include "oracle/subject.h"
#include "oracle/subjects/bullet/input.h"
#include "oracle/subjects/common/broad_phase_world.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_bullet;
using Structure = std::unique_ptr<btBroadphaseInterface>;

class BulletWorld : public World {
 public:
  BulletWorld(Structure structure, const Scene& scene)
      : dispatcher_(&configuration_),
        structure_(std::move(structure)),
        names_(scene.bodies.size()),
        proxies_(scene.bodies.size()) {
    std::iota(names_.begin(), names_.end(), 0);
    for (const Body& body : scene.bodies) shapes_.push_back(std::visit(MakeShape{}, body.shape));
  }

  ~BulletWorld() override {
    for (int body : names_) {
      if (proxies_[static_cast<std::size_t>(body)] != nullptr) take(body);
    }
  }

  void put(int body, const Pose& X_WB) override {
    const auto i = static_cast<std::size_t>(body);
    const auto [lo, hi] = box(i, X_WB);
    proxies_[i] = structure_->createProxy(lo, hi, shapes_[i]->getShapeType(), &names_[i],
                                          btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter, &dispatcher_);
  }

  void move(int body, const Pose& X_WB) override {
    const auto i = static_cast<std::size_t>(body);
    const auto [lo, hi] = box(i, X_WB);
    structure_->setAabb(proxies_[i], lo, hi, &dispatcher_);
  }

  void take(int body) override {
    btBroadphaseProxy*& proxy = proxies_[static_cast<std::size_t>(body)];
    structure_->destroyProxy(proxy, &dispatcher_);
    proxy = nullptr;
  }

  PairFrame end_frame() override {
    structure_->calculateOverlappingPairs(&dispatcher_);
    PairFrame frame;
    const btBroadphasePairArray& found = structure_->getOverlappingPairCache()->getOverlappingPairArray();
    for (int i = 0; i < found.size(); ++i) {
      const auto name = [](const btBroadphaseProxy* proxy) { return *static_cast<const int*>(proxy->m_clientObject); };
      frame.pairs.push_back(std::minmax(name(found[i].m_pProxy0), name(found[i].m_pProxy1)));
    }
    std::ranges::sort(frame.pairs);
    return frame;
  }

 private:
  std::pair<btVector3, btVector3> box(std::size_t i, const Pose& X_WB) const {
    std::pair<btVector3, btVector3> box;
    shapes_[i]->getAabb(transform(X_WB), box.first, box.second);
    return box;
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  Structure structure_;
  std::vector<int> names_;
  std::vector<ConvexPtr> shapes_;
  std::vector<btBroadphaseProxy*> proxies_;
};

void refuse_compounds(const Scene& scene) {
  if (has_compound(scene)) throw Declined(no_compounds.why);
}

/// m. Bullet's user fixes the extent of the world when the structure is made.
constexpr double world_half_size = 2048;

void refuse_beyond_world(const Scene& scene) {
  const auto inside = [](const Vec3& p) { return p.cwiseAbs().maxCoeff() <= world_half_size; };
  const auto fits = [&](const Body& body, const Pose& X_WB) {
    btVector3 lo;
    btVector3 hi;
    std::visit(MakeShape{}, body.shape)->getAabb(transform(X_WB), lo, hi);
    return inside(vec3(lo)) && inside(vec3(hi));
  };
  for (const Body& body : scene.bodies) {
    if (!is_sequence(scene) && !fits(body, body.X_WB))
      throw Declined("a body is outside the world bounds that the axis sweep was created with");
  }
  for (const Places& frame : places(scene)) {
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (frame[i] && !fits(scene.bodies[i], *frame[i]))
        throw Declined("a body is outside the world bounds that the axis sweep was created with");
    }
  }
}

Card card(const std::string& name, double margin, const std::string& about, std::vector<Deviation> deviations) {
  Card made;
  made.name = name;
  made.version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
  made.precision = is_double ? Precision::binary64 : Precision::binary32;
  made.broad_phase_margin = margin;
  made.boxes = BoxKind::of_turned_box;  // getAabb turns the box about a hull
  made.domain = domain();
  made.about = about;
  made.homepage = "https://github.com/bulletphysics/bullet3";
  made.deviations = std::move(deviations);
  return made;
}

}  // namespace

/// A box that has moved is stored with a margin of 0.05 m on each side (gDbvtMargin) and stays until the true box
/// leaves it. The true box may then be up to 0.1 m inside the stored one on one side.
std::unique_ptr<Subject> make_bullet_dbvt() {
  return broad_phase_subject(
      card("bullet.dbvt", 0.1, "btDbvtBroadphase as it comes; boxes by getAabb, shapes' margins 0",
           {{"TS-BROAD-PHASE-10", "a pair that ended stays until cleaned up: at least one, and 10 % of all, a frame",
             ""},
            {"TS-BROAD-PHASE-10", "the stored box of a body that turned may be wider than the margin", ""}}),
      [](const Scene& scene) {
        refuse_compounds(scene);
        return std::make_unique<BulletWorld>(std::make_unique<btDbvtBroadphase>(), scene);
      });
}

/// End points are integers, with 2^31 - 1 steps over 4096 m (2^-19 m a step). A coordinate is rounded down; then its
/// lowest bit marks the end, 0 for lo and 1 for hi. So hi rises by at most 1 step and lo falls by less than 2, which
/// are 2^-18 m.
std::unique_ptr<Subject> make_bullet_axis_sweep() {
  return broad_phase_subject(
      card("bullet.axis_sweep", std::ldexp(1.0, -18), "bt32BitAxisSweep3 in a world of ±2048 m, boxes by getAabb", {}),
      [](const Scene& scene) {
        refuse_compounds(scene);
        refuse_beyond_world(scene);
        const btVector3 corner(scalar(world_half_size), scalar(world_half_size), scalar(world_half_size));
        const auto handles = static_cast<unsigned>(scene.bodies.size() + 2);
        return std::make_unique<BulletWorld>(std::make_unique<bt32BitAxisSweep3>(-corner, corner, handles), scene);
      });
}

}  // namespace touchstone::oracle::subjects
