// Scenes whose answers are solved on paper. An engine that is any good answers them within a thousandth, so a wrong
// answer is most probably a mistake of its adapter.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::app {

/// The answer to any query.
using AnyAnswer = std::variant<Masses, Bounds, PairSet, PairHistory, Distance, Penetration, Pixels, Impulse,
                               TimeOfImpact, Trajectory>;

/// A scene, which has a name and all its faces, and the answer: a closed form, evaluated in doubles. The comment above
/// each scene derives it. A part that is absent is not judged.
struct PaperScene {
  Scene scene;
  AnyAnswer expected;
};

/// In an expected state: the body's rotation is not judged.
inline constexpr Quaternion not_judged{0, 0, 0, 0};

/// Those of one query (oracle/query.h). tests/app/adapter compares each with the exact reference.
std::vector<PaperScene> paper_scenes(const std::string& query);

std::vector<PaperScene> mass_on_paper();
std::vector<PaperScene> bounds_on_paper();
std::vector<PaperScene> broad_phase_on_paper();
std::vector<PaperScene> pair_history_on_paper();
std::vector<PaperScene> distance_on_paper();
std::vector<PaperScene> penetration_on_paper();
std::vector<PaperScene> impulse_on_paper();
std::vector<PaperScene> pixel_on_paper();
std::vector<PaperScene> time_of_impact_on_paper();
std::vector<PaperScene> simulation_on_paper();
std::vector<PaperScene> constraint_on_paper();

}  // namespace touchstone::app
