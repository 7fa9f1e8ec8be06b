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

// When a run is given up: nothing derives these, they end what would not end, and a run that meets them says so.
constexpr double sliver = 0x1p-10;        // of a frame, or of the flight if that is shorter
constexpr std::int64_t patience = 4'000;  // turns in a sliver
constexpr int looks_of_a_turn = 64;       // where a pair takes more, each so many count as a turn: it costs about one
constexpr std::int64_t lost_patience = 512;  // turns that one counts for in which contact changes faster than time can

// Impacts of one pair in one place: by then corners that strike in turn are slower than they were by 2^32, or part.
constexpr int most_at_once = 32;

// Hops: what is held and parts no faster stays so, until it is apart. Half of what lets go (loop_group.cpp), so that
// nobody is let go by one rule and held by the other.
constexpr double parts_slowly = 32;

Vec3 on_grid(const Vec3& P, double grid) {
  return grid * (P / grid).unaryExpr([](double x) { return std::floor(x + 0.5); });
}

const Flight& flight_of(const Scene& scene) {
  if (!scene.flight) throw InputError("flight", "is missing: a simulation needs one");
  return *scene.flight;
}

std::vector<Mover> movers(const Scene& scene) {
  const Flight& flight = flight_of(scene);
  std::vector<Mover> bodies;
  bodies.reserve(scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    bodies.emplace_back(scene.bodies[i], flight.since.empty() ? 0 : flight.since[i], scene.gravity);
  }
  refuse_beyond_doubles(scene, bodies);
  return bodies;
}

/// Of the bodies that move.
double least_size(const Scene& scene) {
  double least = infinite;
  for (const Body& body : scene.bodies) {
    if (!std::holds_alternative<Fixed>(body.mass)) least = std::min(least, size(body.shape));
  }
  return least < infinite ? least : 0;
}

/// As long as most boxes of a frame: nine of ten that move are no longer, if they go twice as far. Impacts spread
/// speeds out, and what is longer than all others costs each question one more look.
double usual_extent(const std::vector<Mover>& bodies, double frame) {
  std::vector<double> extents;
  for (const Mover& body : bodies) {
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

/// Frames are as long as asked, but never more than 2^13 of them.
double frame_length(const Scene& scene, const SimulationOptions& options) {
  return std::max(options.frame, flight_of(scene).times.back() * 0x1p-13);
}

std::string name(BodyId id) { return "bodies[" + std::to_string(id) + "]"; }

}  // namespace

Loop::Loop(const Scene& scene, const SimulationOptions& options)
    : scene_(&scene),
      options_(options),
      envelope_(touchstone::envelope(scene)),
      reach_(std::max(envelope_, 0x1p-8 * least_size(scene))),
      end_(flight_of(scene).times.back()),
      bodies_(movers(scene)),
      heap_(bodies_.size()),
      rest_(bodies_.size()),
      group_of_(bodies_.size()),
      struck_(bodies_.size(), -never),
      strikes_(bodies_.size(), 0),
      pull_(bodies_.size(), scene.gravity),
      tiling_(usual_extent(bodies_, frame_length(scene, options)), bodies_.size()) {
  options_.frame = frame_length(scene, options);
  if (options_.keep_events) done_.trajectory.events.emplace();
  if (options_.exact_momentum) keep_momentum();
}

Simulated Loop::run() {
  while (now_ < end_ && !done_.stopped) {
    begin_frame();
    while (!done_.stopped && turn()) continue;
    if (done_.stopped) break;
    look_until(frame_end_, true);
    now_ = frame_end_;
  }
  if (done_.stopped) {
    look_until(now_, true);
    done_.trajectory.complete_until = now_;
  }
  done_.momentum = std::move(momentum_);
  return std::move(done_);
}

/// Whose turn it is next within the frame: a push's, a group's or a pair's; false: nobody's. Groups take their next
/// step once all that happens now has happened.
bool Loop::turn() {
  const std::vector<Push>& pushes = scene_->flight->pushes;
  const double pushed = pushed_ < pushes.size() ? pushes[pushed_].time : never;
  const double due = heap_.empty() ? never : heap_.top().time;
  const std::optional<BodyId> stepping = first_to_arrive();
  const double arrives = stepping ? groups_.at(*stepping).until : never;
  const double next = std::min({pushed, due, arrives});
  if (const std::optional<BodyId> group = waiting(); group && next > now_) {
    begin(*group);
    return true;
  }
  if (next > frame_end_) return false;
  if (arrives <= next) {
    arrive(*stepping);
  } else if (pushed <= due) {
    push(pushes[pushed_++]);
  } else {
    const Due top = heap_.top();
    heap_.pop();
    attend(top);
  }
  return true;
}

/// From now on the force acts. As after an impact, the body's path and box are made anew, and so is whom it may meet: a
/// force that nobody foresaw misses no impact.
void Loop::push(const Push& push) {
  look_until(push.time, false);
  now_ = std::max(now_, push.time);
  const auto id = static_cast<BodyId>(push.body);
  cut(id);
  const double from = std::max(now_, bodies_[id].path().since);
  const State state = group_of_[id] ? group_of(id)->state(id) : bodies_[id].state(from);
  if (rest_[id]) release(id, state);
  pull_[id] = scene_->gravity + bodies_[id].inverse_mass() * push.force_W;
  if (push.time > start(id)) {
    record({Event::Kind::push, now_, push.body, -1, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), state, {}});
  }
  if (Group* group = group_of(id)) return group->set_pull(id, pull_[id]);
  bodies_[id].fly(from, state, pull_[id]);
  if (bodies_[id].tires(frame_end_)) begin_anew(id);
  heap_.drop(id);
  file(id);
  watch_all(id, id);
}

