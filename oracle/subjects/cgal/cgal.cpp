#include "oracle/subjects/cgal/cgal.h"

#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cmath>

#include "oracle/subject.h"
#include "oracle/subjects/common/broad_phase_world.h"
#include "oracle/truth/truth.h"

namespace touchstone::oracle::subjects {
namespace {

/// CGAL expects the boxes from its user. It gets the tightest boxes that doubles can represent, so every error in its
/// answer is its own.
Aabb tightest(Body body, const Pose& X_WB) {
  body.X_WB = X_WB;
  Scene alone;
  alone.bodies = {std::move(body)};
  const reference::ExactBox exact = truth::bounds(alone).front();
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    box.lo[i] = exact.lo[static_cast<std::size_t>(i)].enclosure().lo;
    box.hi[i] = exact.hi[static_cast<std::size_t>(i)].enclosure().hi;
  }
  if (!box.lo.allFinite() || !box.hi.allFinite()) throw Declined("a box is beyond the range of doubles");
  return box;
}

using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const int*>;

/// CGAL keeps no state between frames.
class CgalWorld : public World {
 public:
  explicit CgalWorld(const Scene& scene) : scene_(scene), boxes_(scene.bodies.size()), names_(scene.bodies.size()) {
    for (std::size_t i = 0; i < names_.size(); ++i) names_[i] = static_cast<int>(i);
  }

  void put(int body, const Pose& X_WB) override {
    const auto i = static_cast<std::size_t>(body);
    boxes_[i] = tightest(scene_.bodies[i], X_WB);
  }
  void move(int body, const Pose& X_WB) override { put(body, X_WB); }
  void take(int body) override { boxes_[static_cast<std::size_t>(body)].reset(); }

  PairFrame end_frame() override {
    std::vector<Box> there;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (boxes_[i]) there.emplace_back(boxes_[i]->lo.data(), boxes_[i]->hi.data(), &names_[i]);
    }
    PairFrame frame;
    CGAL::box_self_intersection_d(there.begin(), there.end(), [&](const Box& a, const Box& b) {
      frame.pairs.push_back(std::minmax(*a.handle(), *b.handle()));
    });
    std::ranges::sort(frame.pairs);
    return frame;
  }

 private:
  const Scene& scene_;
  std::vector<std::optional<Aabb>> boxes_;
  std::vector<int> names_;
};

}  // namespace

std::unique_ptr<Subject> make_cgal() {
  Card card;
  card.name = "cgal.box_intersection";
  card.version = CGAL_STR(CGAL_VERSION);
  card.about = "box_self_intersection_d, closed boxes, each the tightest of doubles; nothing is kept between frames";
  card.homepage = "https://www.cgal.org";
  return broad_phase_subject(std::move(card), [](const Scene& scene) { return std::make_unique<CgalWorld>(scene); });
}

}  // namespace touchstone::oracle::subjects
