#include "fast/penetration/depth_bracket.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "fast/lin_canny/bracket.h"
#include "fast/mark.h"
#include "model/infinity.h"

namespace touchstone::fast::penetration {
namespace {

using lin_canny::PosedHull;
using lin_canny::VertexDifference;

// A kept polytope with more corners than that is dropped: most of them have sunk below the boundary. A choice.
constexpr int most_kept = 64;

/// The search at one pose.
class Search {
 public:
  Search(const PosedHull& A, const PosedHull& B, DepthMemory& memory)
      : A_(A), B_(B), polytope_(memory.polytope), error_(lin_canny::rounding(A, B)), margin_(error_ / 2) {
    if (!memory.n.isZero(0)) probe(memory.n);
  }

  /// Grows the polytope from the last one, or from four vertices.
  void run() {
    mark(Mark::depth);
    if (is_kept() && expand(true)) return;
    polytope_.clear();
    if (start()) expand(false);
  }

  DepthBracket result() const {
    DepthBracket found{0, best_, best_ + 4 * error_, n_};
    const double lo = polytope_.empty() ? 0 : polytope_.least_height() - 4 * error_;
    if (lo > 0 && polytope_.encloses_origin()) found.lo = lo;
    return found;
  }

 private:
  /// The vertex of M highest along n, a unit vector.
  VertexDifference probe(const Vec3& n) {
    VertexDifference highest = lowest(A_, B_, -n);
    const double height = n.dot(highest.w);
    if (height < best_) best_ = height, n_ = n;
    return highest;
  }

  bool is_kept() {
    if (polytope_.empty() || polytope_.corner_count() > most_kept) return false;
    polytope_.move(A_, B_);
    return polytope_.least_height() > 4 * error_;
  }

  /// Four vertices of M that are far apart: on a line, off that line, then off that plane; first along the line of the
  /// origins, where M is near 0. None if M is flat within rounding.
  bool start() {
    std::array<VertexDifference, 4> corners;
    double longest = 4 * error_, farthest = 4 * error_, highest = 4 * error_;
    const Vec3 between = (B_.t - A_.t).normalized();
    for (const Vec3& d : {between, Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
      if (d.isZero(0)) continue;
      const VertexDifference down = probe(-d), up = probe(d);
      if (const double length = (up.w - down.w).norm(); length > longest) {
        longest = length;
        corners[0] = up, corners[1] = down;
      }
      if (longest > far_enough()) break;
    }
    if (!(longest > 4 * error_)) return false;
    const Vec3 along = (corners[1].w - corners[0].w) / longest;
    int least = 0;
    along.cwiseAbs().minCoeff(&least);
    const Vec3 side = along.cross(Vec3::Unit(least)).normalized(), across = along.cross(side);
    for (const Vec3& d : {side, Vec3(-side), across, Vec3(-across)}) {
      const VertexDifference off = probe(d);
      if (const double far = along.cross(off.w - corners[0].w).norm(); far > farthest) {
        farthest = far;
        corners[2] = off;
      }
      if (farthest > far_enough()) break;
    }
    if (!(farthest > 4 * error_)) return false;
    const Vec3 n = along.cross(corners[2].w - corners[0].w).normalized();
    for (const Vec3& d : {n, Vec3(-n)}) {
      const VertexDifference off = probe(d);
      if (const double height = d.dot(off.w - corners[0].w); height > highest) {
        highest = height;
        corners[3] = off;
      }
      if (highest > far_enough()) break;
    }
    if (!(highest > 4 * error_)) return false;
    polytope_.start(A_, B_, corners);
    return true;
  }

  /// An extent of M with which the search for the first corners is content. A choice.
  double far_enough() const { return (A_.hull->radius() + B_.hull->radius()) / 8; }

  /// Returns false if the polytope was kept from another pose and does not grow well.
  bool expand(bool is_kept) {
    while (polytope_.corner_count() < most_corners) {
      const std::optional<int> face = polytope_.nearest_face();
      if (!face) return true;
      const auto [n, height, is_final] = polytope_.plane(*face);
      if (height >= best_ - margin_ || best_ < -error_) return true;
      mark(Mark::depth_step);
      const VertexDifference w = probe(n);
      const bool is_farther = n.dot(w.w) - height > margin_;
      const std::optional<double> least = is_farther ? polytope_.insert(w, *face, margin_) : std::nullopt;
      if (!least) polytope_.set_final(*face);
      if (least && is_kept && !(*least > 4 * error_)) return false;
    }
    return true;
  }

  const PosedHull& A_;
  const PosedHull& B_;
  InnerPolytope& polytope_;
  double error_;
  double margin_;  ///< of heights of the same corners, which have the same errors of their rotations. A choice
  double best_ = infinity;
  Vec3 n_ = Vec3::Zero();
};

}  // namespace

double height_along(const PosedHull& A, const PosedHull& B, const Vec3& n) { return n.dot(lowest(A, B, -n).w); }

DepthBracket depth_bracket(const PosedHull& A, const PosedHull& B, DepthMemory& memory) {
  Search search(A, B, memory);
  search.run();
  const DepthBracket found = search.result();
  memory.n = found.n;
  return found;
}

}  // namespace touchstone::fast::penetration
