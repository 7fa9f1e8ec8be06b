#include "oracle/subjects/touchstone/fast_work.h"

#include <optional>
#include <type_traits>
#include <variant>

#include "fast/mark.h"
#include "oracle/query.h"

namespace touchstone::oracle::subjects {

namespace {

/// The events and the contact steps of a trajectory, which other counts are compared with.
void count_reported(const Answer<Trajectory>& answer, Work& counts) {
  const auto* said = std::get_if<Trajectory>(&answer);
  if (said == nullptr) return;
  if (said->events) counts["event"] = said->events->size();
  if (said->contact_solver) counts["step"] = static_cast<std::uint64_t>(said->contact_solver->steps);
}

}  // namespace

Answer<Work> fast_work(Subject& subject, const std::string& query, const Scene& scene) {
  Work counts;
  const fast::MarkCounts before = fast::mark_counts;
  const auto ask = [&](auto function) -> std::optional<Abstains> {
    const auto answer = (subject.*function)(scene);
    if constexpr (std::is_same_v<decltype(answer), const Answer<Trajectory>>) count_reported(answer, counts);
    const auto* abstains = std::get_if<Abstains>(&answer);
    return abstains == nullptr ? std::nullopt : std::optional(*abstains);
  };
  if (const auto abstains = std::visit(ask, find_query(query)->ask)) return *abstains;
  const fast::MarkCounts reached = fast::marks_since(before);
  for (std::size_t m = 0; m < reached.size(); ++m) {
    if (reached[m] > 0) counts[fast::mark_names[m]] = reached[m];
  }
  return counts;
}

}  // namespace touchstone::oracle::subjects
