#include "app/fuzz/pool.h"

#include <utility>

namespace touchstone::app {

std::size_t Pool::any(properties::Random& random) const { return random.index(entries_.size()); }

void Pool::keep(Scene scene, double nearness, properties::Random& random) {
  Entry entry{std::move(scene), nearness};
  if (entries_.size() < most) {
    entries_.push_back(std::move(entry));
    return;
  }
  const std::size_t a = any(random);
  const std::size_t b = any(random);
  entries_[entries_[a].nearness <= entries_[b].nearness ? a : b] = std::move(entry);
}

const Scene& Pool::choose(properties::Random& random) const {
  const std::size_t a = any(random);
  if (random.one_in(2)) return entries_[a].scene;
  const std::size_t b = any(random);
  return entries_[entries_[a].nearness >= entries_[b].nearness ? a : b].scene;
}

}  // namespace touchstone::app
