// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <utility>

#include "lamina/base/progress.hpp"

namespace lamina {

/// Long work in a thread of its own, while its owner continues. The destructor cancels the work and waits for
/// its end.
template <class Result>
class WorkBeside {
 public:
  /// @param work  begins at once; must check its progress often, which is cancelled when the work is given up
  explicit WorkBeside(std::function<Result(Progress&)> work)
      : result_(std::async(std::launch::async, [this, work = std::move(work)] { return work(progress_); })) {}
  ~WorkBeside() { giveUp(); }
  WorkBeside(const WorkBeside&) = delete;
  WorkBeside& operator=(const WorkBeside&) = delete;

  void giveUp() { progress_.is_given_up = true; }
  /// Whether the work has ended, with a result or an exception.
  bool isDone() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
  /// Waits for the result; once.
  /// @throws what the work threw
  Result take() { return result_.get(); }

 private:
  struct GivenUp final : Progress {
    void report(const std::string&, double) override {}
    bool isCancelled() const override { return is_given_up; }
    std::atomic<bool> is_given_up{false};
  };

  GivenUp progress_;
  std::future<Result> result_;  ///< last, so that its thread ends before what it uses
};

}  // namespace lamina
