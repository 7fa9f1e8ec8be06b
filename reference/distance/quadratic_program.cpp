// An independent second route that shares only the exact pose: CGAL's quadratic programs in exact integers.
//   d*             the least |v|² with v = Σ λ a − Σ μ b, Σ λ = Σ μ = 1, all λ, μ ≥ 0
//   d* = 0         linear programs over all common points x = Σ λ a = Σ μ b of A and B
// This is the program of CGAL's Polytope_distance_d (v is the difference of two non-negative vectors). That class takes
// no options, so its pricing cannot be Bland's.
#include <CGAL/Gmpz.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <algorithm>
#include <array>

#include "reference/distance/routes.h"
#include "reference/exact/bland.h"

namespace touchstone::reference {
namespace {

using Number = CGAL::Gmpz;
using Program = CGAL::Quadratic_program<Number>;

Number number(const Integer& v) { return Number(v.get_mpz_t()); }
Integer integer(const Number& v) { return Integer(v.mpz()); }

/// Adds a column: the vertex in three rows, and a 1 in the row that sums its weights.
void add_vertex(Program& program, int column, const IntegerVec& v, int sum_row) {
  program.set_a(column, 0, number(v.x));
  program.set_a(column, 1, number(v.y));
  program.set_a(column, 2, number(v.z));
  program.set_a(column, sum_row, Number(1));
}

/// Rows 0 to 2: Σ λ a − Σ μ b, from `column` on; row 3: Σ λ = 1; row 4: Σ μ = 1.
void add_weights(Program& program, int column, const PosedCore& A, const PosedCore& B) {
  for (int i = 0; i < A.size(); ++i) add_vertex(program, column++, A.exact(i), 3);
  for (int j = 0; j < B.size(); ++j) add_vertex(program, column++, -B.exact(j), 4);
  program.set_b(3, Number(1));
  program.set_b(4, Number(1));
}

/// The vertices that can take part (λ > 0) in some combination that is a common point. Those of A span the least face
/// of A that contains A ∩ B, or are all vertices of A.
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

  /// Maximises the sum of the weights that have been 0 so far; false if it is 0.
  bool find_more() {
    Program program(CGAL::EQUAL);
    add_weights(program, 0, A_, B_);
    for (std::size_t i = 0; i < takes_part_.size(); ++i) {
      if (!takes_part_[i]) program.set_c(static_cast<int>(i), Number(-1));
    }
    const auto solution = CGAL::solve_nonnegative_linear_program(program, Number(), blands_rule());
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

/// The cores have a common point: do they touch or overlap?
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

/// v = plus − minus in columns 0 to 2 and 3 to 5; the λ and μ follow.
CGAL::Quadratic_program_solution<Number> least_square(const PosedPair& pair) {
  Program program(CGAL::EQUAL);
  for (int k = 0; k < 3; ++k) {
    program.set_a(k, k, Number(-1));
    program.set_a(k + 3, k, Number(1));
    program.set_d(k, k, Number(2));
    program.set_d(k + 3, k, Number(-2));
    program.set_d(k + 3, k + 3, Number(2));
  }
  add_weights(program, 6, pair.A, pair.B);
  return CGAL::solve_nonnegative_quadratic_program(program, Number(), blands_rule());
}

}  // namespace

CoreNearest nearest_by_qp(PosedPair& pair) {
  const auto solution = least_square(pair);
  std::vector<Integer> values;
  for (auto v = solution.variable_numerators_begin(); v != solution.variable_numerators_end(); ++v)
    values.push_back(integer(*v));

  CoreNearest result;
  result.normal = {values[0] - values[3], values[1] - values[4], values[2] - values[5]};
  result.denominator = integer(solution.variables_common_denominator());
  result.point.den = result.denominator;
  for (int i = 0; i < pair.A.size(); ++i) {
    result.point.num = result.point.num + values[static_cast<std::size_t>(6 + i)] * pair.A.exact(i);
  }
  if (is_zero(result.normal)) {
    classify_contact(pair, result);
    return result;
  }
  result.face_A = where_extreme(pair.A, result.normal);
  result.face_B = where_extreme(pair.B, -result.normal);
  return result;
}

}  // namespace touchstone::reference
