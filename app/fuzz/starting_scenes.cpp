#include "app/fuzz/starting_scenes.h"

#include "app/fuzz/corpus_cases.h"
#include "app/motion/motion_scenes.h"
#include "oracle/case.h"
#include "oracle/minimise/scene_edit.h"
#include "properties/scenes/domain.h"

namespace touchstone::app {
namespace {

constexpr std::size_t most_bodies_of_known_motion = 3;  ///< a choice: those that take milliseconds

}  // namespace

std::vector<Scene> starting_scenes(const std::string& query, std::uint64_t seed, int draws) {
  const std::vector<const properties::Family*> families = properties::for_query(properties::families(), query);
  if (draws == 0) return {draw(*families.front(), seed, 0)};
  std::vector<Scene> all;
  for (int index = 0; index < draws; ++index) {
    for (const properties::Family* family : families) {
      all.push_back(draw(*family, seed, static_cast<std::uint64_t>(index)));
    }
  }
  for (const CorpusCase& known : corpus_cases()) {
    if (known.query == query) all.push_back(oracle::with_faces(oracle::case_from(known.text, known.name).scene));
  }
  if (query != "simulation") return all;
  for (const MotionScene& motion : motion_scenes()) {
    const Scene& scene = motion.scene;
    if (scene.bodies.size() <= most_bodies_of_known_motion) {
      all.push_back(oracle::with_faces(scene));
    }
  }
  return all;
}

}  // namespace touchstone::app
