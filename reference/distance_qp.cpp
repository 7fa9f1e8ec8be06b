// A second opinion that shares nothing but the exact pose: CGAL's quadratic programs in exact integers.
//   d*             Polytope_distance_d
//   d* = 0         linear programs over all common points x = Σ λ a = Σ μ b of A and B
#include <CGAL/Gmpz.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/Simple_homogeneous.h>

#include <algorithm>
#include <array>

#include "reference/distance_impl.h"

namespace touchstone::reference {
namespace {

using Number = CGAL::Gmpz;
using Kernel = CGAL::Simple_homogeneous<Number>;
using Point = Kernel::Point_3;

Number number(const Integer& v) { return Number(v.get_mpz_t()); }
Integer integer(const Number& v) { return Integer(v.mpz()); }

std::vector<Point> points_of(const PosedCore& core) {
  std::vector<Point> points;
  for (int i = 0; i < core.size(); ++i) {
    const IntegerVec& v = core.exact(i);
    points.emplace_back(number(v.x), number(v.y), number(v.z), Number(1));
  }
  return points;
}

/// Which vertices can take part (λ > 0) in some combination that is a common point. Those of A span the least face of A
/// around A ∩ B, or all of A's vertices can.
class Participants {
 public:
  Participants(const PosedPair& pair)
      : A_(pair.A), B_(pair.B), takes_part_(static_cast<std::size_t>(A_.size() + B_.size())) {
    while (!overlap() && find_more()) {
    }
  }

  /// The directions of the participants span space: 0 is inside A − B.
  bool overlap() const {
    const std::vector<int> a = of_A();
    const std::vector<int> b = of_B();
    std::vector<IntegerVec> arms;
    for (const int i : a) arms.push_back(A_.exact(i) - A_.exact(a[0]));
    for (const int j : b) arms.push_back(B_.exact(j) - B_.exact(b[0]));
    IntegerVec line;
    IntegerVec normal;
    for (const IntegerVec& arm : arms) {
      if (is_zero(line))
        line = arm;
      else if (is_zero(normal))
        normal = cross(line, arm);
      else if (dot(normal, arm) != 0)
        return true;
    }
    return false;
  }

  std::vector<int> of_A() const { return among(0, A_.size()); }
  std::vector<int> of_B() const { return among(A_.size(), B_.size()); }

 private:
  std::vector<int> among(int first, int count) const {
    std::vector<int> found;
    for (int i = 0; i < count; ++i) {
      if (takes_part_[static_cast<std::size_t>(first + i)]) found.push_back(i);
    }
    return found;
  }

  /// Maximises the weight of those that have not taken part so far; false if it is 0.
  bool find_more() {
    CGAL::Quadratic_program<Number> program(CGAL::EQUAL);
    const auto add = [&](int column, const IntegerVec& v, int sum_row) {
      const std::array<Integer, 3> entries = {v.x, v.y, v.z};
      for (int row = 0; row < 3; ++row) program.set_a(column, row, number(entries[static_cast<std::size_t>(row)]));
      program.set_a(column, sum_row, Number(1));
      if (!takes_part_[static_cast<std::size_t>(column)]) program.set_c(column, Number(-1));
    };
    for (int i = 0; i < A_.size(); ++i) add(i, A_.exact(i), 3);
    for (int j = 0; j < B_.size(); ++j) add(A_.size() + j, -B_.exact(j), 4);
    program.set_b(3, Number(1));
    program.set_b(4, Number(1));
    const auto solution = CGAL::solve_linear_program(program, Number());
    bool more = false;
    auto value = solution.variable_numerators_begin();
    for (std::size_t i = 0; i < takes_part_.size(); ++i, ++value) {
      if (CGAL::is_zero(*value) || takes_part_[i]) continue;
      takes_part_[i] = true;
      more = true;
    }
    return more;
  }

  const PosedCore& A_;
  const PosedCore& B_;
  std::vector<bool> takes_part_;
};

std::vector<int> where_extreme(const PosedCore& core, const IntegerVec& n) {
  std::vector<Integer> heights;
  for (int i = 0; i < core.size(); ++i) heights.push_back(dot(n, core.exact(i)));
  const Integer least = *std::min_element(heights.begin(), heights.end());
  std::vector<int> found;
  for (int i = 0; i < core.size(); ++i) {
    if (heights[static_cast<std::size_t>(i)] == least) found.push_back(i);
  }
  return found;
}

/// A common point: the cores touch, or one overlaps the other.
void classify_contact(const PosedPair& pair, CoreNearest& result) {
  if (pair.A.is_point() && pair.B.is_point()) {
    result.cores = Verdict::touching;
    result.face_A = result.face_B = {0};
    return;
  }
  const Participants common(pair);
  result.cores = common.overlap() ? Verdict::overlapping : Verdict::touching;
  if (common.overlap()) return;
  result.face_A = common.of_A();
  result.face_B = common.of_B();
}

}  // namespace

CoreNearest nearest_by_qp(PosedPair& pair) {
  const std::vector<Point> A = points_of(pair.A);
  const std::vector<Point> B = points_of(pair.B);
  const CGAL::Polytope_distance_d<CGAL::Polytope_distance_d_traits_3<Kernel>> program(A.begin(), A.end(), B.begin(),
                                                                                      B.end());
  const Point a = program.realizing_point_p();
  const Point b = program.realizing_point_q();

  CoreNearest result;
  result.point = {{integer(a.hx()), integer(a.hy()), integer(a.hz())}, integer(a.hw())};
  const HomogeneousPoint point_B = {{integer(b.hx()), integer(b.hy()), integer(b.hz())}, integer(b.hw())};
  result.normal = point_B.den * result.point.num - result.point.den * point_B.num;
  result.denominator = result.point.den * point_B.den;
  if (is_zero(result.normal)) {
    classify_contact(pair, result);
    return result;
  }
  const IntegerVec n = result.denominator > 0 ? result.normal : -result.normal;
  result.face_A = where_extreme(pair.A, n);
  result.face_B = where_extreme(pair.B, -n);
  return result;
}

}  // namespace touchstone::reference
