#include "fast/simulation/prediction/collision_schedule.h"

#include <algorithm>

#include "model/input_error.h"

namespace touchstone::fast::simulation {
namespace {

/// An extent that nine of ten boxes of moving bodies do not exceed in a frame, even at twice the speed, since impacts
/// spread the speeds. Longer boxes cost each query one more level of the grid.
double usual_extent(const std::vector<BodyMotion>& bodies, double frame) {
  std::vector<double> extents;
  for (const BodyMotion& body : bodies) {
    if (body.fixed()) continue;
    const Path& path = body.path();
    extents.push_back(2 * body.radius() +
                      2 * frame * (path.v.cwiseAbs().maxCoeff() + frame * path.a.cwiseAbs().maxCoeff()));
  }
  if (extents.empty()) return 1;
  const auto most = extents.begin() + static_cast<std::ptrdiff_t>(9 * extents.size() / 10);
  std::ranges::nth_element(extents, most);
  return *most;
}

std::uint64_t key(BodyId a, BodyId b) { return std::uint64_t{a} << 32 | b; }

std::string name(BodyId id) { return "bodies[" + std::to_string(id) + "]"; }

}  // namespace

/// The interval and the distance of a search for the first contact of a pair.
struct CollisionSchedule::Search {
  double from = 0, until = 0;  ///< s
  double envelope = 0;
  Deviation deviation;
};

CollisionSchedule::CollisionSchedule(const World& world, const Islands& islands, const RestingBodies& rests,
                                     double frame, Statistics& statistics, StallGuard& guard)
    : world_(&world),
      islands_(&islands),
      rests_(&rests),
      statistics_(&statistics),
      guard_(&guard),
      frame_(frame),
      queue_(world.bodies().size()),
      grid_(usual_extent(world.bodies(), frame), world.bodies().size()) {}

void CollisionSchedule::begin_frame() {
  ++statistics_->frames;
  frame_end_ = std::min(world_->end(), static_cast<double>(statistics_->frames) * frame_);
}

void CollisionSchedule::predict_frame() {
  const auto bodies = static_cast<BodyId>(world_->bodies().size());
  for (BodyId id = 0; id < bodies; ++id) {
    if (is_queried(id) || statistics_->frames == 1) update_proxy(id);
  }
  for (BodyId a = 0; a < bodies; ++a) {
    if (!is_queried(a)) continue;
    for (const BodyId b : neighbours(a)) {
      if (!is_queried(b) || a < b) predict(std::min(a, b), std::max(a, b), 0);
    }
  }
}

PairEvent CollisionSchedule::pop() {
  const PairEvent top = queue_.top();
  queue_.pop();
  return top;
}

void CollisionSchedule::trajectory_changed(BodyId id) {
  queue_.drop(id);
  update_proxy(id);
}

void CollisionSchedule::update_proxy(BodyId id) {
  const BodyMotion& body = world_->body(id);
  const double from = std::max(world_->now(), body.path().since);
  const Island* island = islands_->of(id);
  const double until = island ? std::min(island->until(), frame_end_) : frame_end_;
  grid_.update_proxy(id,
                     body.box(from, std::max(from, until),
                              world_->envelope() + (island ? island->deviation().margin + world_->reach() / 4 : 0)));
}

std::span<const BodyId> CollisionSchedule::neighbours(BodyId id) {
  const std::span<const BodyId> found = grid_.neighbours(id);
  for (const BodyId other : found) __builtin_prefetch(&world_->body(other));
  return found;
}

void CollisionSchedule::predict_all(BodyId id, BodyId but) {
  for (const BodyId other : neighbours(id)) {
    if (other != but) predict(std::min(id, other), std::max(id, other), world_->now());
  }
}

void CollisionSchedule::predict(BodyId id_a, BodyId id_b, double from) {
  const BodyMotion &a = world_->body(id_a), &b = world_->body(id_b);
  if (a.fixed() && b.fixed()) return;
  const std::optional<Search> search = search_of(id_a, id_b, from);
  if (!search) return;
  ++statistics_->pairs;
  if (search->from == std::max(world_->start_time(id_a), world_->start_time(id_b)))
    refuse_overlap(id_a, id_b, search->from);
  PairMemory& pair_memory = search_memory(id_a, id_b);
  const RestingContact* rest = rest_of(id_a, id_b);
  const double time =
      rest ? rest->until
           : first_contact(a, b, search->from, search->until, search->envelope, search->deviation, pair_memory);
  guard_->count_queries(pair_memory.queries);
  if (time <= frame_end_) queue_.put({std::max(time, world_->now()), id_a, id_b});
}

/// None if the pair must not be queried now: an island waits for its step, or has the pair as a contact pair, or could
/// not decide in this step whether the two separate; or the interval is empty. Bodies of islands are inflated, since
/// the trajectories that represent their steps are not exact.
std::optional<CollisionSchedule::Search> CollisionSchedule::search_of(BodyId id_a, BodyId id_b, double from) {
  const BodyMotion &a = world_->body(id_a), &b = world_->body(id_b);
  const double now = world_->now();
  const bool is_point = has_closed_form(a, b);
  if (!is_point) from = std::max(from, now);
  from = std::max({from, a.path().since, b.path().since});
  // Bodies that touch at the end of the motion provably overlap only later: so their search takes the whole frame, and
  // a motion that ends earlier has the same events until then.
  const double whole_frame = std::max(frame_end_, static_cast<double>(statistics_->frames) * frame_);
  const bool takes_whole = !is_point && !a.needs_restart(whole_frame) && !b.needs_restart(whole_frame);
  Search search{from, takes_whole ? whole_frame : frame_end_, world_->envelope(), {{from}, from}};
  const Island* const island_of[] = {islands_->of(id_a), islands_->of(id_b)};
  if (island_of[0] || island_of[1]) {
    const PairMemory& remembered = memory(id_a, id_b);
    const bool seen_separating = remembered.impacts == world_->impacts(id_a, id_b);
    for (const Island* island : island_of) {
      if (!island) continue;
      if (island->waits() || island->graph().connects(id_a, id_b) ||
          (seen_separating && remembered.not_queried_at == now))
        return {};
      search.until = std::min(search.until, island->until());
      if (is_point) {
        search.deviation.inflation.at_first += island->deviation().margin;
        search.deviation.since = std::min(search.deviation.since, island->since());
        search.deviation.acceleration += island->deviation().acceleration;
      } else {
        search.deviation.inflation.at_first += island->drift() * (from - island->since());
        search.deviation.inflation.rate += island->drift();
      }
    }
    if (seen_separating && remembered.separating_at == now) search.envelope = 0;
    // Balls of islands well within reach of each other take their steps together.
    if (is_point && search.deviation.inflation.at_first > 0 && islands_->follows_steps(id_a) &&
        islands_->follows_steps(id_b))
      search.deviation.inflation.at_first += world_->reach() / 4;
  }
  if (from > search.until) return {};
  return search;
}

PairMemory& CollisionSchedule::memory(BodyId a, BodyId b) { return memory_[key(a, b)]; }

PairMemory& CollisionSchedule::search_memory(BodyId a, BodyId b) {
  return has_closed_form(world_->body(a), world_->body(b)) ? no_memory_ : memory(a, b);
}

Touch CollisionSchedule::nearest_points(BodyId a, BodyId b, double t) {
  return touch(world_->body(a), world_->body(b), t, search_memory(a, b));
}

/// A resting contact is large, and its support is always fixed, so that most pairs skip the look-up.
const RestingContact* CollisionSchedule::rest_of(BodyId a, BodyId b) const {
  if (world_->body(b).fixed() && rests_->rests_on(a, b)) return rests_->of(a);
  if (world_->body(a).fixed() && rests_->rests_on(b, a)) return rests_->of(b);
  return nullptr;
}

void CollisionSchedule::refuse_overlap(BodyId a, BodyId b, double t) {
  const BodyMotion &A = world_->body(a), &B = world_->body(b);
  const Touch touch = nearest_points(a, b, t);
  if (touch.gap >= -clearance(A, B, t, never)) return;
  throw InputError(name(a), "overlaps " + name(b) + " at the start" +
                                (has_closed_form(A, B) ? " by " + std::to_string(-touch.gap) + " m" : ""));
}

}  // namespace touchstone::fast::simulation
