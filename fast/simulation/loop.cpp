#include "fast/simulation/loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/simulation/range.h"
#include "model/input_error.h"
#include "model/limits.h"

namespace touchstone::fast::world {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Limits at which a run stops and reports why. They are not derived; they end runs that would not end.
constexpr double stall_window = 0x1p-10;        // of a frame, or of the motion if that is shorter
constexpr std::int64_t max_iterations = 4'000;  // iterations in a stall window
constexpr int queries_per_iteration = 64;       // so many separation queries cost about one iteration, and count as one
// An iteration whose contact changes faster than time can advance counts as so many.
constexpr std::int64_t iterations_without_progress = 512;

// Impacts of one pair in one place. After that many, corners that collide in turn are slower by 2^32, or separate.
constexpr int most_impacts_in_place = 32;

// Rebound speeds: a pair in contact that separates no faster stays in contact until it is apart. Half of releases_above
// (loop_islands.cpp), so that no body is released by one rule and kept by the other.
constexpr double stays_below = 32;

Vec3 on_grid(const Vec3& P, double grid) {
  return grid * (P / grid).unaryExpr([](double x) { return std::floor(x + 0.5); });
}

const Motion& motion_of(const Scene& scene) {
  if (!scene.motion) throw InputError("motion", "is missing: a simulation needs one");
  return *scene.motion;
}

std::vector<BodyMotion> body_motions(const Scene& scene) {
  const Motion& motion = motion_of(scene);
  std::vector<BodyMotion> bodies;
  bodies.reserve(scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    bodies.emplace_back(scene.bodies[i], motion.start_times.empty() ? 0 : motion.start_times[i], scene.gravity);
  }
  refuse_beyond_doubles(scene, bodies);
  return bodies;
}

/// The least size of the bodies that move; 0 if there are none.
double least_size(const Scene& scene) {
  double least = infinite;
  for (const Body& body : scene.bodies) {
    if (!std::holds_alternative<Fixed>(body.mass)) least = std::min(least, size(body.shape));
  }
  return least < infinite ? least : 0;
}

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

/// The requested frame length, or a longer one so that there are at most 2^13 frames.
double frame_length(const Scene& scene, const SimulationOptions& options) {
  return std::max(options.frame, motion_of(scene).sample_times.back() * 0x1p-13);
}

std::string name(BodyId id) { return "bodies[" + std::to_string(id) + "]"; }

}  // namespace

Loop::Loop(const Scene& scene, const SimulationOptions& options)
    : scene_(&scene),
      options_(options),
      envelope_(touchstone::envelope(scene)),
      reach_(std::max(envelope_, 0x1p-8 * least_size(scene))),
      end_(motion_of(scene).sample_times.back()),
      bodies_(body_motions(scene)),
      queue_(bodies_.size()),
      rest_(bodies_.size()),
      island_of_(bodies_.size()),
      last_impact_(bodies_.size(), -never),
      impacts_(bodies_.size(), 0),
      acceleration_(bodies_.size(), scene.gravity),
      grid_of_boxes_(usual_extent(bodies_, frame_length(scene, options)), bodies_.size()) {
  options_.frame = frame_length(scene, options);
  if (options_.keep_events) done_.trajectory.events.emplace();
  if (options_.exact_momentum) set_up_exact_momentum();
}

Simulated Loop::run() {
  while (now_ < end_ && !done_.stopped) {
    begin_frame();
    while (!done_.stopped && process_next_event()) continue;
    if (done_.stopped) break;
    sample_until(frame_end_, true);
    now_ = frame_end_;
  }
  if (done_.stopped) {
    sample_until(now_, true);
    done_.trajectory.complete_until = now_;
  }
  done_.momentum = std::move(momentum_);
  return std::move(done_);
}

