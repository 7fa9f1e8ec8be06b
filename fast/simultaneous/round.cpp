#include "fast/simultaneous/round.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "fast/contact/combined_solver.h"
#include "fast/contact/least_norm.h"
#include "fast/mark.h"
#include "fast/simultaneous/friction.h"
#include "fast/simultaneous/nonnegative.h"

namespace touchstone::fast::simultaneous {
namespace {

using contact::ContactRow;
using contact::Mobility;
using contact::Twist;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double even_weight = 0x1p-2;  // of an even pressure in the energies of wrenches, with friction
constexpr std::size_t most_turns = 32, most_turns_times_points = 512;  // a turn costs the cube of the points
constexpr double friction_convergence = 0x1p-44;                       // of the greatest friction
// Of the condition that impulses keep their effect (`shared`).
constexpr double least_weight = 0x1p6, greatest_weight = 0x1p24, weight_ratio = 0x1p6;
constexpr int steps_per_weight = 3;
constexpr double effect_kept = 0x1p-48;  // of the effect

bool moves(const Mobility& body) { return body.inverse_mass > 0; }

double normal_velocity(const ContactRow& row, const std::vector<Twist>& twists) {
  return row.n.dot(relative_velocity(row, twists));
}

/// S with S Sᵀ = M⁻¹, for the angular velocity of a body.
Mat3 root(const Mobility& body) { return body.inverse_inertia.llt().matrixL(); }

/// Adds Sᵀ Nᵀ of one side of a point to its column.
void add_side(MatrixXd& A, Index row, Index column, const Mobility& body, const Vec3& arm, const Vec3& n) {
  if (!moves(body)) return;
  A.block<3, 1>(row, column) += std::sqrt(body.inverse_mass) * n;
  A.block<3, 1>(row + 3, column) += root(body).transpose() * arm.cross(n);
}

/// A with AᵀA = N M⁻¹ Nᵀ: velocities per normal impulse, in units of the root of energy.
MatrixXd responses(const std::vector<ContactRow>& points, const std::vector<Mobility>& bodies) {
  std::vector<Index> row_of(bodies.size(), -1);
  Index rows = 0;
  for (const ContactRow& point : points) {
    for (const int body : {point.a, point.b}) {
      Index& row = row_of[contact::index(body)];
      if (row < 0 && moves(bodies[contact::index(body)])) row = rows, rows += 6;
    }
  }
  MatrixXd A = MatrixXd::Zero(rows, static_cast<Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const ContactRow& point = points[k];
    const std::size_t a = contact::index(point.a), b = contact::index(point.b);
    add_side(A, row_of[a], static_cast<Index>(k), bodies[a], point.arm_A, point.n);
    add_side(A, row_of[b], static_cast<Index>(k), bodies[b], point.arm_B, -point.n);
  }
  return A;
}

/// The same for the wrenches of the regions one by one, as if each acted alone on its two bodies.
MatrixXd separate_responses(const std::vector<Region>& regions, const std::vector<Mobility>& bodies, Index points) {
  MatrixXd A = MatrixXd::Zero(12 * static_cast<Index>(regions.size()), points);
  Index column = 0;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const Index row = 12 * static_cast<Index>(r);
    for (const ContactRow& point : regions[r].points) {
      add_side(A, row, column, bodies[contact::index(point.a)], point.arm_A, point.n);
      add_side(A, row + 6, column++, bodies[contact::index(point.b)], point.arm_B, -point.n);
    }
  }
  return A;
}

bool is_rough(const std::vector<ContactRow>& points) {
  return std::ranges::any_of(points, [](const ContactRow& row) { return row.friction > 0; });
}

/// What does not change from turn to turn.
struct Responses {
  MatrixXd together;  ///< of all points
  MatrixXd apart;     ///< of each region's alone; empty if there is one region
};

/// With friction the energies of the points' own impulses count too, a little: friction depends on p, which the
/// wrenches alone leave open.
Responses responses_of(const std::vector<Region>& regions, const std::vector<ContactRow>& points,
                       const std::vector<Mobility>& bodies) {
  Responses all{responses(points, bodies), {}};
  if (regions.size() == 1) return all;
  all.apart = separate_responses(regions, bodies, all.together.cols());
  if (!is_rough(points)) return all;
  const VectorXd sizes = all.apart.colwise().norm();
  all.apart.conservativeResize(all.apart.rows() + sizes.size(), Eigen::NoChange);
  all.apart.bottomRows(sizes.size()) = even_weight * MatrixXd(sizes.asDiagonal());
  return all;
}

/// The impulses with the effect of p that have the least sum of energies of the regions' wrenches. By the method of
/// multipliers (Hestenes 1969): the condition has a weight, and what it lets pass is added to its goal. A great weight
/// hides the energies behind the rounding of the condition, so it grows only as long as the effect is missed, as it is
/// where masses differ much.
VectorXd shared(const Responses& responses, const VectorXd& p) {
  const MatrixXd &A = responses.together, &D = responses.apart;
  const VectorXd effect = A * p;
  MatrixXd both(A.rows() + D.rows(), p.size());
  both.bottomRows(D.rows()) = D;
  VectorXd goal = VectorXd::Zero(both.rows()), multipliers = VectorXd::Zero(A.rows()), split = p, missing = effect;
  const auto is_kept = [&] { return missing.norm() <= effect_kept * effect.norm(); };
  for (double weight = least_weight; weight <= greatest_weight && !is_kept(); weight *= weight_ratio) {
    both.topRows(A.rows()) = weight * A;
    for (int step = 0; step < steps_per_weight && !is_kept(); ++step) {
      goal.head(A.rows()) = weight * effect + multipliers / weight;
      split = nonnegative_least_squares(both, goal, split);
      missing = effect - A * split;
      multipliers += weight * weight * missing;
    }
  }
  // What is still missing is removed over the points that press.
  MatrixXd pressing = A;
  for (Index k = 0; k < p.size(); ++k) {
    if (!(split[k] > 0)) pressing.col(k).setZero();
  }
  split += contact::least_norm_solution(pressing, missing);
  return split.cwiseMax(0.0);
}

std::vector<ContactRow> points_of(const std::vector<Region>& regions, const std::vector<Mobility>& bodies) {
  std::vector<ContactRow> all;
  for (const Region& region : regions) {
    for (const ContactRow& point : region.points) {
      ContactRow& row = all.emplace_back(point);
      row.P.setZero();
      row.least_u_n = 0;
      prepare(row, bodies);
    }
  }
  return all;
}

void apply(const std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  for (const ContactRow& row : rows) apply_impulse(row, row.P, bodies, twists);
}

/// `compression` with the points' responses.
VectorXd compression_by(const MatrixXd& A, const std::vector<ContactRow>& points, const std::vector<Twist>& twists,
                        double least_u_n) {
  VectorXd missing(A.cols());
  for (std::size_t k = 0; k < points.size(); ++k)
    missing[static_cast<Index>(k)] = least_u_n - normal_velocity(points[k], twists);
  // With Aᵀb = missing, the least |A p − b| over p ≥ 0 is the projection.
  return nonnegative_least_squares(A, contact::least_norm_solution(A.transpose(), missing));
}

/// Normal impulses of compression, if `twists` are the velocities that all other impulses leave.
void press(const Responses& responses, std::vector<ContactRow>& rows, const std::vector<Twist>& twists) {
  VectorXd p = compression_by(responses.together, rows, twists, 0);
  if (responses.apart.size() > 0) p = shared(responses, p);
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].P = p[static_cast<Index>(k)] * rows[k].n;
}

