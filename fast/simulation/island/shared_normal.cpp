#include "fast/simulation/island/shared_normal.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "fast/contact/parting.h"
#include "fast/mark.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double same_direction = 0x1p-40;  // difference of normals that are those of one face, up to rounding

class Sharing {
 public:
  Sharing(std::span<const ContactPair> pairs, const IslandBody& body_a, const IslandBody& body_b, double near)
      : pairs_(pairs), near_(near) {
    for (const ContactPair& pair : pairs) {
      A_.push_back(part_of(body_a, pair.part_a, body_a.state()));
      B_.push_back(part_of(body_b, pair.part_b, body_b.state()));
    }
  }

  /// Whether pair k could take over the normal of pair j, and how far apart k is along it (m).
  std::optional<double> apart_by(std::size_t k, std::size_t j) const {
    if (j == k || pairs_[j].contact_points.empty() || !may_take(k, j)) return {};
    const double wide = apart(A_[k], B_[k], pairs_[j].nhat_BA_W);
    return separates(wide, near_) ? std::optional(wide) : std::nullopt;
  }
  std::vector<contact::ContactPoint> points(std::size_t k, const Vec3& n) const {
    return points_along(A_[k], B_[k], n, near_);
  }

 private:
  bool may_take(std::size_t k, std::size_t j) const {
    const Vec3 &own = pairs_[k].nhat_BA_W, &other = pairs_[j].nhat_BA_W;
    if ((own - other).norm() <= same_direction) return false;
    return !separates(apart(A_[j], B_[j], own), near_);
  }
  std::span<const ContactPair> pairs_;
  std::vector<contact::Part> A_, B_;
  double near_;
};

void take_over(std::span<ContactPair> pairs, const IslandBody& body_a, const IslandBody& body_b, double near) {
  const Sharing sharing(pairs, body_a, body_b, near);
  std::vector<std::vector<std::optional<double>>> by(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    for (std::size_t j = 0; j < pairs.size(); ++j) by[k].push_back(sharing.apart_by(k, j));
  }
  std::vector<bool> keeps_its_own;
  for (const std::vector<std::optional<double>>& by_others : by)
    keeps_its_own.push_back(std::ranges::none_of(by_others, &std::optional<double>::has_value));
  const std::vector<ContactPair> own(pairs.begin(), pairs.end());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    std::optional<std::size_t> giver;
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      if (by[k][j] && keeps_its_own[j] && (!giver || *by[k][j] > *by[k][*giver])) giver = j;
    }
    if (!giver) continue;
    mark(Mark::shared_normal);
    pairs[k].shared = own[*giver].contact_points.front();
    pairs[k].nhat_BA_W = own[*giver].nhat_BA_W;
    pairs[k].contact_points = sharing.points(k, pairs[k].nhat_BA_W);
  }
}

}  // namespace

void share_normals(std::span<ContactPair> pairs, const IslandBody& body_a, const IslandBody& body_b, double near) {
  if (pairs.size() > 1) take_over(pairs, body_a, body_b, near);
  for (ContactPair& pair : pairs) {
    if (pair.contact_points.empty()) continue;
    pair.touched = true;
    pair.p_WC = candidate_at(pair, pair.contact_points.front(), body_a, body_b).touch.p_WC;
  }
}

}  // namespace touchstone::fast::simulation
