#include "app/vectors/drawn_vectors.h"

#include <algorithm>
#include <ctime>
#include <set>
#include <utility>

#include "app/vectors/exact_vector.h"
#include "model/input_error.h"

namespace touchstone::app {
namespace {

constexpr int candidates = 40;               ///< a choice: most families have fewer classes
constexpr std::size_t longest_text = 6'000;  ///< characters
constexpr double longest_answer = 0.5;       ///< s of CPU time

struct Candidate {
  TestVector vector;
  std::size_t length = 0;
  bool is_new = false;  ///< its classes
};

bool is_answered(const std::string& query, const Scene& scene) try {
  const std::clock_t start = std::clock();
  exact_vector(query, scene);
  return static_cast<double>(std::clock() - start) < longest_answer * CLOCKS_PER_SEC;
} catch (const InputError&) {
  return false;
}

}  // namespace

std::vector<TestVector> drawn_vectors(const std::string& query, const properties::Family& family, std::uint64_t seed,
                                      int most) {
  std::vector<Candidate> all;
  std::set<std::vector<std::string>> classes;
  for (std::uint64_t index = 0; index < candidates; ++index) {
    Scene scene = draw(family, seed, index);
    const std::size_t length = touchstone::json_of(scene).dump().size();
    if (length > longest_text) continue;
    const bool is_new = classes.insert(properties::classes_of(scene, query)).second;
    all.push_back({{std::move(scene), {{"family", family.id}, {"seed", seed}, {"index", index}}}, length, is_new});
  }
  std::ranges::stable_sort(all, [](const Candidate& a, const Candidate& b) {
    return a.is_new != b.is_new ? a.is_new : a.length < b.length;
  });
  std::vector<TestVector> chosen;
  for (Candidate& candidate : all) {
    if (static_cast<int>(chosen.size()) == most) break;
    if (is_answered(query, candidate.vector.scene)) chosen.push_back(std::move(candidate.vector));
  }
  return chosen;
}

}  // namespace touchstone::app
