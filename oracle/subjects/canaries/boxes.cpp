// Canaries that lie about bounding boxes and the pairs of overlapping boxes.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "model/infinity.h"
#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {
namespace {

Lies boxes(Lie<Bounds> lie) {
  Lies lies;
  lies.bounds = std::move(lie);
  return lies;
}

Lies each_box(const std::function<void(Aabb&)>& lie) {
  return boxes([lie](Subject&, const Scene&, Bounds& said) { std::ranges::for_each(said, lie); });
}

// The same lie for a single scene and for every frame of a sequence.
Lies pair_sets(void (*lie)(PairSet&)) {
  Lies lies;
  lies.broad_phase = [lie](Subject&, const Scene&, PairSet& said) { lie(said); };
  lies.pair_history = [lie](Subject&, const Scene&, PairHistory& said) {
    for (PairFrame& frame : said) lie(frame.pairs);
  };
  return lies;
}

Lies pairs(Lie<PairSet> lie) {
  Lies lies;
  lies.broad_phase = std::move(lie);
  return lies;
}

// Removes or adds pairs by a rule that reads their true boxes.
Lies pairs_where(const std::function<bool(const Aabb&, const Aabb&)>& rule) {
  return pairs([rule](Subject& truthful, const Scene& scene, PairSet& said) {
    with(truthful.bounds(scene), [&](const Bounds& box) {
      said.clear();
      for (std::size_t i = 0; i < box.size(); ++i) {
        for (std::size_t j = i + 1; j < box.size(); ++j) {
          if (rule(box[i], box[j])) said.emplace_back(static_cast<int>(i), static_cast<int>(j));
        }
      }
    });
  });
}

void unrotated(Subject&, const Scene& scene, Bounds& said) {
  for (std::size_t i = 0; i < said.size(); ++i) {
    Eigen::AlignedBox3d box;
    for (const Vec3& corner : corners(scene.bodies[i])) box.extend(Vec3(corner + scene.bodies[i].X_WB.p_WB));
    said[i] = {box.min(), box.max()};
  }
}

void neighbours(Subject&, const Scene& scene, Bounds& said) {
  for (Aabb& box : said) box.hi.x() += 1e-12 * scene.bodies.front().X_WB.p_WB.cwiseAbs().sum();
}

void slightly_wide(Subject&, const Scene& scene, Bounds& said) {
  for (Aabb& box : said) box.hi.x() += 832 * rounding_of_length(scene);
}

void phantom(Subject&, const Scene& scene, PairSet& said) {
  if (scene.bodies.size() < 2 || (!said.empty() && said.front() == std::pair(0, 1))) return;
  said.insert(said.begin(), {0, 1});
}

void last_body_lost(Subject&, const Scene& scene, PairSet& said) {
  const int last = static_cast<int>(scene.bodies.size()) - 1;
  std::erase_if(said, [last](const auto& pair) { return pair.second == last; });
}

bool overlap_inside(const Aabb& a, const Aabb& b) {
  return (a.lo.array() < b.hi.array()).all() && (b.lo.array() < a.hi.array()).all();
}

bool overlap_in_plane(const Aabb& a, const Aabb& b) {
  return (a.lo.array() <= b.hi.array()).head<2>().all() && (b.lo.array() <= a.hi.array()).head<2>().all();
}

}  // namespace

std::vector<Canary> canaries_about_boxes() {
  return {
      lying("canary.box_unrotated", "moves a body's box and forgets to turn it", [] { return boxes(unrotated); }),
      lying("canary.box_one_ulp_inward", "rounds one side of each box inward",
            [] { return each_box([](Aabb& box) { box.hi.x() = std::nextafter(box.hi.x(), -infinity); }); }),
      lying("canary.box_twice_as_wide", "makes each box twice as wide",
            [] {
              return each_box([](Aabb& box) {
                const Vec3 half = (box.hi - box.lo) / 2;
                box = {box.lo - half, box.hi + half};
              });
            }),
      lying("canary.box_inside_out", "exchanges lo and hi",
            [] { return each_box([](Aabb& box) {
                   box = {box.hi, box.lo};
                 }); }),
      lying("canary.box_of_neighbours", "lets the first body's place leak into every box",
            [] { return boxes(neighbours); }),
      lying("canary.slightly_wide", "makes each box wider by four times what rounding explains",
            [] { return boxes(slightly_wide); }),
      lying("canary.open_intervals", "misses pairs whose boxes only touch", [] { return pairs_where(overlap_inside); }),
      lying("canary.two_axes_only", "compares boxes on x and y alone", [] { return pairs_where(overlap_in_plane); }),
      lying("canary.last_body_lost", "never compares the last body", [] { return pairs(last_body_lost); }),
      lying("canary.phantom_pair", "reports the first two bodies, near or not", [] { return pairs(phantom); }),
      lying("canary.pair_order", "reports (j, i) for (i, j)",
            [] {
              return pair_sets([](PairSet& said) {
                for (auto& [i, j] : said) std::swap(i, j);
              });
            }),
      lying("canary.duplicate_pair", "reports the first pair twice",
            [] {
              return pair_sets([](PairSet& said) {
                if (!said.empty()) said.insert(said.begin(), said.front());
              });
            }),
  };
}

}  // namespace touchstone::oracle::subjects
