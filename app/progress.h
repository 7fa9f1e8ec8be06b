// A bar on a terminal's stderr; silence in a pipe.
#pragma once

#include <mutex>
#include <string>

namespace touchstone::app {

/// Safe to step from several threads.
class Progress {
 public:
  Progress(std::string what, int steps);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step(const std::string& doing);

 private:
  void draw(const std::string& doing) const;

  std::string what_;
  int steps_;
  int done_ = 0;
  bool on_terminal_;
  std::mutex mutex_;
};

}  // namespace touchstone::app
