// Counts how often code ran that only special scenes reach, and code that costs much.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace touchstone::fast {

/// A place in the code. The counts must obey two laws (tests/properties/scenes/marks_test.cpp): drawn scenes reach each
/// place, and on generic scenes what is slow runs seldom. Else a fault there would change no answer: the code is never
/// run, or an exact fallback repairs what it did. The work of a simulation is a sum of them (fast/simulation/work.h).
enum class Mark : unsigned char {
  balance_step,       ///< fast/contact/sparse/balance: a factorisation in the search for balance
  centre_step,        ///< fast/simulation/simultaneous_impact: an impact tried at a centre of pressure
  climb,              ///< fast/bounds/climb: one polytope at one pose
  climb_step,         ///< a vertex left for a higher one
  climb_exact,        ///< an axis along which doubles could not decide
  contact_newton,     ///< fast/contact/sparse/newton: a factorisation
  contact_round,      ///< fast/contact/step: the contacts of a step solved for one guess of where bodies end
  contact_row,        ///< fast/contact: a contact relaxed, linearised for a round or factorised
  contact_sweep,      ///< fast/contact/solver: each contact relaxed once
  depth,              ///< fast/penetration/depth_bracket: one pair of convex bodies
  depth_exact,        ///< fast/penetration/exact_depth: a vertex added
  depth_step,         ///< a vertex difference asked for
  descent,            ///< fast/lin_canny/descent: one pair of convex parts
  descent_step,       ///< a vertex difference added
  exact_proximity,    ///< fast/lin_canny/exact_proximity: a pair that doubles could not decide
  exact_step,         ///< fast/exact/nearest: a pair of vertices added
  face_scan,          ///< fast/lin_canny/bracket: all vertices looked at, since no neighbour shows the highest
  friction_step,      ///< fast/simultaneous/friction: the friction of all points changed once
  friction_turn,      ///< fast/simultaneous/round: a point whose normal impulse and friction are solved in turn
  grid_chain,         ///< fast/broad_phase/wrapped_grid: an entry put into a chain
  grid_layout,        ///< cells laid out
  grid_long_body,     ///< a body across more rows than a level has
  grid_rebuild,       ///< all entries sorted again
  grid_unchain,       ///< an entry taken out of a chain
  grid_update,        ///< a frame in which only the entries of few bodies changed
  impulse_again,      ///< fast/impulse/solve: a second compression
  impulse_curve,      ///< fast/impulse/curve: slip that turns, up to a goal or a stop
  impulse_phase,      ///< one phase of that
  impulse_scaled,     ///< an impact solved in other units
  impulse_series,     ///< a stop found from the series for the remaining impulse
  impulse_slide_off,  ///< slip that begins again where it has stopped
  impact_tied,        ///< fast/simulation/island/contact_pair: one of many normals chosen by the approach
  impact_together,    ///< fast/simulation/simultaneous_impact: impacts that act together
  island_merge,       ///< fast/simulation/island: bodies that become one island
  micro_bounces,      ///< fast/simulation/contact_event: bounces within the envelope, completed at once
  pixel_exact,        ///< fast/pixel: a pixel that doubles could not decide
  pixel_seen,         ///< a part that is projected
  plane_step,         ///< fast/simulation/prediction/pair_time_of_impact: a step to where a plane is reached
  proxy_candidate,    ///< fast/simulation/prediction/hash_grid: a body whose box is compared
  proxy_query,        ///< for a body whose neighbours are asked for
  rest_phase,         ///< fast/simulation/rest: a phase of a contact in closed form that ends
  shared_normal,      ///< fast/simulation/island/shared_normal: a part that takes over the normal of another one
  step_bounce,        ///< fast/constraint/stepper: contacts solved again, with restitution
  step_force,         ///< an applied force that begins
  step_long,          ///< a step as long as many, in which nothing changes
  step_shift,         ///< a position correction
  toi_all_normals,    ///< fast/time_of_impact/separation_query: all normals of two parts tried
  toi_balls,          ///< fast/time_of_impact/advance: two bodies far apart, as balls
  toi_doubt,          ///< a time at which the two may have touched
  toi_parting,        ///< contact at the start, along another normal
  toi_query,          ///< a separation query
  toi_search,         ///< one pair of convex parts
  toi_wait,           ///< a later time tried, since only rounding separates the two
  tumble_step,        ///< fast/motion/tumble: a step of the series
  vertex_scan,        ///< fast/contact/support: a vertex compared with the lowest one so far
  walk,               ///< fast/lin_canny/walk: one pair of convex parts
  walk_in_doubles,    ///< slopes compared in doubles, since floats cannot tell
  walk_inside,        ///< a vertex found inside the other part
  walk_restart,       ///< continued from a far face that was no closer
  walk_step,          ///< a step to a neighbouring feature
  count_of_marks
};

/// The names, in the order of the enumerators.
constexpr std::array<const char*, static_cast<std::size_t>(Mark::count_of_marks)> mark_names = {
    "balance_step",      "centre_step",   "climb",           "climb_step",     "climb_exact",     "contact_newton",
    "contact_round",     "contact_row",   "contact_sweep",   "depth",          "depth_exact",     "depth_step",
    "descent",           "descent_step",  "exact_proximity", "exact_step",     "face_scan",       "friction_step",
    "friction_turn",     "grid_chain",    "grid_layout",     "grid_long_body", "grid_rebuild",    "grid_unchain",
    "grid_update",       "impulse_again", "impulse_curve",   "impulse_phase",  "impulse_scaled",  "impulse_series",
    "impulse_slide_off", "impact_tied",   "impact_together", "island_merge",   "micro_bounces",   "pixel_exact",
    "pixel_seen",        "plane_step",    "proxy_candidate", "proxy_query",    "rest_phase",      "shared_normal",
    "step_bounce",       "step_force",    "step_long",       "step_shift",     "toi_all_normals", "toi_balls",
    "toi_doubt",         "toi_parting",   "toi_query",       "toi_search",     "toi_wait",        "tumble_step",
    "vertex_scan",       "walk",          "walk_in_doubles", "walk_inside",    "walk_restart",    "walk_step"};

using MarkCounts = std::array<std::uint64_t, static_cast<std::size_t>(Mark::count_of_marks)>;

/// Of the thread, since it began.
constinit inline thread_local MarkCounts mark_counts{};
/// Adds to the count of a place.
inline void mark(Mark place, std::uint64_t times = 1) { mark_counts[static_cast<std::size_t>(place)] += times; }

/// What was counted since the counts were `before`.
inline MarkCounts marks_since(const MarkCounts& before) {
  MarkCounts since = mark_counts;
  for (std::size_t m = 0; m < since.size(); ++m) since[m] -= before[m];
  return since;
}

}  // namespace touchstone::fast
