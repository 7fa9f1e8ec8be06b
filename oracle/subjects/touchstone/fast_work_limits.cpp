#include "oracle/subjects/touchstone/fast_work_limits.h"

namespace touchstone::oracle::subjects {
namespace {

constexpr int generic = 16;

}  // namespace

// Most limits are a number of steps for each search, and a base for one search that takes long. A depth in a needle
// takes hundreds of steps, and a pair that touches is decided by exact arithmetic, so the promises about distance and
// penetration are about 16 generic placements together. Bodies that turn within reach of each other are searched a part
// of a radian at a time, and a sliver beside another body for a part of the angle that its thickness is seen under.
// Of two limits of one count each holds. How near drawn scenes come to the limits is in docs/measured/mutation.md; they
// are choices, tight enough that some faults which cost time alone are seen.
std::vector<WorkLimit> fast_work_limits() {
  return {
      {"distance", "exact_proximity", 4, {{"aspect", 0.0625}}, generic},
      {"distance", "exact_proximity", 12, {}, generic},
      {"distance", "descent_step", 64, {{"vertices", 0.5}}, generic},
      {"distance", "exact_step", 8, {{"exact_proximity", 8}}},

      {"penetration", "exact_proximity", 4, {{"aspect", 0.0625}}, generic},
      {"penetration", "exact_proximity", 12, {}, generic},
      {"penetration", "depth_exact", 16, {{"aspect", 1}}, generic},
      {"penetration", "depth_exact", 160, {}, generic},
      {"penetration", "depth_step", 192, {{"vertices", 8}, {"aspect", 24}}, generic},
      {"penetration", "depth_step", 6500, {}, generic},
      {"penetration", "descent_step", 128, {{"vertices", 1.5}}, generic},
      {"penetration", "exact_step", 8, {{"exact_proximity", 8}}},

      {"pair_history", "climb_step", 0, {{"climb", 96}}},
      {"pair_history", "climb_exact", 16, {{"climb", 9}}},
      {"pair_history", "grid_rebuild", 2, {{"frames", 1}}},
      {"pair_history", "grid_chain", 64, {{"grid_update", 8}}},
      {"pair_history", "grid_unchain", 32, {{"grid_update", 4}}},
      {"pair_history", "grid_long_body", 8, {{"placements", 4}}},

      {"impulse", "impulse_curve", 5},
      {"impulse", "impulse_phase", 16, {{"impulse_curve", 80}}},
      {"impulse", "impulse_series", 2, {{"impulse_curve", 1}}},
      {"impulse", "impulse_again", 2},
      {"impulse", "impulse_scaled", 2},
      {"impulse", "impulse_slide_off", 4},

      {"time_of_impact", "toi_balls", 32, {{"toi_search", 5}}},
      {"time_of_impact", "toi_query", 32, {{"toi_search", 64}, {"radians", 4}, {"aspect", 0.0625}}},
      {"time_of_impact", "toi_wait", 32, {{"toi_search", 64}}},
      {"time_of_impact", "toi_all_normals", 64, {{"toi_query", 1}}},
      {"time_of_impact", "tumble_step", 192, {{"toi_query", 2}}},
      {"time_of_impact", "walk", 96, {{"toi_query", 2}}},
      {"time_of_impact", "walk_step", 32, {{"walk", 6}, {"vertices", 2}}},
      {"time_of_impact", "walk_in_doubles", 16, {{"walk", 2}}},
      {"time_of_impact", "walk_inside", 8, {{"walk", 2}}},
      {"time_of_impact", "walk_restart", 64, {{"toi_query", 2}}},
      {"time_of_impact", "face_scan", 32, {{"walk", 6}}},
      {"time_of_impact", "exact_proximity", 1, {{"toi_search", 1}}},
      {"time_of_impact", "exact_step", 8, {{"exact_proximity", 6}}},

      {"simulation", "toi_query", 128, {{"toi_search", 6}, {"radians", 4}, {"aspect", 0.0625}, {"contact_round", 0.5}}},
      {"simulation", "tumble_step", 2048, {{"toi_query", 3}, {"event", 16}}},
      {"simulation", "walk", 2048, {{"toi_query", 4}, {"contact_round", 16}}},
      {"simulation", "walk_step", 64, {{"walk", 7}}},
      {"simulation", "walk_in_doubles", 64, {{"walk", 4}}},
      {"simulation", "walk_inside", 32, {{"walk", 1}}},
      {"simulation", "face_scan", 128, {{"walk", 4}}},
      {"simulation", "exact_proximity", 32, {{"walk", 0.5}, {"contact_round", 2}}},
      {"simulation", "exact_step", 32, {{"exact_proximity", 6}}},
      {"simulation", "impulse_phase", 128, {{"impulse_curve", 80}}},
      {"simulation", "impulse_series", 16, {{"impulse_curve", 2}}},
      {"simulation", "contact_row", 256, {{"contact_sweep", 48}}},
      {"simulation", "contact_sweep", 512, {{"contact_round", 256}}},
      {"simulation", "contact_newton", 64, {{"contact_round", 16}}},
      {"simulation", "step", 512, {{"seconds", 8192}, {"event", 8}}},
      {"simulation", "contact_round", 256, {{"step", 48}}},
      {"simulation", "proxy_query", 64, {{"body_seconds", 64}, {"event", 10}, {"contact_round", 8}}},
      {"simulation", "proxy_candidate", 256, {{"proxy_query", 40}}},
      {"simulation", "plane_step", 1024, {{"proxy_query", 32}}},
      {"simulation", "toi_search", 64, {{"proxy_query", 4}}},
      {"simulation", "toi_balls", 32, {{"toi_search", 2}}},
      {"simulation", "toi_wait", 64, {{"toi_query", 1}}},
      {"simulation", "toi_all_normals", 64, {{"toi_query", 0.25}}},
      {"simulation", "walk_restart", 64, {{"walk", 1}}},
      {"simulation", "island_merge", 32, {{"event", 2}, {"step", 2}}},
      {"simulation", "impact_together", 8, {{"event", 0.5}}},
      {"simulation", "friction_turn", 128, {{"impact_together", 512}}},
      {"simulation", "friction_step", 1024, {{"friction_turn", 80}}},
      {"simulation", "impulse_curve", 128, {{"event", 24}}},
      {"simulation", "impulse_slide_off", 32, {{"impulse_curve", 1}}},
      {"simulation", "micro_bounces", 8, {{"event", 1}}},
      {"simulation", "rest_phase", 8, {{"event", 1}}},
      {"simulation", "balance_step", 64, {{"samples", 16}, {"contact_round", 1}}},

      {"constraint", "walk_step", 128, {{"walk", 1}}},
      {"constraint", "walk_in_doubles", 64, {{"walk", 3}}},
      {"constraint", "face_scan", 128, {{"walk", 4}}},
      {"constraint", "exact_proximity", 32, {{"walk", 1}}},
      {"constraint", "exact_step", 32, {{"exact_proximity", 8}}},
      {"constraint", "walk", 256, {{"pairs", 6144}}},
      {"constraint", "step_long", 512},
      {"constraint", "step_bounce", 32, {{"event", 2}}},
      {"constraint", "contact_row", 256, {{"contact_sweep", 64}}},
  };
}

/// Of two frames; those of penetration are twice those of one.
std::vector<WorkLimit> fast_pairs_work_limits() {
  return {
      {"distance", "walk_step", 16, {{"walk", 4}, {"vertices", 2}}},
      {"distance", "walk_step", 64, {{"vertices", 1}}, generic},
      {"distance", "walk_in_doubles", 16, {{"walk", 2}}},
      {"distance", "walk_inside", 8, {{"walk", 2}}},
      {"distance", "walk_restart", 8, {{"walk", 1}}},
      {"distance", "face_scan", 16, {{"walk", 2}}},
      {"distance", "exact_proximity", 4, {{"aspect", 0.0625}}, generic},
      {"distance", "exact_proximity", 12, {}, generic},
      {"distance", "exact_step", 16, {{"exact_proximity", 8}}},

      {"penetration", "exact_proximity", 8, {{"aspect", 0.125}}, generic},
      {"penetration", "exact_proximity", 24, {}, generic},
      {"penetration", "depth_exact", 64, {{"aspect", 2}}, generic},
      {"penetration", "depth_exact", 320, {}, generic},
      {"penetration", "depth_step", 384, {{"vertices", 16}, {"aspect", 48}}, generic},
      {"penetration", "depth_step", 13000, {}, generic},
      {"penetration", "descent_step", 256, {{"vertices", 3}}, generic},
      {"penetration", "exact_step", 16, {{"exact_proximity", 8}}},
  };
}

}  // namespace touchstone::oracle::subjects
