// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <mutex>
#include <string>

#include "lamina/base/progress.hpp"

namespace lamina::test {

/// Counts how often clearance was checked: each time, joints are planned before.
class CountedChecks final : public Progress {
 public:
  void report(const std::string& stage, double) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stage == "clearance" && last_ != "clearance") ++checks_;
    last_ = stage;
  }
  bool isCancelled() const override { return false; }

  std::size_t checks() const { return checks_; }

 private:
  std::mutex mutex_;
  std::string last_;
  std::size_t checks_ = 0;
};

}  // namespace lamina::test
