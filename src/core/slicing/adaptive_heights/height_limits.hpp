// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/slicing/slicing_settings.hpp"
#include "slicing/adaptive_heights/part_slopes.hpp"

namespace lamina {

/// How high layers may be, by what they reach over. A limit at a height holds for every layer that touches
/// it, and the further a layer is from it, the more is allowed: as much more as the ratio of neighbours lets
/// heights grow on the way. So layers that are as high as they may be keep that ratio, and none is limited
/// more the later it begins.
class HeightLimits {
 public:
  HeightLimits(const SlopeProfile& profile, const AdaptiveSettings& settings);

  /// Upside down, for layers that are stacked from above.
  HeightLimits mirrored() const;

  /// The greatest height of a layer that begins there. Walks along the profile: ask for ascending bottoms.
  double above(double bottom_mm);

  /// How much a limit grows per distance.
  double growth() const { return growth_; }

 private:
  HeightLimits() = default;
  void spread();

  std::vector<double> z_mm_;
  std::vector<double> at_mm_;       ///< limit at each z
  std::vector<double> between_mm_;  ///< limit between z[i] and z[i + 1], nothing else regarded
  double greatest_mm_ = 0.0;
  double growth_ = 0.0;
  std::size_t next_ = 0;  ///< first z above the bottom that was asked for last
};

}  // namespace lamina