/// Processes the earliest event: an applied force, the end of an island's step or a predicted contact. Islands begin
/// their next step after all events of the current time. Returns false at the frame's end.
bool Loop::process_next_event() {
  const std::vector<AppliedForce>& forces = scene_->motion->forces;
  const double next_force = applied_forces_ < forces.size() ? forces[applied_forces_].time : never;
  const double next_contact = queue_.empty() ? never : queue_.top().time;
  const std::optional<BodyId> first_island = first_to_finish();
  const double next_step_end = first_island ? islands_.at(*first_island).until : never;
  const double next = std::min({next_force, next_contact, next_step_end});
  if (const std::optional<BodyId> island = next_waiting(); island && next > now_) {
    begin_step(*island);
    return true;
  }
  if (next > frame_end_) return false;
  if (next_step_end <= next) {
    finish_step(*first_island);
  } else if (next_force <= next_contact) {
    apply_force(forces[applied_forces_++]);
  } else {
    const PairEvent top = queue_.top();
    queue_.pop();
    process_pair_event(top);
  }
  return true;
}

/// The force acts from now on. As after an impact, the body's trajectory, box and predicted contacts are renewed, so
/// that no impact is missed.
void Loop::apply_force(const AppliedForce& force) {
  sample_until(force.time, false);
  now_ = std::max(now_, force.time);
  const auto id = static_cast<BodyId>(force.body);
  cut_step(id);
  const double from = std::max(now_, bodies_[id].path().since);
  const State state = island_of_[id] ? island_of(id)->state(id) : bodies_[id].state(from);
  if (rest_[id]) release(id, state);
  acceleration_[id] = scene_->gravity + bodies_[id].inverse_mass() * force.force_W;
  if (force.time > start_time(id)) {
    record({Event::Kind::force, now_, force.body, -1, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), state, {}});
  }
  if (Island* island = island_of(id)) return island->set_acceleration(id, acceleration_[id]);
  bodies_[id].restart(from, state, acceleration_[id]);
  if (bodies_[id].needs_restart(frame_end_)) restart(id);
  queue_.drop(id);
  update_proxy(id);
  schedule_all(id, id);
}

/// Computes the boxes that enclose the trajectories over the frame, the pairs whose boxes intersect, and for each pair
/// the lower bound of its time of impact.
void Loop::begin_frame() {
  ++done_.statistics.frames;
  frame_end_ = std::min(end_, static_cast<double>(done_.statistics.frames) * options_.frame);
  for (BodyId id = 0; id < bodies_.size(); ++id) {
    if (bodies_[id].needs_restart(frame_end_)) restart(id);
    if (moves(id) || done_.statistics.frames == 1) update_proxy(id);
  }
  for (BodyId a = 0; a < bodies_.size(); ++a) {
    if (!moves(a)) continue;
    for (const BodyId b : neighbours(a)) {
      if (!moves(b) || a < b) schedule(std::min(a, b), std::max(a, b), 0);
    }
  }
}

/// Advances the time to that of the pair. If the two are in contact: the response, with new boxes and predictions for
/// both. If the time was only a lower bound: a new bound.
void Loop::process_pair_event(const PairEvent& pair_event) {
  sample_until(pair_event.time, false);
  now_ = std::max(now_, pair_event.time);
  if (!makes_progress(pair_event)) return;
  if (rests_on(pair_event.a, pair_event.b)) return end_rest_phase(pair_event.a);
  if (rests_on(pair_event.b, pair_event.a)) return end_rest_phase(pair_event.b);
  if (island_of_[pair_event.a] || island_of_[pair_event.b]) return process_island_event(pair_event);
  const BodyMotion &a = bodies_[pair_event.a], &b = bodies_[pair_event.b];
  if (!positions_resolved(a, b, now_))
    return stop(pair_event, "rounding moves the two by more than a thousandth of the smaller one");
  Touch touch = world::touch(a, b, now_, memory(pair_event.a, pair_event.b));
  if (touch.gap > std::max(envelope_, 2 * clearance(a, b, now_, infinite))) return recheck(pair_event);
  if (!has_closed_form(a, b)) touch = fastest_approach(pair_event).value_or(touch);
  respond(pair_event, touch);
  stop_if_endless(pair_event);
}

