// Runs independent pieces of work on several threads. The result must not depend on which thread takes which piece.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace touchstone::app {

/// How many threads are meant: 0 is one for each processor.
inline int threads_of(int jobs) {
  return jobs > 0 ? jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Calls work(piece, job) once for each piece; 0 ≤ job < jobs, and no two calls run with the same job at a time. The
/// first exception is rethrown after all threads have ended.
inline void in_parallel(std::size_t pieces, int jobs, const std::function<void(std::size_t, std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto take_pieces = [&](std::size_t job) {
    try {
      for (std::size_t piece = next++; piece < pieces; piece = next++) work(piece, job);
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
      next = pieces;
    }
  };
  std::vector<std::thread> threads;
  for (int job = 1; job < jobs; ++job) threads.emplace_back(take_pieces, static_cast<std::size_t>(job));
  take_pieces(0);
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace touchstone::app