/// Boxes that enclose the paths over the frame; the pairs whose boxes intersect; for each, when it may first meet.
void Loop::begin_frame() {
  ++done_.books.frames;
  frame_end_ = std::min(end_, static_cast<double>(done_.books.frames) * options_.frame);
  for (BodyId id = 0; id < bodies_.size(); ++id) {
    if (bodies_[id].tires(frame_end_)) begin_anew(id);
    if (moves(id) || done_.books.frames == 1) file(id);
  }
  for (BodyId a = 0; a < bodies_.size(); ++a) {
    if (!moves(a)) continue;
    for (const BodyId b : near(a)) {
      if (!moves(b) || a < b) watch(std::min(a, b), std::max(a, b), 0);
    }
  }
}

/// Time goes on to the pair that may meet first. If it does: the impact, new boxes for the two, and the heap made true
/// of them; if it was a bound only, a new bound.
void Loop::attend(const Due& due) {
  look_until(due.time, false);
  now_ = std::max(now_, due.time);
  if (!goes_on(due)) return;
  if (rests_on(due.a, due.b)) return change(due.a);
  if (rests_on(due.b, due.a)) return change(due.b);
  if (group_of_[due.a] || group_of_[due.b]) return attend_held(due);
  const Mover &a = bodies_[due.a], &b = bodies_[due.b];
  if (!places_tell(a, b, now_)) return stop(due, "rounding moves the two by more than a thousandth of the smaller one");
  Touch touch = world::touch(a, b, now_, memory(due.a, due.b));
  if (touch.gap > std::max(envelope_, 2 * clearance(a, b, now_, infinite))) return not_yet(due);
  if (!has_closed_form(a, b)) touch = foremost(due).value_or(touch);
  meet(due, touch);
  stop_if_endless(due);
}

/// Counts a turn. False: so many have come within a sliver of a frame that its end is not in sight.
bool Loop::goes_on(const Due& due) {
  if (now_ > sliver_end_) {
    sliver_end_ = now_ + sliver * std::min(options_.frame, end_);
    turns_ = 0;
  }
  if (++turns_ <= patience + 16 * static_cast<std::int64_t>(bodies_.size())) return true;
  stop(due, "time hardly goes on");
  return false;
}

void Loop::stop_if_endless(const Due& due) {
  if (events_ > options_.most_events) stop(due, "more events than allowed");
  if (done_.books.of(Event::Kind::micro_collision) > options_.most_hops) {
    stop(due, "a contact that rests on hops alone takes more of them than allowed");
  }
}

