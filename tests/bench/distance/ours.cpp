#include "fast/lin_canny/proximity.h"
#include "tests/bench/distance/contestant.h"

namespace touchstone::bench {
namespace {

using namespace fast::lin_canny;

/// From poses to a certified enclosure: the query includes computing the rotations. With `tracks` it starts from the
/// closest features of the previous frame, otherwise from features that face each other.
class LinCanny : public Contestant {
 public:
  LinCanny(const Polytope& A, const Polytope& B, bool tracks) : A_(Shape(A)), B_(Shape(B)), tracks_(tracks) {}

  double distance(const FrameSequence::Poses& poses) override {
    if (!tracks_) memory_ = {};
    return proximity(A_.parts()[0], CachedPose(poses.X_WA), B_.parts()[0], CachedPose(poses.X_WB), memory_).distance;
  }

 private:
  Solid A_;
  Solid B_;
  bool tracks_;
  FeaturePair memory_;
};

}  // namespace

std::vector<Entrant> ours() {
  const auto enter = [](bool tracks) {
    return [tracks](const Polytope& A, const Polytope& B) { return std::make_unique<LinCanny>(A, B, tracks); };
  };
  return {{"fast", "ours", enter(true)}, {"fast first query", "ours", enter(false)}};
}

}  // namespace touchstone::bench
