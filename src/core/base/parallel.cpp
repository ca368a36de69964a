// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/parallel.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <atomic>

namespace lamina {

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body, Progress& progress,
                 const std::string& stage) {
  const std::size_t report_every = std::max<std::size_t>(1, count / 100);
  std::atomic<std::size_t> finished{0};
  const auto run = [&](std::size_t i) {
    throwIfCancelled(progress, stage);
    body(i);
    const std::size_t done = ++finished;
    if (done % report_every == 0)
      progress.report(stage, static_cast<double>(done) / static_cast<double>(count));
  };
  // A loop within another that ends by an exception would otherwise stop half-way without an error.
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_for(std::size_t{0}, count, run, context);
}

void inParallel(const std::function<void()>& first, const std::function<void()>& second) {
  tbb::task_group_context context(tbb::task_group_context::isolated);
  tbb::parallel_invoke(first, second, context);
}

struct ThreadLimit::Control {
  explicit Control(int threads)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(1, threads))) {}
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>(threads)) {}
ThreadLimit::~ThreadLimit() = default;

}  // namespace lamina
