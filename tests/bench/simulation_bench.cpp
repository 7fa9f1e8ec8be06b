// Compares simulators: CSV of the CPU time of a whole scene, and the error.
//
// Workloads are the scenes of app/motion/motion_scenes.h and simulation/piles.h; each defines its error. Sizes: steps
// per second of the simulators that step; ours do not. The engines' default is 256 (oracle/subjects/). For motions of
// milliseconds or hours the unit of time is not the second. Each run is a process of its own; the result is the fastest
// of the rounds.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/motion/motion_scenes.h"
#include "fast/simulation.h"
#include "oracle/subject.h"
#include "oracle/subjects/bullet/simulation.h"
#include "oracle/subjects/ode/simulation.h"
#include "oracle/subjects/simbody/simulation.h"
#include "oracle/subjects/touchstone/fast.h"
#include "tests/bench/command_line.h"
#include "tests/bench/simulation/piles.h"
#include "tests/bench/simulation/trial.h"

namespace touchstone::bench {
namespace {

using namespace oracle::subjects;

std::vector<app::MotionScene> scenes() {
  std::vector<app::MotionScene> all = app::motion_scenes();
  all.insert(all.end(), piles().begin(), piles().end());
  return all;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const app::MotionScene& motion : scenes()) all.push_back(motion.scene.name);
  return all;
}

/// Replaces commas, which separate fields.
std::string field(std::string text) {
  std::ranges::replace(text, ',', ';');
  std::ranges::replace(text, '\n', ' ');
  return text;
}

void print(const std::string& scene, double steps, const std::string& name, const char* whose, const Outcome& outcome) {
  std::printf("%s,%.8g,%s,%s,", scene.c_str(), steps, name.c_str(), whose);
  if (outcome.left_out.empty()) {
    std::printf("%.0f,,%.3g,,%.0f,%.0f\n", 1e9 * outcome.seconds, outcome.error, outcome.impacts, outcome.changes);
  } else {
    std::printf(",,,%s,,\n", field(outcome.left_out).c_str());
  }
  std::fflush(stdout);
}

/// Uses one frame as long as the whole motion: since boxes then cover the whole motion, they exclude hardly any pair.
class OneFrame : public oracle::Subject {
 public:
  const oracle::Card& card() const override { return card_; }
  Answer<Trajectory> simulation(const Scene& scene) override {
    return fast::simulate(scene, {.frame = scene.motion->sample_times.back()}).trajectory;
  }

 private:
  oracle::Card card_{.name = "fast.one_frame",
                     .version = "",
                     .answers = {"simulation"},
                     .about = "",
                     .homepage = "",
                     .deviations = {}};
};

std::unique_ptr<oracle::Subject> make_one_frame() { return std::make_unique<OneFrame>(); }

struct Stepper {
  std::string name;
  std::function<std::unique_ptr<oracle::Subject>(double dt)> make;
};

const std::vector<Stepper>& steppers() {
  static const std::vector<Stepper> all = {
      {"bullet", [](double dt) { return make_bullet_simulation("simulation", dt); }},
      {"bullet.tuned", [](double dt) { return make_bullet_simulation("simulation_tuned", dt); }},
      {"ode", [](double dt) { return make_ode_simulation("simulation", dt); }},
      {"ode.quick", [](double dt) { return make_ode_simulation("simulation_quick", dt); }},
      {"simbody", [](double dt) { return make_simbody_simulation(dt); }},
  };
  return all;
}

/// Unit of time (s): a second, or, for a motion of a very different duration, the power of two below the duration.
double unit(const Motion& motion) {
  const double duration = motion.sample_times.back();
  return duration > 1.0 / 16 && duration < 64 ? 1 : std::exp2(std::floor(std::log2(duration)));
}

void compare(const app::MotionScene& motion, const Options& options) {
  const std::string& scene = motion.scene.name;
  print(scene, 0, "fast", "ours", trial(motion, make_fast, &oracle::Subject::simulation, options.rounds));
  print(scene, 0, "fast.one_frame", "beside",
        trial(motion, make_one_frame, &oracle::Subject::simulation, options.rounds));
  print(scene, 0, "fast.constraint", "ours", trial(motion, make_fast, &oracle::Subject::constraint, options.rounds));
  for (const Stepper& stepper : steppers()) {
    bool ends = true;
    for (const int size : options.sizes) {
      // Smaller steps would not finish either.
      if (!ends) break;
      const double steps = size / unit(*motion.scene.motion);
      const Maker maker = [&stepper, steps] { return stepper.make(1 / steps); };
      const Outcome outcome = trial(motion, maker, &oracle::Subject::simulation, options.rounds);
      print(scene, steps, stepper.name, "peer", outcome);
      ends = outcome.ends;
    }
  }
}

void run(const Options& options) {
  std::printf("workload,size,name,whose,ns,median_error,worst_error,left_out,impacts,changes\n");
  for (const app::MotionScene& motion : scenes()) {
    if (std::ranges::count(options.workloads, motion.scene.name) > 0) compare(motion, options);
  }
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  return run_comparison(argc, argv,
                        {"Simulators of named scenes, and the error that their time buys.",
                         "steps a second",
                         {{16, 64, 256, 1024, 4096}, names(), 3},
                         names()},
                        run);
}
