// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/threads/joint_progress.hpp"

#include <algorithm>
#include <utility>

namespace lamina {
namespace {

// Steps by which reports are apart.
constexpr double kStep = 0.01;

}  // namespace

JointProgress::JointProgress(Progress& whole, std::string stage) : whole_(&whole), stage_(std::move(stage)) {}

void JointProgress::add(double share) {
  const std::lock_guard<std::mutex> lock(mutex_);
  done_ = std::min(1.0, done_ + share);
  if (done_ < reported_ + kStep) return;
  reported_ = done_;
  whole_->report(stage_, done_);
}

void JointProgress::Part::report(const std::string& /*stage*/, double fraction) {
  if (!(fraction > done_)) return;
  joint_->add(share_ * (fraction - done_));
  done_ = fraction;
}

}  // namespace lamina