/// Counts an iteration. Returns false, and stops the run, if the stall window has had too many.
bool Loop::makes_progress(const PairEvent& pair_event) {
  if (now_ > stall_window_end_) {
    stall_window_end_ = now_ + stall_window * std::min(options_.frame, end_);
    iterations_ = 0;
  }
  if (++iterations_ <= max_iterations + 16 * static_cast<std::int64_t>(bodies_.size())) return true;
  stop(pair_event, "time hardly goes on");
  return false;
}

void Loop::stop_if_endless(const PairEvent& pair_event) {
  if (events_ > options_.most_events) stop(pair_event, "more events than allowed");
  if (done_.statistics.of(Event::Kind::micro_collision) > options_.most_micro_bounces) {
    stop(pair_event, "a contact that rests on hops alone takes more of them than allowed");
  }
}

/// The contact point of the pair that approaches fastest; the first one of several.
std::optional<Touch> Loop::fastest_approach(const PairEvent& pair_event) {
  Island pair(envelope_, envelope_);
  pair.add(island_body(pair_event.a));
  pair.add(island_body(pair_event.b));
  if (!pair.link(pair_event.a, pair_event.b)) return std::nullopt;
  const std::optional<ImpactCandidate> found = pair.fastest_approach();
  return found ? std::optional(found->touch) : std::nullopt;
}

/// Schedules the pair again after a time in which the two cannot approach noticeably. They separate, but perhaps no
/// faster than rounding can resolve.
void Loop::schedule_later(const PairEvent& pair_event) {
  if (island_of_[pair_event.a] || island_of_[pair_event.b]) return defer_separating_pair(pair_event);
  const BodyMotion &a = bodies_[pair_event.a], &b = bodies_[pair_event.b];
  double speed = (b.path().velocity(now_) - a.path().velocity(now_)).lpNorm<1>();
  double acceleration = (b.path().a - a.path().a).lpNorm<1>();
  for (const BodyMotion* body : {&a, &b}) {
    if (body->fixed() || body->kind() != Kind::other) continue;
    speed += body->ballistic().rate() * body->radius();
    acceleration += body->ballistic().acceleration_per_radius() * body->radius();
  }
  const double near = envelope_ / 16, grain = now_ * 0x1p-51;
  const double step = 2 * near / (speed + std::sqrt(speed * speed + 2 * acceleration * near));
  if (step < grain) iterations_ += iterations_without_progress;
  schedule(pair_event.a, pair_event.b, now_ + std::max(step, grain));
}

