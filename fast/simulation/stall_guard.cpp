#include "fast/simulation/stall_guard.h"

#include <algorithm>

namespace touchstone::fast::simulation {
namespace {

// Limits at which a run stops and reports why. They are not derived; they end runs that would not end.
constexpr double stall_window = 0x1p-10;        // of a frame, or of the motion if that is shorter
constexpr std::int64_t max_iterations = 4'000;  // iterations in a stall window
constexpr std::int64_t iterations_per_body = 16;
constexpr int queries_per_iteration = 64;  // so many separation queries cost about one iteration, and count as one
constexpr std::int64_t iterations_without_progress = 512;
constexpr unsigned iterations_between_sums = 16;  // adding up the work costs a twentieth of an event of two balls
constexpr const char* too_much_work = "more work than allowed";

}  // namespace

StallGuard::StallGuard(const SimulationOptions& options, double frame, double end, std::size_t bodies)
    : options_(options),
      window_(stall_window * std::min(frame, end)),
      most_iterations_(max_iterations + iterations_per_body * static_cast<std::int64_t>(bodies)),
      most_work_(options.most_work_per_body * static_cast<std::int64_t>(bodies)) {}

bool StallGuard::makes_progress(double now, BodyId a, BodyId b) {
  if (now > window_end_) {
    window_end_ = now + window_;
    iterations_ = 0;
  }
  const bool hardly_goes_on = ++iterations_ > most_iterations_;
  const bool asks_for_work = ++all_iterations_ % iterations_between_sums == 0;
  if (!hardly_goes_on && (!asks_for_work || has_work_left())) return true;
  stop(now, a, b, hardly_goes_on ? "time hardly goes on" : too_much_work);
  return false;
}

void StallGuard::stop(double now, BodyId a, std::optional<BodyId> b, const char* why) {
  stopped_ = Stopped{now, static_cast<int>(a), b ? static_cast<int>(*b) : -1, why};
}

void StallGuard::count_queries(int queries) { iterations_ += queries / queries_per_iteration; }

void StallGuard::count_lost_resolution() { iterations_ += iterations_without_progress; }

void StallGuard::check_residual(double residual, double bound, double now, BodyId a, BodyId b) {
  if (residual > bound) {
    stop(now, a, b, "contacts could not be solved: they are off by more than a step of this length explains");
  }
}

void StallGuard::check_steps(const Statistics& statistics, double now, BodyId a, BodyId b) {
  if (statistics.contact_steps > options_.most_contact_steps) {
    stop(now, a, b, "contacts that take more steps than allowed");
  } else if (!has_work_left()) {
    stop(now, a, b, too_much_work);
  }
}

}  // namespace touchstone::fast::simulation
