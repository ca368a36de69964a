// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "slicing/adaptive_heights/height_limits.hpp"

namespace lamina {

/// Heights between two places at which a layer ends.
struct HeightStretch {
  double low_mm = 0.0;
  double high_mm = 0.0;
  /// Of the layers at its ends, for those beyond.
  double limit_at_low_mm = std::numeric_limits<double>::infinity();
  double limit_at_high_mm = std::numeric_limits<double>::infinity();
};

/// Cuts stretches into layers.
class StretchCutter {
 public:
  StretchCutter(const SlopeProfile& profile, const AdaptiveSettings& settings);

  /// Where layers begin and end, both ends of the stretch included, as few and as high as limits allow: what
  /// is too much in all is taken from what each has above the least height. None if layers of the least
  /// height do not go into it.
  std::optional<std::vector<double>> cut(const HeightStretch& stretch);

  /// Where the highest layers from `low_mm` end, the last one at or above `high_mm`.
  std::vector<double> highest(const HeightStretch& stretch);

  double least() const { return least_mm_; }
  double growth() const { return up_.growth(); }

 private:
  double heightAt(HeightLimits& limits, double bottom_mm, const HeightStretch& stretch) const;
  std::vector<double> ends(HeightLimits& limits, const HeightStretch& stretch) const;

  HeightLimits up_;
  HeightLimits down_;
  double least_mm_;
  double quantum_mm_;
};

}  // namespace lamina
