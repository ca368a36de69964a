// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "motion_samples.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

std::vector<MotionSample> samplesOf(const ExecutedMotion& motion, double spacing_mm) {
  const Point3 way = motion.end - motion.start;
  const int count = std::max(1, static_cast<int>(std::ceil(way.norm() / spacing_mm - 1e-9)));
  std::vector<MotionSample> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 1; i < count; ++i) {
    const double part = static_cast<double>(i) / count;
    samples.push_back({motion.timeAt(part), motion.start + part * way});
  }
  samples.push_back({motion.end_s, motion.end});
  return samples;
}

}  // namespace lamina