/// Decides what a contact does. It is an impact, unless it is so slow that a micro-bounce would stay within the
/// envelope: then the body rests in closed form, or the pair joins an island, or with `micro_collisions` it
/// micro-bounces instead. (A body comes down about as fast as it went up; up to twice the micro-bounce speed still
/// counts.) Micro-bounces after an impact that would all be so low are completed at once: they end 2v/(press (1 − e))
/// later.
void Loop::respond(const PairEvent& pair_event, const Touch& touch) {
  const BodyMotion &a = bodies_[pair_event.a], &b = bodies_[pair_event.b];
  const State at_a = state(pair_event.a), at_b = state(pair_event.b);
  const Coefficients c = coefficients(a, b, scene_->motion->law);
  const double u_n = normal_velocity(a, at_a, b, at_b, touch), presses = pressing_acceleration(a, b, touch);
  const bool in_contact = is_in_contact(pair_event.a) || is_in_contact(pair_event.b) ||
                          last_impact_[pair_event.a] == now_ || last_impact_[pair_event.b] == now_;
  const double turns = presses <= 0 && c.restitution < 1 ? centripetal_bound(pair_event.a, pair_event.b) : 0;
  const double bounce_speed =
      in_contact ? rebound_speed(pair_event.a, pair_event.b) : micro_bounce_speed(std::max(presses, turns), envelope_);
  const double rebound = c.restitution * -u_n;
  if (u_n > (in_contact ? stays_below * bounce_speed : bounce_speed / 16)) return schedule_later(pair_event);
  if (!in_contact && bounce_speed > 0 && -u_n <= bounce_speed && try_rest(pair_event, touch, {}, now_)) return;
  if (bounce_speed > 0 && -u_n <= 2 * bounce_speed && (in_contact || !can_rest(pair_event, touch))) {
    if (!options_.micro_collisions) return merge_islands(pair_event) ? void() : schedule_later(pair_event);
    return apply_impulse(Event::Kind::micro_collision, pair_event, touch,
                         world::micro_collision(a, at_a, b, at_b, touch, c, bounce_speed));
  }
  if (!(u_n < 0)) return schedule_later(pair_event);
  if (c.restitution < 1 && collides_endlessly(pair_event, u_n) && merge_islands(pair_event)) return;
  apply_impulse(Event::Kind::impact, pair_event, touch, impact(a, at_a, b, at_b, touch, c));
  if (!in_contact && rebound <= bounce_speed && c.restitution < 1) {
    try_rest(pair_event, touch, {rebound, (1 + c.restitution) / 2},
             now_ + 2 * rebound / (presses * (1 - c.restitution)));
  }
}

/// If two bodies touch in a face or an edge and lose energy, an impact at one corner makes the others approach, each
/// time more slowly, and without applied accelerations this never ends. So the two join an island after many impacts
/// between which they moved no farther than the envelope, and the remaining approach is removed at all contact points
/// at once (Island::remove_approach).
bool Loop::collides_endlessly(const PairEvent& pair_event, double u_n) {
  if (has_closed_form(bodies_[pair_event.a], bodies_[pair_event.b])) return false;
  PairMemory& memory = memory_[key(pair_event.a, pair_event.b)];
  const bool again = (now_ - memory.last_impact) * -u_n <= envelope_;
  memory.impacts_in_place = again ? memory.impacts_in_place + 1 : 1;
  memory.last_impact = now_;
  return memory.impacts_in_place > most_impacts_in_place;
}

/// Applies an impulse, and sets the new trajectories of the two bodies.
void Loop::apply_impulse(Event::Kind kind, const PairEvent& pair_event, const Touch& touch, ImpactResult result) {
  if (grid_ > 0) apply_exact_momentum(pair_event, result);
  const State a{state(pair_event.a).X_WB, result.after_a}, b{state(pair_event.b).X_WB, result.after_b};
  done_.statistics.loss += result.loss;
  if (bodies_[pair_event.a].fixed()) done_.statistics.to_fixed += result.P_A_W;
  if (bodies_[pair_event.b].fixed()) done_.statistics.to_fixed -= result.P_A_W;
  record({kind, now_, static_cast<int>(pair_event.a), static_cast<int>(pair_event.b), touch.p_WC, touch.nhat_BA_W,
          result.P_A_W, a, b});
  for (const BodyId id : {pair_event.a, pair_event.b}) {
    if (rest_[id]) release(id, id == pair_event.a ? a : b);
    if (bodies_[id].fixed()) continue;
    last_impact_[id] = now_;
    ++impacts_[id];
  }
  set_trajectory(pair_event.a, a);
  set_trajectory(pair_event.b, b);
  if (!bodies_[pair_event.a].fixed()) schedule_all(pair_event.a, pair_event.a);
  if (!bodies_[pair_event.b].fixed())
    schedule_all(pair_event.b, bodies_[pair_event.a].fixed() ? pair_event.b : pair_event.a);
}