/// Of all points at which the two touch, the one that approaches fastest; the first of several.
std::optional<Touch> Loop::foremost(const Due& due) {
  Group pair(envelope_, envelope_);
  pair.add(rider(due.a));
  pair.add(rider(due.b));
  if (!pair.link(due.a, due.b)) return std::nullopt;
  const std::optional<Strike> found = pair.foremost();
  return found ? std::optional(found->touch) : std::nullopt;
}

/// Later, by a time in which the two hardly approach: they part, though no faster than rounding can tell.
void Loop::watch_later(const Due& due) {
  if (group_of_[due.a] || group_of_[due.b]) return part_held(due);
  const Mover &a = bodies_[due.a], &b = bodies_[due.b];
  double speed = (b.path().velocity(now_) - a.path().velocity(now_)).lpNorm<1>();
  double pull = (b.path().a - a.path().a).lpNorm<1>();
  for (const Mover* body : {&a, &b}) {
    if (body->fixed() || body->kind() != Kind::other) continue;
    speed += body->flight().rate() * body->radius();
    pull += body->flight().curl() * body->radius();
  }
  const double near = envelope_ / 16, grain = now_ * 0x1p-51;
  const double step = 2 * near / (speed + std::sqrt(speed * speed + 2 * pull * near));
  if (step < grain) turns_ += lost_patience;
  watch(due.a, due.b, now_ + std::max(step, grain));
}

/// A meeting is an impact, unless it is so slow that the hop after it would stay within the envelope: then the body
/// rests, or where there is no closed form for that, hops that high in its stead (it comes down about as fast as it
/// went up: twice as fast still counts). The hops after an impact that would all be so low are completed at once: they
/// end 2v/(press (1 − e)) later.
void Loop::meet(const Due& due, const Touch& touch) {
  const Mover &a = bodies_[due.a], &b = bodies_[due.b];
  const State at_a = state(due.a), at_b = state(due.b);
  const Coefficients c = coefficients(a, b, scene_->flight->law);
  const double u_n = approach(a, at_a, b, at_b, touch), presses = press(a, b, touch);
  const bool held = is_held(due.a) || is_held(due.b) || struck_[due.a] == now_ || struck_[due.b] == now_;
  const double turns = presses <= 0 && c.restitution < 1 ? swing(due.a, due.b) : 0;
  const double hop = held ? hop_of(due.a, due.b) : least_speed(std::max(presses, turns), envelope_);
  const double rebound = c.restitution * -u_n;
  if (u_n > (held ? parts_slowly * hop : hop / 16)) return watch_later(due);
  if (!held && hop > 0 && -u_n <= hop && hold(due, touch, {}, now_)) return;
  if (hop > 0 && -u_n <= 2 * hop && (held || !can_rest(due, touch))) {
    if (!options_.micro_collisions) return join(due) ? void() : watch_later(due);
    return strike(Event::Kind::micro_collision, due, touch, world::micro_collision(a, at_a, b, at_b, touch, c, hop));
  }
  if (!(u_n < 0)) return watch_later(due);
  if (c.restitution < 1 && strikes_endlessly(due, u_n) && join(due)) return;
  strike(Event::Kind::impact, due, touch, impact(a, at_a, b, at_b, touch, c));
  if (!held && rebound <= hop && c.restitution < 1) {
    hold(due, touch, {rebound, (1 + c.restitution) / 2}, now_ + 2 * rebound / (presses * (1 - c.restitution)));
  }
}

/// Where two touch in a face or an edge and lose energy, an impact at one corner makes the others approach, each time
/// more slowly: without an end, where nothing pulls the two together. So after some impacts between which the two moved
/// no farther than the envelope they hold each other, and what is left is taken from all feet at once (settle).
bool Loop::strikes_endlessly(const Due& due, double u_n) {
  if (has_closed_form(bodies_[due.a], bodies_[due.b])) return false;
  Memory& memory = memory_[key(due.a, due.b)];
  const bool again = (now_ - memory.struck) * -u_n <= envelope_;
  memory.at_once = again ? memory.at_once + 1 : 1;
  memory.struck = now_;
  return memory.at_once > most_at_once;
}

