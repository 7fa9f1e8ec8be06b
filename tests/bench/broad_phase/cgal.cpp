#include <CGAL/box_intersection_d.h>

#include "tests/bench/broad_phase/contestant.h"

namespace touchstone::bench {
namespace {

using Box = CGAL::Box_intersection_d::Box_d<double, 3>;

Box boxed(Aabb box) { return {box.lo.data(), box.hi.data()}; }

/// CGAL keeps no state between frames.
class Cgal final : public Contestant {
 public:
  explicit Cgal(const std::vector<Aabb>& boxes) {
    for (const Aabb& box : boxes) boxes_.push_back(boxed(box));
    sorted_.reserve(boxes.size());
  }

  std::size_t pairs_after(const Frame& frame) override {
    for (const Change& change : frame) boxes_[change.body] = boxed(change.box);
    sorted_.clear();
    for (const Box& box : boxes_) sorted_.push_back(&box);
    std::size_t pairs = 0;
    CGAL::box_self_intersection_d(sorted_.begin(), sorted_.end(), [&](const Box*, const Box*) { ++pairs; });
    return pairs;
  }

 private:
  std::vector<Box> boxes_;
  std::vector<const Box*> sorted_;
};

}  // namespace

std::vector<Entrant> cgal() {
  return {{"cgal.box_intersection", true, "",
           [](const auto& boxes, const Aabb&) { return std::make_unique<Cgal>(boxes); }}};
}

}  // namespace touchstone::bench
