#include "reference/time_of_impact/translation.h"

#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <vector>

#include "reference/exact/bland.h"
#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/time_of_impact/initial_contact.h"

namespace touchstone::reference {
namespace {

using Number = CGAL::Gmpq;
using Program = CGAL::Quadratic_program<Number>;
using Solution = CGAL::Quadratic_program_solution<Number>;

Number number(const mpq_class& v) { return Number(v.get_mpq_t()); }

mpq_class quotient(const CGAL::Quotient<Number>& v) {
  return mpq_class(v.numerator().mpq()) / mpq_class(v.denominator().mpq());
}

/// How far a body that translates has come by the time `from`.
Triple way(const BallisticStart& start, const mpq_class& from) {
  const mpq_class s = from - start.start_time;
  return plus(scaled(s, start.v), scaled(mpq_class(s * s / 2), start.c));
}

Triple velocity_at(const BallisticStart& start, const mpq_class& time) {
  return plus(start.v, scaled(mpq_class(time - start.start_time), start.c));
}

/// The cores at `from`, and the velocity of A relative to B then.
struct Translation {
  std::vector<Triple> a, b;
  Triple u;

  Translation(const Parts& parts, const std::array<BallisticStart, 2>& starts, const mpq_class& from)
      : a(vertices_at_start(parts.A, parts.a)), b(vertices_at_start(parts.B, parts.b)) {
    const auto& [A, B] = starts;
    u = minus(velocity_at(A, from), velocity_at(B, from));
    const Triple way_A = way(A, from), way_B = way(B, from);
    for (Triple& v : a) v = plus(v, way_A);
    for (Triple& v : b) v = plus(v, way_B);
  }

  /// Column 0: τ; the next ones: λ and μ. Rows 0 to 2: v, which is `difference`; row 3: Σ λ = 1; row 4: Σ μ = 1.
  Program program(const Triple& difference) const {
    Program all(CGAL::EQUAL);
    int column = 0;
    const auto add = [&](const Triple& direction) {
      for (int row = 0; row < 3; ++row) all.set_a(column, row, number(direction[static_cast<std::size_t>(row)]));
    };
    add(u);
    for (const Triple& vertex : a) {
      ++column;
      add(vertex);
      all.set_a(column, 3, Number(1));
    }
    for (const Triple& vertex : b) {
      ++column;
      add(minus(Triple{}, vertex));
      all.set_a(column, 4, Number(1));
    }
    for (int row = 0; row < 3; ++row) all.set_b(row, number(difference[static_cast<std::size_t>(row)]));
    all.set_b(3, Number(1));
    all.set_b(4, Number(1));
    return all;
  }
};

/// The least τ at which v is `difference`.
std::optional<mpq_class> least_time(const Translation& translation, const Triple& difference) {
  Program program = translation.program(difference);
  program.set_c(0, Number(1));
  const Solution solution = CGAL::solve_nonnegative_linear_program(program, Number(), blands_rule());
  if (solution.is_infeasible()) return std::nullopt;
  return quotient(solution.objective_value());
}

/// The v of the least length for τ ≤ most.
Triple least_difference(const Translation& translation, const mpq_class& most) {
  Program program = translation.program({});
  // v = plus − minus, and τ + rest = most.
  const int first = static_cast<int>(1 + translation.a.size() + translation.b.size());
  for (int k = 0; k < 3; ++k) {
    const int plus = first + k, minus = first + 3 + k;
    program.set_a(plus, k, Number(-1));
    program.set_a(minus, k, Number(1));
    program.set_d(plus, plus, Number(2));
    program.set_d(minus, plus, Number(-2));
    program.set_d(minus, minus, Number(2));
  }
  program.set_a(0, 5, Number(1));
  program.set_a(first + 6, 5, Number(1));
  program.set_b(5, number(most));
  const Solution solution = CGAL::solve_nonnegative_quadratic_program(program, Number(), blands_rule());
  std::vector<mpq_class> values;
  for (auto value = solution.variable_values_begin(); value != solution.variable_values_end(); ++value)
    values.push_back(quotient(*value));
  Triple v;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t plus = static_cast<std::size_t>(first) + k;
    v[k] = values[plus] - values[plus + 3];
  }
  return v;
}

}  // namespace

bool translates(const BallisticStart& start) {
  const Triple zero;
  return start.w == zero && start.Omega == zero && start.sigma == zero && !start.tumble;
}

void start_later(Body& body, BallisticStart& start, double time) {
  const Triple come = way(start, time), p = plus(triple(body.X_WB.p_WB), come);
  const Vec3 rounded(nearest(p[0]), nearest(p[1]), nearest(p[2]));
  if (!rounded.allFinite() || triple(rounded) != p) return;
  body.X_WB.p_WB = rounded;
  start.p = plus(start.p, come);
  start.v = velocity_at(start, time);
  start.start_time = time;
}

std::optional<TranslatingContact> translating_contact(const Parts& parts, const std::array<BallisticStart, 2>& starts,
                                                      double apart, double from, double end) {
  if (!translates(starts[0]) || !translates(starts[1]) || starts[0].c != starts[1].c) return std::nullopt;
  const Translation translation(parts, starts, from);
  const mpq_class span = mpq_class(end) - mpq_class(from);
  const mpq_class r =
      mpq_class(core_of(parts.A, parts.a).radius) + mpq_class(core_of(parts.B, parts.b).radius) + mpq_class(apart);
  Triple difference;
  if (r > 0) {
    difference = least_difference(translation, span);
    const mpq_class excess = dot(difference, difference) - r * r;
    if (excess > 0) return TranslatingContact{};
    if (excess < 0) return std::nullopt;
  }
  const std::optional<mpq_class> after = least_time(translation, difference);
  if (!after || *after > span) return TranslatingContact{};
  return TranslatingContact{mpq_class(mpq_class(from) + *after)};
}

}  // namespace touchstone::reference