/// What an impulse does, and the two bodies on their new ways.
void Loop::strike(Event::Kind kind, const Due& due, const Touch& touch, Hit hit) {
  if (grid_ > 0) move_exactly(due, hit);
  const State a{state(due.a).X_WB, hit.after_a}, b{state(due.b).X_WB, hit.after_b};
  done_.books.loss += hit.loss;
  if (bodies_[due.a].fixed()) done_.books.to_fixed += hit.P_A_W;
  if (bodies_[due.b].fixed()) done_.books.to_fixed -= hit.P_A_W;
  record({kind, now_, static_cast<int>(due.a), static_cast<int>(due.b), touch.p_WC, touch.nhat_BA_W, hit.P_A_W, a, b});
  for (const BodyId id : {due.a, due.b}) {
    if (rest_[id]) release(id, id == due.a ? a : b);
    if (bodies_[id].fixed()) continue;
    struck_[id] = now_;
    ++strikes_[id];
  }
  set_out(due.a, a);
  set_out(due.b, b);
  if (!bodies_[due.a].fixed()) watch_all(due.a, due.a);
  if (!bodies_[due.b].fixed()) watch_all(due.b, bodies_[due.a].fixed() ? due.b : due.a);
}

/// The states at the scene's times up to this one; at the time itself only once its events are over.
void Loop::look_until(double time, bool over) {
  const std::vector<double>& times = scene_->flight->times;
  for (; looked_ < times.size() && (over ? times[looked_] <= time : times[looked_] < time); ++looked_) {
    std::vector<State>& states = done_.trajectory.states.emplace_back();
    for (const Mover& body : bodies_) states.push_back(body.state(times[looked_]));
    for (const auto& [key, group] : groups_) {
      const std::vector<State> held = group.states_at(times[looked_]);
      for (std::size_t i = 0; i < held.size(); ++i) {
        if (!group.riders()[i].fixed()) states[group.riders()[i].id] = held[i];
      }
    }
  }
}

double Loop::start(BodyId id) const {
  const std::vector<double>& since = scene_->flight->since;
  return since.empty() ? 0 : since[id];
}

/// Before doubles lose how a body is turned it sets out anew from where it is said to be. For one that tumbles a frame
/// may be too long even so.
void Loop::begin_anew(BodyId id) {
  const double from = std::max(now_, bodies_[id].path().since);
  bodies_[id].fly(from, bodies_[id].state(from), bodies_[id].path().a);
  if (!bodies_[id].follows(frame_end_)) {
    done_.stopped = {now_, static_cast<int>(id), -1, "tumbles too fast to be followed for a frame"};
  }
}

void Loop::file(BodyId id) {
  const double from = std::max(now_, bodies_[id].path().since);
  const Group* group = group_of(id);
  const double until = group ? std::min(group->until, frame_end_) : frame_end_;
  tiling_.file(id, bodies_[id].box(from, std::max(from, until), envelope_ + (group ? group->margin + reach_ / 4 : 0)));
}

/// Whom the body's box intersects; their paths are asked for at once, so that none is waited for alone.
std::span<const BodyId> Loop::near(BodyId id) {
  const std::span<const BodyId> found = tiling_.near(id);
  for (const BodyId other : found) __builtin_prefetch(&bodies_[other]);
  return found;
}

void Loop::watch_all(BodyId id, BodyId but) {
  for (const BodyId other : near(id)) {
    if (other != but) watch(std::min(id, other), std::max(id, other), now_);
  }
}