/// Friction and normal impulses of compression in turn, each with what the other was last, until friction stays. Each
/// has a unique effect, so the order of points and regions does not matter. What they have not reached after some turns
/// is left to the contact solver.
void press_and_rub(const Responses& responses, std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies,
                   std::vector<Twist>& twists) {
  const std::vector<Twist> before = twists;
  std::vector<Vec3> friction(rows.size(), Vec3::Zero());
  const std::size_t turns = std::clamp<std::size_t>(most_turns_times_points / rows.size(), 2, most_turns);
  for (std::size_t turn = 1; turn <= turns; ++turn) {
    mark(Mark::friction_turn, rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].P += friction[k];
    twists = before;
    apply(rows, bodies, twists);
    add_friction(rows, bodies, twists);
    double change = 0, greatest = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Vec3 last = std::exchange(friction[k], friction_of(rows[k]));
      change = std::max(change, (friction[k] - last).norm());
      greatest = std::max(greatest, friction[k].norm());
    }
    if (change <= friction_convergence * greatest || turn == turns) break;
    twists = before;
    for (std::size_t k = 0; k < rows.size(); ++k) apply_impulse(rows[k], friction[k], bodies, twists);
    press(responses, rows, twists);
  }
  twists = before;
  contact::solve_combined(rows, bodies, twists, {});
}

