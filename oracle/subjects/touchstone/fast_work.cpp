#include "oracle/subjects/touchstone/fast_work.h"

#include <optional>
#include <variant>

#include "fast/mark.h"
#include "oracle/query.h"

namespace touchstone::oracle::subjects {

Answer<Work> fast_work(Subject& subject, const std::string& query, const Scene& scene) {
  const fast::MarkCounts before = fast::mark_counts;
  const auto ask = [&](auto function) -> std::optional<Abstains> {
    const auto answer = (subject.*function)(scene);
    const auto* abstains = std::get_if<Abstains>(&answer);
    return abstains == nullptr ? std::nullopt : std::optional(*abstains);
  };
  if (const auto abstains = std::visit(ask, find_query(query)->ask)) return *abstains;
  const fast::MarkCounts reached = fast::marks_since(before);
  Work counts;
  for (std::size_t m = 0; m < reached.size(); ++m) {
    if (reached[m] > 0) counts[fast::mark_names[m]] = reached[m];
  }
  return counts;
}

}  // namespace touchstone::oracle::subjects
