#include "reference/simultaneous/components.h"

#include <algorithm>
#include <utility>

namespace touchstone::reference {
namespace {

using Indices = std::vector<std::size_t>;

bool share_a_body(const MovingPair& pair, const MovingPair& other) {
  return std::ranges::any_of(
      pair, [&](const std::optional<int>& body) { return body && std::ranges::count(other, body) > 0; });
}

}  // namespace

std::vector<Indices> components(const std::vector<MovingPair>& pairs, const Indices& regions) {
  std::vector<Indices> all;
  for (const std::size_t r : regions) {
    Indices joined = {r};
    std::vector<Indices> apart;
    for (Indices& component : all) {
      if (std::ranges::any_of(component, [&](std::size_t other) { return share_a_body(pairs[r], pairs[other]); })) {
        joined.insert(joined.end(), component.begin(), component.end());
      } else {
        apart.push_back(std::move(component));
      }
    }
    std::ranges::sort(joined);
    apart.push_back(std::move(joined));
    all = std::move(apart);
  }
  return all;
}

}  // namespace touchstone::reference