/// The greatest s ≤ 1 with s b + s² c ≤ most, where b ≤ most.
double greatest_share(double b, double c, double most) {
  if (b + c <= most) return 1;
  const double root = std::sqrt(b * b + 4 * c * most);
  return std::clamp(b > 0 ? 2 * most / (b + root) : (root - b) / (2 * c), 0.0, 1.0);
}

}  // namespace

double least_normal_velocity(const Region& region, const std::vector<Twist>& twists) {
  double least = normal_velocity(region.points.front(), twists);
  for (const ContactRow& point : region.points) least = std::min(least, normal_velocity(point, twists));
  return least;
}

std::vector<std::vector<std::size_t>> components(const std::vector<Region>& regions,
                                                 const std::vector<Mobility>& bodies) {
  std::vector<std::size_t> root(bodies.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  const auto body_of = [&](const Region& region) {
    const std::size_t a = contact::index(region.points.front().a), b = contact::index(region.points.front().b);
    return moves(bodies[a]) ? a : b;
  };
  for (const Region& region : regions) {
    const std::size_t a = contact::index(region.points.front().a), b = contact::index(region.points.front().b);
    if (moves(bodies[a]) && moves(bodies[b])) root[find(a)] = find(b);
  }
  std::vector<std::vector<std::size_t>> found;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const auto same = std::ranges::find_if(
        found, [&](const auto& part) { return find(body_of(regions[part.front()])) == find(body_of(regions[i])); });
    (same == found.end() ? found.emplace_back() : *same).push_back(i);
  }
  return found;
}

VectorXd compression(const std::vector<ContactRow>& points, const std::vector<Mobility>& bodies,
                     const std::vector<Twist>& twists, double least_u_n) {
  return compression_by(responses(points, bodies), points, twists, least_u_n);
}

void act(std::vector<Region>& regions, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  const std::vector<Twist> before = twists;
  std::vector<ContactRow> rows = points_of(regions, bodies);
  const bool rough = is_rough(rows);
  const bool one_e = std::ranges::all_of(
      regions, [&](const Region& region) { return region.restitution == regions.front().restitution; });
  const Responses responses = responses_of(regions, rows, bodies);
  press(responses, rows, twists);
  if (rough) {
    press_and_rub(responses, rows, bodies, twists);
  } else {
    apply(rows, bodies, twists);
  }
  std::vector<ContactRow> back = rows;
  std::vector<Twist> after = twists;
  double returned = 0;  // Σ e² w
  std::size_t k = 0;
  for (const Region& region : regions) {
    for (std::size_t i = 0; i < region.points.size(); ++i, ++k) {
      const double P_n = rows[k].n.dot(rows[k].P), e = region.restitution;
      returned += e * e * P_n * -normal_velocity(rows[k], before) / 2;
      back[k].P = e * P_n * rows[k].n;
      apply_impulse(back[k], back[k].P, bodies, after);
    }
  }
  double share = 1;
  if (rough) add_friction(back, bodies, after);
  if (rough || !one_e) {
    double b = 0, c = 0;
    for (const ContactRow& row : back) {
      const Vec3 u = relative_velocity(row, twists);
      b += row.P.dot(u);
      c += row.P.dot(relative_velocity(row, after) - u) / 2;
    }
    double lost = 0;
    for (const ContactRow& row : rows)
      lost -= row.P.dot(relative_velocity(row, before) + relative_velocity(row, twists)) / 2;
    share = greatest_share(b, c, std::max(0.0, std::min(returned, lost)));
  }
  twists = before;
  k = 0;
  for (Region& region : regions) {
    for (ContactRow& point : region.points) {
      point.P = rows[k].P + share * back[k].P;
      apply_impulse(point, point.P, bodies, twists);
      ++k;
    }
  }
}

}  // namespace touchstone::fast::simultaneous