/// Emits the states at the scene's sample times before `time`, and if `over` also at `time`, after its events.
void Loop::sample_until(double time, bool over) {
  const std::vector<double>& times = scene_->motion->sample_times;
  for (; sampled_ < times.size() && (over ? times[sampled_] <= time : times[sampled_] < time); ++sampled_) {
    std::vector<State>& states = done_.trajectory.states.emplace_back();
    for (const BodyMotion& body : bodies_) states.push_back(body.state(times[sampled_]));
    for (const auto& [key, island] : islands_) {
      const std::vector<State> island_states = island.states_at(times[sampled_]);
      for (std::size_t i = 0; i < island_states.size(); ++i) {
        if (!island.bodies()[i].fixed()) states[island.bodies()[i].id] = island_states[i];
      }
    }
  }
}

double Loop::start_time(BodyId id) const {
  const std::vector<double>& since = scene_->motion->start_times;
  return since.empty() ? 0 : since[id];
}

/// Restarts a body's trajectory from its reported state before doubles lose its orientation. For a tumbling body a
/// frame may be too long even so; then the run stops.
void Loop::restart(BodyId id) {
  const double from = std::max(now_, bodies_[id].path().since);
  bodies_[id].restart(from, bodies_[id].state(from), bodies_[id].path().a);
  if (!bodies_[id].follows(frame_end_)) {
    done_.stopped = {now_, static_cast<int>(id), -1, "tumbles too fast to be followed for a frame"};
  }
}

void Loop::update_proxy(BodyId id) {
  const double from = std::max(now_, bodies_[id].path().since);
  const Island* island = island_of(id);
  const double until = island ? std::min(island->until, frame_end_) : frame_end_;
  grid_of_boxes_.update_proxy(
      id, bodies_[id].box(from, std::max(from, until), envelope_ + (island ? island->margin + reach_ / 4 : 0)));
}

/// Returns the bodies whose boxes intersect that of the body, and prefetches their trajectories.
std::span<const BodyId> Loop::neighbours(BodyId id) {
  const std::span<const BodyId> found = grid_of_boxes_.neighbours(id);
  for (const BodyId other : found) __builtin_prefetch(&bodies_[other]);
  return found;
}

void Loop::schedule_all(BodyId id, BodyId but) {
  for (const BodyId other : neighbours(id)) {
    if (other != but) schedule(std::min(id, other), std::max(id, other), now_);
  }
}

/// Predicts the first contact of a pair and enqueues it, if it may be within the frame.
void Loop::schedule(BodyId id_a, BodyId id_b, double from) {
  const BodyMotion &a = bodies_[id_a], &b = bodies_[id_b];
  if (a.fixed() && b.fixed()) return;
  const bool is_point = has_closed_form(a, b);
  if (!is_point) from = std::max(from, now_);
  from = std::max({from, a.path().since, b.path().since});
  double until = frame_end_;
  Inflation inflation{from};
  const PairMemory* remembered = island_of_[id_a] || island_of_[id_b] ? &memory_[key(id_a, id_b)] : nullptr;
  const bool seen_separating = remembered && remembered->impacts == impacts_[id_a] + impacts_[id_b];
  for (const BodyId id : {id_a, id_b}) {
    const Island* island = island_of(id);
    if (!island) continue;
    if (island->waits || island->connects(id_a, id_b) || (seen_separating && remembered->not_queried_at == now_))
      return;
    until = std::min(until, island->until);
    if (is_point) {
      inflation.at_first += island->margin;
    } else {
      inflation.at_first += island->drift() * (from - island->since);
      inflation.rate += island->drift();
    }
  }
  // Balls of islands well within reach of each other take their steps together.
  if (is_point && inflation.at_first > 0 && follows_steps(id_a) && follows_steps(id_b))
    inflation.at_first += reach_ / 4;
  if (from > until) return;
  ++done_.statistics.pairs;
  PairMemory& pair_memory = memory(id_a, id_b);
  if (from == std::max(start_time(id_a), start_time(id_b)))
    refuse_overlap(id_a, id_b, world::touch(a, b, from, pair_memory));
  const RestingContact* rest = rests_on(id_a, id_b) ? &*rest_[id_a] : rests_on(id_b, id_a) ? &*rest_[id_b] : nullptr;
  const double envelope = seen_separating && remembered->separating_at == now_ ? 0 : envelope_;
  const double time = rest ? rest->until : first_contact(a, b, from, until, envelope, inflation, pair_memory);
  iterations_ += pair_memory.queries / queries_per_iteration;
  if (time <= frame_end_) queue_.put({std::max(time, now_), id_a, id_b});
}

