// A progress bar on stderr if it is a terminal; no output into a pipe.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace touchstone::app {

/// "asking [███···] 120/480 0:31, 1:33 left  distance": the elapsed time and an estimate of the remaining time. At most
/// `columns` columns: first the text at the end is cut, then the bar.
std::string bar_line(std::string_view what, int done, int steps, double seconds, std::string_view doing, int columns);

/// "0:07", "12:30", "3:05:00"
std::string clock_time(double seconds);

/// Is stderr a terminal on which a bar can be drawn?
bool draws_bars();

/// Several threads may call step. The bar is also redrawn every second, because time passes and the window's width may
/// change.
class Progress {
 public:
  Progress(std::string what, int steps);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step(const std::string& doing, int steps = 1);

 private:
  void draw() const;
  void redraw_until_stopped();

  std::string what_;
  int steps_;
  int done_ = 0;
  std::string doing_;
  bool on_terminal_;
  bool stopped_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable stop_;
  std::thread clock_;
};

}  // namespace touchstone::app
