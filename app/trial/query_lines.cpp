#include "app/trial/query_lines.h"

#include <fmt/format.h>

#include <utility>

#include "app/system/progress.h"

namespace touchstone::app {

QueryLines::QueryLines(std::map<std::string, std::size_t> units, std::chrono::seconds after,
                       std::function<void(const std::string& line)> print)
    : after_(after), print_(std::move(print)) {
  for (const auto& [query, count] : units) queries_[query].left = count;
}

void QueryLines::step(const std::string& query, long scenes) {
  const std::lock_guard lock(mutex_);
  Progress& progress = queries_.at(query);
  progress.scenes += scenes;
  if (--progress.left > 0) return;
  const Clock::duration taken = Clock::now() - start_;
  if (taken < after_) return;
  print_(fmt::format("asked {}: {} {}, {} since the start", query, progress.scenes,
                     progress.scenes == 1 ? "scene" : "scenes",
                     clock_time(std::chrono::duration<double>(taken).count())));
}

}  // namespace touchstone::app