PairMemory& Loop::memory(BodyId a, BodyId b) {
  return has_closed_form(bodies_[a], bodies_[b]) ? no_memory_ : memory_[key(a, b)];
}

void Loop::refuse_overlap(BodyId a, BodyId b, const Touch& touch) const {
  if (touch.gap >= -clearance(bodies_[a], bodies_[b], start_time(a), infinite)) return;
  throw InputError(name(a),
                   "overlaps " + name(b) + " at the start" +
                       (has_closed_form(bodies_[a], bodies_[b]) ? " by " + std::to_string(-touch.gap) + " m" : ""));
}

void Loop::set_trajectory(BodyId id, const State& state) {
  if (bodies_[id].fixed()) return;
  if (Island* island = island_of(id)) return island->set_velocity(id, state.velocity);
  bodies_[id].restart(now_, state, acceleration_[id]);
  if (bodies_[id].needs_restart(frame_end_)) restart(id);
  queue_.drop(id);
  update_proxy(id);
}

void Loop::record(const Event& event) {
  ++done_.statistics.count[static_cast<std::size_t>(event.kind)];
  ++events_;
  if (done_.trajectory.events) done_.trajectory.events->push_back(event);
}

void Loop::stop(const PairEvent& pair_event, const std::string& why) {
  done_.stopped = {now_, static_cast<int>(pair_event.a), static_cast<int>(pair_event.b), why};
}

/// Momenta and impulses are rounded to multiples of grid_, so that their sums are exact. It is a power of two, from
/// 2^-50 to 2^-49 of the greatest momentum that a body can have while energy does not rise.
void Loop::set_up_exact_momentum() {
  if (!scene_->gravity.isZero(0) || !scene_->motion->forces.empty()) {
    throw InputError("gravity", "changes momentum; it can be kept exact only without gravity and pushes");
  }
  double energy = 0, heaviest = 0;
  for (const BodyMotion& body : bodies_) {
    if (body.fixed()) continue;
    const Vec3 w = body.path().w;
    energy += body.path().v.squaredNorm() / body.inverse_mass() / 2 + w.squaredNorm() * body.inertia().trace() / 2;
    heaviest = std::max(heaviest, 1 / body.inverse_mass());
  }
  int exponent = 0;
  std::frexp(std::sqrt(2 * heaviest * energy), &exponent);
  grid_ = std::ldexp(1, exponent - 50);
  for (const BodyMotion& body : bodies_) {
    momentum_.push_back(body.fixed() ? Vec3(Vec3::Zero()) : on_grid(body.path().v / body.inverse_mass(), grid_));
  }
  done_.momentum_before = momentum_;
}

void Loop::apply_exact_momentum(const PairEvent& pair_event, ImpactResult& result) {
  result.P_A_W = on_grid(result.P_A_W, grid_);
  momentum_[pair_event.a] += result.P_A_W;
  momentum_[pair_event.b] -= result.P_A_W;
  if (!bodies_[pair_event.a].fixed())
    result.after_a.v_WBcm = bodies_[pair_event.a].inverse_mass() * momentum_[pair_event.a];
  if (!bodies_[pair_event.b].fixed())
    result.after_b.v_WBcm = bodies_[pair_event.b].inverse_mass() * momentum_[pair_event.b];
}

}  // namespace touchstone::fast::world