/// Enters the pair into the heap, if it may meet within the frame.
void Loop::watch(BodyId id_a, BodyId id_b, double from) {
  const Mover &a = bodies_[id_a], &b = bodies_[id_b];
  if (a.fixed() && b.fixed()) return;
  const bool is_point = has_closed_form(a, b);
  if (!is_point) from = std::max(from, now_);
  from = std::max({from, a.path().since, b.path().since});
  double until = frame_end_;
  Swelling swelling{from};
  const Memory* remembered = group_of_[id_a] || group_of_[id_b] ? &memory_[key(id_a, id_b)] : nullptr;
  const bool seen_to_part = remembered && remembered->strikes == strikes_[id_a] + strikes_[id_b];
  for (const BodyId id : {id_a, id_b}) {
    const Group* group = group_of(id);
    if (!group) continue;
    if (group->waits || group->holds(id_a, id_b) || (seen_to_part && remembered->unasked == now_)) return;
    until = std::min(until, group->until);
    if (is_point) {
      swelling.at_first += group->margin;
    } else {
      swelling.at_first += group->drift() * (from - group->since);
      swelling.rate += group->drift();
    }
  }
  // Balls well within reach of each other are followed together.
  if (is_point && swelling.at_first > 0 && follows_steps(id_a) && follows_steps(id_b)) swelling.at_first += reach_ / 4;
  if (from > until) return;
  ++done_.books.pairs;
  Memory& walks = memory(id_a, id_b);
  if (from == std::max(start(id_a), start(id_b))) refuse_overlap(id_a, id_b, world::touch(a, b, from, walks));
  const Rest* rest = rests_on(id_a, id_b) ? &*rest_[id_a] : rests_on(id_b, id_a) ? &*rest_[id_b] : nullptr;
  const double envelope = seen_to_part && remembered->parted == now_ ? 0 : envelope_;
  const double time = rest ? rest->until : meeting(a, b, from, until, envelope, swelling, walks);
  turns_ += walks.looks / looks_of_a_turn;
  if (time <= frame_end_) heap_.put({std::max(time, now_), id_a, id_b});
}

Memory& Loop::memory(BodyId a, BodyId b) {
  return has_closed_form(bodies_[a], bodies_[b]) ? no_memory_ : memory_[key(a, b)];
}

void Loop::refuse_overlap(BodyId a, BodyId b, const Touch& touch) const {
  if (touch.gap >= -clearance(bodies_[a], bodies_[b], start(a), infinite)) return;
  throw InputError(name(a),
                   "overlaps " + name(b) + " at the start" +
                       (has_closed_form(bodies_[a], bodies_[b]) ? " by " + std::to_string(-touch.gap) + " m" : ""));
}

void Loop::set_out(BodyId id, const State& state) {
  if (bodies_[id].fixed()) return;
  if (Group* group = group_of(id)) return group->strike(id, state.velocity);
  bodies_[id].fly(now_, state, pull_[id]);
  if (bodies_[id].tires(frame_end_)) begin_anew(id);
  heap_.drop(id);
  file(id);
}

void Loop::record(const Event& event) {
  ++done_.books.count[static_cast<std::size_t>(event.kind)];
  ++events_;
  if (done_.trajectory.events) done_.trajectory.events->push_back(event);
}

void Loop::stop(const Due& due, const std::string& why) {
  done_.stopped = {now_, static_cast<int>(due.a), static_cast<int>(due.b), why};
}

/// The grid: below 2^-52 of the greatest momentum that a body can have while energy does not rise, so that momenta and
/// all their sums are exact.
void Loop::keep_momentum() {
  if (!scene_->gravity.isZero(0) || !scene_->flight->pushes.empty()) {
    throw InputError("gravity", "changes momentum; it can be kept exact only without gravity and pushes");
  }
  double energy = 0, heaviest = 0;
  for (const Mover& body : bodies_) {
    if (body.fixed()) continue;
    const Vec3 w = body.path().w;
    energy += body.path().v.squaredNorm() / body.inverse_mass() / 2 + w.squaredNorm() * body.inertia().trace() / 2;
    heaviest = std::max(heaviest, 1 / body.inverse_mass());
  }
  int exponent = 0;
  std::frexp(std::sqrt(2 * heaviest * energy), &exponent);
  grid_ = std::ldexp(1, exponent - 50);
  for (const Mover& body : bodies_) {
    momentum_.push_back(body.fixed() ? Vec3(Vec3::Zero()) : on_grid(body.path().v / body.inverse_mass(), grid_));
  }
  done_.momentum_before = momentum_;
}

void Loop::move_exactly(const Due& due, Hit& hit) {
  hit.P_A_W = on_grid(hit.P_A_W, grid_);
  momentum_[due.a] += hit.P_A_W;
  momentum_[due.b] -= hit.P_A_W;
  if (!bodies_[due.a].fixed()) hit.after_a.v_WBcm = bodies_[due.a].inverse_mass() * momentum_[due.a];
  if (!bodies_[due.b].fixed()) hit.after_b.v_WBcm = bodies_[due.b].inverse_mass() * momentum_[due.b];
}

}  // namespace touchstone::fast::world
