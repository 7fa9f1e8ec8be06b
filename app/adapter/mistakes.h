// Typical mistakes of adapters, each as what it does to a question or to the right answer. A wrong answer that one of
// them predicts is explained by it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/adapter/paper/paper_scene.h"

namespace touchstone::app {

/// The engine was asked about `asked(scene)` instead of the scene; the adapter made `said(answer, scene)` of its
/// answer. Either may be null: then that side is right.
struct Mistake {
  std::string hint;  ///< what is probably wrong, in a few words
  std::function<void(Scene& scene)> asked;
  std::function<void(AnyAnswer& answer, const Scene& scene)> said;
};

/// Those that show in answers to a query; of two that predict the same answers, the more typical one comes first.
std::vector<Mistake> mistakes(const std::string& query);

/// The answer that a right engine gives through an adapter with this mistake: that of `fast`, which errs by rounding
/// only or of the reference where `fast` abstains. No value if neither answers: the scene
/// that the engine would get is not valid, or has no such answer.
std::optional<AnyAnswer> predicted(const Mistake& mistake, const std::string& query, const PaperScene& paper);

}  // namespace touchstone::app
