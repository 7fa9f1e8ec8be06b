#include "fast/contact/sparse/twist_system.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "fast/contact/cross_matrix.h"

namespace touchstone::fast::contact {
namespace {

/// Adds sign · GᵀWG of two arms: G = (1, −[r]×), Gᵀ = (1; [r]×).
template <class Block>
void add_coupling(const Mat3& W, const Mat3& R_at, const Mat3& R_by, double sign, Block& block) {
  const Mat3 W_signed = sign * W, turned = W_signed * R_by;
  block.template topLeftCorner<3, 3>() += W_signed;
  block.template topRightCorner<3, 3>() -= turned;
  block.template bottomLeftCorner<3, 3>() += R_at * W_signed;
  block.template bottomRightCorner<3, 3>() -= R_at * turned;
}

}  // namespace

TwistSystem::TwistSystem(const std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies)
    : rows_(rows), bodies_(bodies), slot_(bodies.size(), fixed), reach_(bodies.size(), 0.0) {
  std::vector<std::vector<int>> neighbours(bodies.size());
  for (const ContactRow& row : rows) {
    reach_[index(row.a)] = std::max(reach_[index(row.a)], row.arm_A.norm());
    reach_[index(row.b)] = std::max(reach_[index(row.b)], row.arm_B.norm());
    if (bodies[index(row.a)].inverse_mass == 0 || bodies[index(row.b)].inverse_mass == 0) continue;
    neighbours[index(row.a)].push_back(row.b);
    neighbours[index(row.b)].push_back(row.a);
  }
  for (std::vector<int>& some : neighbours) {
    std::ranges::sort(some);
    some.erase(std::unique(some.begin(), some.end()), some.end());
  }
  order(std::move(neighbours));
  for (const int body : body_of_) inertia_.push_back(bodies[index(body)].inverse_inertia.inverse());
  pivots_.resize(body_of_.size());
  below_.resize(later_.size());
  above_.resize(later_.size());
}

/// Eliminates the body with the fewest neighbours, the first of several, and connects these with one another.
void TwistSystem::order(std::vector<std::vector<int>> neighbours) {
  std::set<std::pair<std::size_t, int>> left;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].inverse_mass > 0) left.insert({neighbours[i].size(), static_cast<int>(i)});
  }
  std::vector<std::vector<int>> connected;
  while (!left.empty()) {
    const int body = left.begin()->second;
    left.erase(left.begin());
    slot_[index(body)] = static_cast<int>(body_of_.size());
    body_of_.push_back(body);
    const std::vector<int>& around = connected.emplace_back(std::move(neighbours[index(body)]));
    for (const int other : around) {
      std::vector<int>& its = neighbours[index(other)];
      left.erase({its.size(), other});
      std::vector<int> joined;
      std::ranges::set_union(its, around, std::back_inserter(joined));
      std::erase_if(joined, [=](int i) { return i == body || i == other; });
      its = std::move(joined);
      left.insert({its.size(), other});
    }
  }
  for (const std::vector<int>& around : connected) {
    first_.push_back(later_.size());
    for (const int other : around) later_.push_back(slot(other));
    std::sort(later_.begin() + static_cast<std::ptrdiff_t>(first_.back()), later_.end());
  }
  first_.push_back(later_.size());
}

std::size_t TwistSystem::entry(int earlier, int later) const {
  const auto begin = later_.begin() + static_cast<std::ptrdiff_t>(first_[index(earlier)]),
             end = later_.begin() + static_cast<std::ptrdiff_t>(first_[index(earlier) + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, later) - later_.begin());
}

void TwistSystem::Pivot::factor(double reach) {
  Segment arm = Segment::Ones();
  if (reach > 0) arm.tail<3>().setConstant(reach);
  for (int k = 0; k < 6; ++k) {
    int best = k;
    for (int i = k + 1; i < 6; ++i) {
      if (std::abs(block(i, k)) / arm[i] > std::abs(block(best, k)) / arm[best]) best = i;
    }
    exchanged[k] = best;
    if (best != k) {
      block.row(k).swap(block.row(best));
      std::swap(arm[k], arm[best]);
    }
    for (int i = k + 1; i < 6; ++i) {
      const double share = block(i, k) /= block(k, k);
      for (int j = k + 1; j < 6; ++j) block(i, j) -= share * block(k, j);
    }
  }
}

void TwistSystem::Pivot::solve(double* column) const {
  for (int k = 0; k < 6; ++k) std::swap(column[k], column[exchanged[k]]);
  for (int k = 0; k < 6; ++k) {
    for (int i = k + 1; i < 6; ++i) column[i] -= block(i, k) * column[k];
  }
  for (int k = 5; k >= 0; --k) {
    column[k] /= block(k, k);
    for (int i = 0; i < k; ++i) column[i] -= block(i, k) * column[k];
  }
}

