// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/parallel.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <atomic>

namespace lamina {

namespace {

/// What a thread hands to those that work for it, and they back. oneTBB orders both; the thread sanitizer,
/// which does not see into it, sees these.
class Handover {
 public:
  void begin() { begun_.store(true, std::memory_order_release); }
  void take() const { static_cast<void>(begun_.load(std::memory_order_acquire)); }
  std::size_t giveBack() { return ++finished_; }
  void end() const { static_cast<void>(finished_.load(std::memory_order_acquire)); }

 private:
  std::atomic<bool> begun_{false};
  std::atomic<std::size_t> finished_{0};
};

}  // namespace

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body, Progress& progress,
                 const std::string& stage) {
  const std::size_t report_every = std::max<std::size_t>(1, count / 100);
  Handover handover;
  const auto run = [&](std::size_t i) {
    handover.take();
    throwIfCancelled(progress, stage);
    body(i);
    const std::size_t done = handover.giveBack();
    if (done % report_every == 0)
      progress.report(stage, static_cast<double>(done) / static_cast<double>(count));
  };
  // A loop within another that ends by an exception would otherwise stop half-way without an error.
  tbb::task_group_context context(tbb::task_group_context::isolated);
  handover.begin();
  tbb::parallel_for(std::size_t{0}, count, run, context);
  handover.end();
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body) {
  Handover handover;
  tbb::task_group_context context(tbb::task_group_context::isolated);
  handover.begin();
  tbb::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t i) {
        handover.take();
        body(i);
        handover.giveBack();
      },
      context);
  handover.end();
}

void inParallel(const std::function<void()>& first, const std::function<void()>& second) {
  parallelFor(2, [&](std::size_t i) { (i == 0 ? first : second)(); });
}

struct ThreadLimit::Control {
  explicit Control(int threads)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(1, threads))) {}
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>(threads)) {}
ThreadLimit::~ThreadLimit() = default;

}  // namespace lamina
