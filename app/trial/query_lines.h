// A line for each query of a long run whose stderr is no terminal, so that a log shows how far it has come.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace touchstone::app {

/// Several threads may call `step`.
class QueryLines {
 public:
  using Clock = std::chrono::steady_clock;

  /// `units`: how many steps each query has. When the last one of a query is done, `print` gets "asked distance:
  /// 281 scenes, 1:05 since the start", unless the run has taken less than `after`.
  QueryLines(std::map<std::string, std::size_t> units, std::chrono::seconds after,
             std::function<void(const std::string& line)> print);

  void step(const std::string& query, long scenes);

 private:
  struct Progress {
    std::size_t left = 0;
    long scenes = 0;
  };

  std::map<std::string, Progress> queries_;
  std::chrono::seconds after_;
  std::function<void(const std::string&)> print_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
};

}  // namespace touchstone::app
