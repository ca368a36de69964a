// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/slicing/slicing_settings.hpp"
#include "slicing/adaptive_heights/part_slopes.hpp"

namespace lamina {

/// Limits of layer height along z, from the slopes that layers span. A limit at some height applies to every
/// layer that touches this height. A layer at a distance from this height may be higher, by as much as
/// heights may grow from neighbour to neighbour over the distance. Layers of the greatest allowed height
/// therefore keep the allowed ratio of neighbours.
class HeightLimits {
 public:
  HeightLimits(const SlopeProfile& profile, const AdaptiveSettings& settings);

  /// The limits turned upside down, for layers that are stacked from the top.
  HeightLimits mirrored() const;

  /// The greatest height of a layer that begins at `bottom_mm`. Each call must have a bottom no lower than
  /// the call before, as it walks along the profile.
  double above(double bottom_mm);

  /// Increase of a limit per distance from it [mm/mm].
  double growth() const { return growth_; }

 private:
  HeightLimits() = default;
  void spread();

  std::vector<double> z_mm_;
  std::vector<double> at_mm_;  ///< limit at each z
  /// Limit between z[i] and z[i + 1], before limits of other heights are applied.
  std::vector<double> between_mm_;
  double greatest_mm_ = 0.0;
  double growth_ = 0.0;
  std::size_t next_ = 0;  ///< index of the first z above the bottom of the last call
};

}  // namespace lamina
