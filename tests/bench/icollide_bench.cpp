// Compares fixed cubes with tight boxes found by hill climbing, in the I-COLLIDE experiment: CPU time by phase, one
// parameter varied at a time.
//
// Prints CSV: varied,value,bounds,strategy,bodies,boxes_ns,broad_ns,near_pairs,narrow_ns,frame_us,frames_per_second.
// boxes_ns and broad_ns are per body and frame, near_pairs (pairs of boxes) per body. narrow_ns is per near pair: it is
// measured on the cubes' pairs with cached closest features, and used for the tight boxes' pairs as well.
#include <cstdio>
#include <memory>
#include <set>
#include <string>

#include "fast/bounds/fixed_cube.h"
#include "fast/bounds/tight_box.h"
#include "fast/broad_phase/strategies.h"
#include "fast/collider.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/icollide/world.h"

namespace touchstone::bench {
namespace {

constexpr int warm_frames = 10;
constexpr int frames = 60;

template <class Work>
double timed(Work&& work) {
  const double start = cpu_seconds();
  work();
  return 1e9 * (cpu_seconds() - start);
}

/// One kind of bounds with one strategy, and its cost so far.
template <class Bound>
class Lane {
 public:
  Lane(const World& world, const std::string& strategy) : strategy_(fast::find_strategy(strategy).make()) {
    for (const Body& body : world.bodies()) {
      bounds_.emplace_back(body.shape);
      boxes_.push_back(bounds_.back().at(body.X_WB));
      strategy_->insert(static_cast<fast::BodyId>(boxes_.size() - 1), boxes_.back());
    }
    strategy_->update();
  }

  void play(const World& world, bool counted) {
    const double boxes = timed([&] {
      for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i] = bounds_[i].at(world.bodies()[i].X_WB);
    });
    const double broad = timed([&] {
      for (std::size_t i = 0; i < boxes_.size(); ++i) strategy_->move(static_cast<fast::BodyId>(i), boxes_[i]);
      strategy_->update();
    });
    if (!counted) return;
    boxes_ns_ += boxes;
    broad_ns_ += broad;
    pairs_ += static_cast<double>(strategy_->pairs().size());
  }

  void print(const std::string& label, const char* bound, const char* strategy, double narrow_ns) const {
    const double n = static_cast<double>(boxes_.size());
    const double frame_ns = (boxes_ns_ + broad_ns_ + pairs_ * narrow_ns) / frames;
    std::printf("%s,%s,%s,%.0f,%.1f,%.1f,%.3f,%.0f,%.1f,%.0f\n", label.c_str(), bound, strategy, n,
                boxes_ns_ / frames / n, broad_ns_ / frames / n, pairs_ / frames / n, narrow_ns, frame_ns / 1e3,
                1e9 / frame_ns);
  }

 private:
  std::unique_ptr<fast::BroadPhase> strategy_;
  std::vector<Bound> bounds_;
  std::vector<Aabb> boxes_;
  double boxes_ns_ = 0;
  double broad_ns_ = 0;
  double pairs_ = 0;
};

/// The narrow phase and the response: the bodies of a pair exchange their velocities when they come into contact.
class Narrow {
 public:
  explicit Narrow(const World& world) : collider_(fast::find_strategy("wrapped_grid").make()) {
    for (std::size_t i = 0; i < world.bodies().size(); ++i) {
      collider_.insert(static_cast<fast::BodyId>(i), world.bodies()[i].shape, world.bodies()[i].X_WB);
    }
    collider_.update();
  }

  void play(World& world, bool counted) {
    for (std::size_t i = 0; i < world.bodies().size(); ++i) {
      collider_.move(static_cast<fast::BodyId>(i), world.bodies()[i].X_WB);
    }
    collider_.find_near();
    const double spent = timed([&] { collider_.measure_near(); });
    if (counted) {
      ns_ += spent;
      pairs_ += static_cast<double>(collider_.pairs().size());
    }
    std::set<fast::BodyPair> meeting;
    for (const fast::NearPair& pair : collider_.pairs()) {
      if (pair.nearest.proximity.verdict == Verdict::separated) continue;
      meeting.insert(pair.bodies);
      if (!met_.contains(pair.bodies)) world.exchange_velocities(pair.bodies.a, pair.bodies.b);
    }
    met_ = std::move(meeting);
  }

  double ns_a_pair() const { return pairs_ > 0 ? ns_ / pairs_ : 0; }

 private:
  fast::Collider collider_;
  std::set<fast::BodyPair> met_;
  double ns_ = 0;
  double pairs_ = 0;
};

void measure(const std::string& label, const Parameters& parameters) {
  World world(parameters, 1);
  Narrow narrow(world);
  Lane<fast::FixedCube> cubes(world, "wrapped_grid"), swept_cubes(world, "sweep_and_prune");
  Lane<fast::TightBox> tight(world, "wrapped_grid"), swept_tight(world, "sweep_and_prune");
  for (int f = 0; f < warm_frames + frames; ++f) {
    const bool counted = f >= warm_frames;
    world.advance();
    cubes.play(world, counted);
    tight.play(world, counted);
    swept_cubes.play(world, counted);
    swept_tight.play(world, counted);
    narrow.play(world, counted);
  }
  const double ns = narrow.ns_a_pair();
  cubes.print(label, "fixed_cube", "wrapped_grid", ns);
  tight.print(label, "tight_box", "wrapped_grid", ns);
  swept_cubes.print(label, "fixed_cube", "sweep_and_prune", ns);
  swept_tight.print(label, "tight_box", "sweep_and_prune", ns);
}

template <class Number>
void vary(const char* name, Number Parameters::*member, const std::vector<Number>& values, double stretch = 1) {
  for (const Number value : values) {
    Parameters parameters;
    parameters.stretch = stretch;
    parameters.*member = value;
    char label[64];
    std::snprintf(label, sizeof label, "%s,%g", name, static_cast<double>(value));
    measure(label, parameters);
  }
}

}  // namespace
}  // namespace touchstone::bench

int main() {
  using touchstone::bench::Parameters;
  std::puts("varied,value,bounds,strategy,bodies,boxes_ns,broad_ns,near_pairs,narrow_ns,frame_us,frames_per_second");
  touchstone::bench::vary<double>("density", &Parameters::density, {0.001, 0.005, 0.01, 0.02, 0.05, 0.1});
  touchstone::bench::vary<double>("turn", &Parameters::turn, {0, 5, 10, 20, 45, 90});
  touchstone::bench::vary<int>("bodies", &Parameters::bodies, {100, 300, 1000, 3000});
  touchstone::bench::vary<int>("faces", &Parameters::faces, {20, 36, 100, 400});
  touchstone::bench::vary<double>("stretch", &Parameters::stretch, {1, 2, 4, 8});
}
