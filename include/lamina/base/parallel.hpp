// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "lamina/base/progress.hpp"

namespace lamina {

/// Runs `body(i)` for every i in [0, count), on as many threads as the machine has, and reports progress. The
/// results are the same for any number of threads, as long as body(i) writes only what belongs to i.
///
/// @throws Cancelled if `progress` is cancelled; otherwise the first exception that a body threw
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body, Progress& progress,
                 const std::string& stage);

/// Runs `body(i)` for every i in [0, count) as above, for loops that are too short to report or to cancel.
/// @throws the first exception that a body threw
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

/// Runs both functions, at the same time if there is more than one thread.
/// @throws what one of them threw
void inParallel(const std::function<void()>& first, const std::function<void()>& second);

/// Limits the threads of parallel loops of this process while it exists.
class ThreadLimit {
 public:
  /// @param threads  greatest number; at least 1
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace lamina
