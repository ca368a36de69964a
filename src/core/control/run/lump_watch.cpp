// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/lump_watch.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

double sureHeight(double height_mm) { return std::isfinite(height_mm) ? height_mm : LumpWatch::kNone; }

}  // namespace

void LumpWatch::see(const std::vector<double>& heights_mm) {
  double profile_mm = kNone;
  for (std::size_t i = 2; i < heights_mm.size(); ++i)
    profile_mm = std::max(profile_mm, std::min({sureHeight(heights_mm[i - 2]), sureHeight(heights_mm[i - 1]),
                                                sureHeight(heights_mm[i])}));
  height_mm_ = std::max(height_mm_, std::min({before_mm_[0], before_mm_[1], profile_mm}));
  before_mm_ = {before_mm_[1], profile_mm};
}

}  // namespace lamina
