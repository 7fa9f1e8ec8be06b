#include "fast/simulation/work.h"

#include <array>
#include <cstddef>

namespace touchstone::fast::simulation {
namespace {

struct Cost {
  Mark mark;
  std::uint64_t time;  ///< ns
};

// Fitted to the times of named, drawn and extreme scenes, and rounded to powers of two. What is marked within the time
// of another mark counts there.
constexpr std::array costs = {Cost{Mark::balance_step, 8192},
                              Cost{Mark::centre_step, 8192},
                              Cost{Mark::contact_newton, 4096},
                              Cost{Mark::contact_round, 2048},
                              Cost{Mark::contact_row, 64},
                              Cost{Mark::descent_step, 512},
                              Cost{Mark::exact_proximity, 16384},
                              Cost{Mark::exact_step, 65536},
                              Cost{Mark::face_scan, 2048},
                              Cost{Mark::friction_turn, 4096},
                              Cost{Mark::impact_together, 65536},
                              Cost{Mark::impulse_phase, 512},
                              Cost{Mark::plane_step, 512},
                              Cost{Mark::proxy_candidate, 16},
                              Cost{Mark::proxy_query, 256},
                              Cost{Mark::rest_phase, 8192},
                              Cost{Mark::toi_all_normals, 16384},
                              Cost{Mark::toi_balls, 64},
                              Cost{Mark::toi_query, 1024},
                              Cost{Mark::toi_wait, 2048},
                              Cost{Mark::tumble_step, 1024},
                              Cost{Mark::vertex_scan, 2},
                              Cost{Mark::walk, 512},
                              Cost{Mark::walk_in_doubles, 2048},
                              Cost{Mark::walk_step, 512}};

}  // namespace

std::int64_t Work::done() const {
  std::uint64_t sum = 0;
  for (const Cost& cost : costs) {
    const auto place = static_cast<std::size_t>(cost.mark);
    sum += cost.time * (mark_counts[place] - before_[place]);
  }
  return static_cast<std::int64_t>(sum);
}

}  // namespace touchstone::fast::simulation