void TwistSystem::factor(double mass_share, const std::vector<Mat3>& stiffness) {
  for (std::size_t i = 0; i < pivots_.size(); ++i) {
    Block& block = pivots_[i].block;
    block.setZero();
    block.diagonal().head<3>().setConstant(mass_share / bodies_[index(body_of_[i])].inverse_mass);
    block.bottomRightCorner<3, 3>() = mass_share * inertia_[i];
  }
  for (std::size_t i = 0; i < later_.size(); ++i) {
    below_[i].setZero();
    above_[i].setZero();
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Mat3& W = stiffness[i];
    if (W.isZero(0)) continue;
    const ContactRow& row = rows_[i];
    const int a = slot(row.a), b = slot(row.b);
    const Mat3 R_A = cross_matrix(row.arm_A), R_B = cross_matrix(row.arm_B);
    if (a != fixed) add_coupling(W, R_A, R_A, 1, pivots_[index(a)].block);
    if (b != fixed) add_coupling(W, R_B, R_B, 1, pivots_[index(b)].block);
    if (a == fixed || b == fixed) continue;
    const std::size_t between = entry(std::min(a, b), std::max(a, b));
    add_coupling(W, R_A, R_B, -1, a < b ? above_[between] : below_[between]);
    add_coupling(W, R_B, R_A, -1, a < b ? below_[between] : above_[between]);
  }
  for (std::size_t k = 0; k < pivots_.size(); ++k) {
    pivots_[k].factor(reach_[index(body_of_[k])]);
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) {
      for (int column = 0; column < 6; ++column) pivots_[k].solve(above_[i].col(column).data());
    }
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) {
      for (std::size_t j = first_[k]; j < first_[k + 1]; ++j) {
        const int row = later_[i], column = later_[j];
        Block& target = row == column  ? pivots_[index(row)].block
                        : row < column ? above_[entry(row, column)]
                                       : below_[entry(column, row)];
        target.noalias() -= below_[i].lazyProduct(above_[j]);
      }
    }
  }
}

TwistSystem::Vector TwistSystem::solve(Vector b) const {
  const auto part = [&](int place) { return b.segment<6>(6 * place); };
  for (std::size_t k = 0; k < pivots_.size(); ++k) {
    double* const mine = b.data() + 6 * k;
    pivots_[k].solve(mine);
    const Segment solved = part(static_cast<int>(k));
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) part(later_[i]) -= below_[i].lazyProduct(solved);
  }
  for (std::size_t k = pivots_.size(); k-- > 0;) {
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) {
      const Segment solved = part(later_[i]);
      part(static_cast<int>(k)) -= above_[i].lazyProduct(solved);
    }
  }
  return b;
}

TwistSystem::Vector TwistSystem::momentum(const Vector& twists) const {
  Vector all = zero();
  for (std::size_t i = 0; i < body_of_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(6 * i);
    all.segment<3>(at) = twists.segment<3>(at) / bodies_[index(body_of_[i])].inverse_mass;
    all.segment<3>(at + 3) = inertia_[i] * twists.segment<3>(at + 3);
  }
  return all;
}

TwistSystem::Vector TwistSystem::response(const Vector& wrenches) const {
  Vector all = zero();
  for (std::size_t i = 0; i < body_of_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(6 * i);
    const Mobility& body = bodies_[index(body_of_[i])];
    all.segment<3>(at) = body.inverse_mass * wrenches.segment<3>(at);
    all.segment<3>(at + 3) = body.inverse_inertia * wrenches.segment<3>(at + 3);
  }
  return all;
}

Vec3 TwistSystem::relative_velocity(std::size_t contact, const Vector& twists) const {
  const ContactRow& row = rows_[contact];
  Vec3 u = Vec3::Zero();
  if (const int a = slot(row.a); a != fixed) {
    const Vec3 w = twists.segment<3>(6 * a + 3);
    u += twists.segment<3>(6 * a) + w.cross(row.arm_A);
  }
  if (const int b = slot(row.b); b != fixed) {
    const Vec3 w = twists.segment<3>(6 * b + 3);
    u -= twists.segment<3>(6 * b) + w.cross(row.arm_B);
  }
  return u;
}

void TwistSystem::add_impulse(std::size_t contact, const Vec3& P, Vector& wrenches) const {
  const ContactRow& row = rows_[contact];
  if (const int a = slot(row.a); a != fixed) {
    wrenches.segment<3>(6 * a) += P;
    wrenches.segment<3>(6 * a + 3) += row.arm_A.cross(P);
  }
  if (const int b = slot(row.b); b != fixed) {
    wrenches.segment<3>(6 * b) -= P;
    wrenches.segment<3>(6 * b + 3) -= row.arm_B.cross(P);
  }
}

double TwistSystem::greatest_speed(const Vector& twists) const {
  double greatest = 0;
  for (std::size_t i = 0; i < body_of_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(6 * i);
    greatest = std::max(greatest,
                        twists.segment<3>(at).norm() + reach_[index(body_of_[i])] * twists.segment<3>(at + 3).norm());
  }
  return greatest;
}

TwistSystem::Vector TwistSystem::moving(const std::vector<Twist>& twists) const {
  Vector all = zero();
  for (std::size_t i = 0; i < body_of_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(6 * i);
    all.segment<3>(at) = twists[index(body_of_[i])].v;
    all.segment<3>(at + 3) = twists[index(body_of_[i])].w;
  }
  return all;
}

void TwistSystem::store(const Vector& moving, std::vector<Twist>& twists) const {
  for (std::size_t i = 0; i < body_of_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(6 * i);
    twists[index(body_of_[i])] = {moving.segment<3>(at), moving.segment<3>(at + 3)};
  }
}

}  // namespace touchstone::fast::contact
