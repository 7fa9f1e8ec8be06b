#include "fast/distance.h"
#include "reference/distance.h"
#include "tests/bench/distance/contestant.h"

namespace touchstone::bench {
namespace {

/// `Measure`: Scene → distance in doubles.
template <class Measure>
class Once : public Contestant {
 public:
  Once(const Polytope& A, const Polytope& B, Measure measure)
      : scene_(scene_of({A, B, {}}, {})), measure_(std::move(measure)) {}

  double distance(const FrameSequence::Poses& poses) override {
    scene_.bodies[0].X_WB = poses.X_WA;
    scene_.bodies[1].X_WB = poses.X_WB;
    return measure_(scene_);
  }

 private:
  Scene scene_;
  Measure measure_;
};

template <class Measure>
Entrant entrant(const std::string& name, const std::string& whose, Measure measure) {
  return {name, whose,
          [measure](const Polytope& A, const Polytope& B) { return std::make_unique<Once<Measure>>(A, B, measure); }};
}

}  // namespace

std::vector<Entrant> asked_once() {
  return {entrant("fast", "ours", [](const Scene& scene) { return *fast::distance(scene).distance; }),
          entrant("reference", "peer", [](const Scene& scene) { return reference::distance(scene).distance.lo; })};
}

}  // namespace touchstone::bench
