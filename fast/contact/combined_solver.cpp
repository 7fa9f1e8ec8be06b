#include "fast/contact/combined_solver.h"

#include "fast/contact/sparse/newton.h"

namespace touchstone::fast::contact {
namespace {

constexpr std::size_t most_swept_contacts = 64;
constexpr int next_factorisations = 32, last_factorisations = 128;

}  // namespace

void solve_combined(std::vector<ContactRow>& rows, const std::vector<Mobility>& mobilities, std::vector<Twist>& twists,
                    SolverLimits sweeps) {
  const std::vector<Twist> free = twists;
  const auto swept = [&](bool is_patient) {
    twists = free;
    sweeps.is_patient = is_patient;
    return solve(rows, mobilities, twists, sweeps);
  };
  const auto newton = [&](int factorisations) {
    twists = free;
    return solve_newton(rows, mobilities, twists, {sweeps.enough, factorisations});
  };
  if (swept(false) || newton(next_factorisations) || swept(true)) return;
  if (newton(next_factorisations) || rows.size() <= most_swept_contacts) return;
  const std::vector<ContactRow> best = rows;
  const std::vector<Twist> best_twists = twists;
  for (ContactRow& row : rows) row.P.setZero();
  if (newton(last_factorisations)) return;
  rows = best;
  twists = best_twists;
}

}  // namespace touchstone::fast::contact
