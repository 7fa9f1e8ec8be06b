#include "oracle/subjects/ode.h"

#include <ode/ode.h>

#include <algorithm>
#include <cstdint>
#include <variant>

#include "oracle/subjects/broad_phase_world.h"
#include "oracle/subjects/engine.h"

namespace touchstone::oracle::subjects {
namespace {

constexpr bool is_double = sizeof(dReal) == sizeof(double);

dReal real(double x) { return static_cast<dReal>(x); }

struct MakeGeom {
  dSpaceID space;

  dGeomID operator()(const Sphere& sphere) const { return dCreateSphere(space, real(sphere.radius)); }
  dGeomID operator()(const Box& box) const {
    const Vec3 sides = 2 * box.half_extents;
    return dCreateBox(space, real(sides.x()), real(sides.y()), real(sides.z()));
  }
  dGeomID operator()(const Polytope&) const { throw Declined("ODE's convex wants planes that its user computes"); }
  dGeomID operator()(const Compound&) const { throw Declined(no_compounds.why); }
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
    const Eigen::Quaterniond q = unit_quaternion(X_WB.q_WB);
    const dQuaternion turn = {real(q.w()), real(q.x()), real(q.y()), real(q.z())};
    dGeomSetPosition(geom, real(p.x()), real(p.y()), real(p.z()));
    dGeomSetQuaternion(geom, turn);
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

struct Library {
  Library() { dInitODE(); }
  ~Library() { dCloseODE(); }
};

std::unique_ptr<Subject> space_subject(const std::string& name, const std::string& about, dSpaceID (*make_space)()) {
  static const Library library;
  Card card;
  card.name = "ode." + name;
  card.version = dODE_VERSION;
  card.precision = is_double ? Precision::binary64 : Precision::binary32;
  card.about = about + ", its settings as they come; boxes and spheres";
  card.homepage = "https://ode.org";
  return broad_phase_subject(
      std::move(card), [make_space](const Scene& scene) { return std::make_unique<OdeWorld>(make_space(), scene); });
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
