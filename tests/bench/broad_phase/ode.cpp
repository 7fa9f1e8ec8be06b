#include <ode/ode.h>

#include "tests/bench/broad_phase/contestant.h"

namespace touchstone::bench {
namespace {

void count(void* pairs, dGeomID, dGeomID) { ++*static_cast<std::size_t*>(pairs); }

class Ode final : public Contestant {
 public:
  Ode(dSpaceID space, const std::vector<Aabb>& boxes) : space_(space) {
    for (const Aabb& box : boxes) {
      geoms_.push_back(dCreateBox(space_, 1, 1, 1));
      place(geoms_.size() - 1, box);
    }
    pairs_after({});
  }

  ~Ode() override { dSpaceDestroy(space_); }

  std::size_t pairs_after(const Frame& frame) override {
    for (const Change& change : frame) place(change.body, change.box);
    std::size_t pairs = 0;
    dSpaceCollide(space_, &pairs, count);
    return pairs;
  }

 private:
  void place(std::size_t body, const Aabb& box) {
    const Vec3 side = box.hi - box.lo;
    const Vec3 centre = (box.lo + box.hi) / 2;
    dGeomBoxSetLengths(geoms_[body], static_cast<dReal>(side.x()), static_cast<dReal>(side.y()),
                       static_cast<dReal>(side.z()));
    dGeomSetPosition(geoms_[body], static_cast<dReal>(centre.x()), static_cast<dReal>(centre.y()),
                     static_cast<dReal>(centre.z()));
  }

  dSpaceID space_;
  std::vector<dGeomID> geoms_;
};

struct Library {
  Library() { dInitODE(); }
  ~Library() { dCloseODE(); }
};

}  // namespace

std::vector<Entrant> ode_spaces() {
  static const Library library;
  return {{"ode.hash", true, "",
           [](const auto& boxes, const Aabb&) { return std::make_unique<Ode>(dHashSpaceCreate(nullptr), boxes); }},
          {"ode.sap", true, "", [](const auto& boxes, const Aabb&) {
             return std::make_unique<Ode>(dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ), boxes);
           }}};
}

}  // namespace touchstone::bench
