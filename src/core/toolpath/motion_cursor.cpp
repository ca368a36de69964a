// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "toolpath/motion_cursor.hpp"

namespace lamina {
namespace {

constexpr double kShortest = 1e-9;  // mm

}  // namespace

double MotionCursor::dwellHere() const {
  return path().events.empty() ? 0.0 : dwellBefore(path().events, motion_);
}

bool MotionCursor::stepAny() {
  if (is_started_) ++motion_;
  is_started_ = true;
  for (; layer_ < count_; ++layer_, path_ = 0) {
    const auto& paths = layers_[layer_].paths;
    for (; path_ < paths.size(); ++path_, motion_ = 0) {
      dwell_s_ += dwellHere();
      if (motion_ < paths[path_].motionCount()) return true;
    }
  }
  return false;
}

bool MotionCursor::step() {
  dwell_s_ = 0.0;
  while (stepAny()) {
    length_mm_ = (end() - start()).norm();
    if (!(length_mm_ < kShortest)) return true;
  }
  return false;
}

MotionSegment MotionCursor::segment(const MotionLimits& limits) const {
  MotionSegment segment;
  segment.direction = (end() - start()) / length_mm_;
  segment.length_mm = length_mm_;
  segment.feed_mm_s = path().feed_mm_s.at(path().motionEnd(motion_));
  segment.acceleration_mm_s2 =
      path().role == PathRole::Travel ? limits.travel_acceleration_mm_s2 : limits.acceleration_mm_s2;
  return segment;
}

}  // namespace lamina
