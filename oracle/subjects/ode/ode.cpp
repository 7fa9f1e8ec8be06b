#include "oracle/subjects/ode/ode.h"

#include <algorithm>
#include <cstdint>
#include <variant>

#include "oracle/subject.h"
#include "oracle/subjects/common/broad_phase_world.h"
#include "oracle/subjects/ode/input.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_ode;

struct MakeGeom {
  dSpaceID space;

  dGeomID operator()(const Polytope&) const { throw Declined(no_hulls); }
  dGeomID operator()(const Compound&) const { throw Declined(no_compounds.why); }
  dGeomID operator()(const auto& round_or_box) const { return geom(space, round_or_box); }
};

void note_pair(void* pairs, dGeomID a, dGeomID b) {
  const auto name = [](dGeomID geom) { return static_cast<int>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom))); };
  static_cast<PairSet*>(pairs)->push_back(std::minmax(name(a), name(b)));
}

class OdeWorld : public World {
 public:
  OdeWorld(dSpaceID space, const Scene& scene) : space_(space), scene_(scene), geoms_(scene.bodies.size()) {}
  ~OdeWorld() override { dSpaceDestroy(space_); }

  void put(int body, const Pose& X_WB) override {
    const auto i = static_cast<std::size_t>(body);
    geoms_[i] = std::visit(MakeGeom{space_}, scene_.bodies[i].shape);
    dGeomSetData(geoms_[i], reinterpret_cast<void*>(static_cast<std::intptr_t>(body)));
    move(body, X_WB);
  }

  void move(int body, const Pose& X_WB) override {
    const dGeomID geom = geoms_[static_cast<std::size_t>(body)];
    const Vec3& p = X_WB.p_WB;
    dGeomSetPosition(geom, real(p.x()), real(p.y()), real(p.z()));
    dGeomSetQuaternion(geom, turn(rotation(X_WB.q_WB)).data());
  }

  void take(int body) override { dGeomDestroy(geoms_[static_cast<std::size_t>(body)]); }

  PairFrame end_frame() override {
    PairFrame frame;
    dSpaceCollide(space_, &frame.pairs, note_pair);
    std::ranges::sort(frame.pairs);
    return frame;
  }

 private:
  dSpaceID space_;
  const Scene& scene_;
  std::vector<dGeomID> geoms_;
};

std::unique_ptr<Subject> space_subject(const std::string& name, const std::string& about, dSpaceID (*make_space)()) {
  return broad_phase_subject(
      in_ode::card(name, about + ", its settings as they come; boxes and spheres"),
      [make_space](const Scene& scene) { return std::make_unique<OdeWorld>(make_space(), scene); });
}

}  // namespace

std::unique_ptr<Subject> make_ode_simple() {
  return space_subject("simple", "dSimpleSpaceCreate", [] { return dSimpleSpaceCreate(nullptr); });
}

std::unique_ptr<Subject> make_ode_hash() {
  return space_subject("hash", "dHashSpaceCreate", [] { return dHashSpaceCreate(nullptr); });
}

std::unique_ptr<Subject> make_ode_quadtree() {
  return space_subject("quadtree", "dQuadTreeSpaceCreate about the origin, ±2048 m, 6 levels", [] {
    const dVector3 centre = {0, 0, 0};
    const dVector3 extents = {2048, 2048, 2048};
    return dQuadTreeSpaceCreate(nullptr, centre, extents, 6);
  });
}

std::unique_ptr<Subject> make_ode_sweep() {
  return space_subject("sweep", "dSweepAndPruneSpaceCreate, axes XYZ",
                       [] { return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ); });
}

}  // namespace touchstone::oracle::subjects
