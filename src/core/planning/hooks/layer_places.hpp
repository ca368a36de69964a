// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/planning/hooks/hooks.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Finds layers by number and by height.
class LayerPlaces {
 public:
  LayerPlaces(const Toolpath& toolpath, const HookSite& site);

  /// Index of the first layer that deposits, from layer `number` on.
  /// @param what  names the setting, for the error
  /// @throws InvalidConfig if there is none
  std::size_t layer(std::size_t number, const std::string& what) const;

  /// Index of the first layer that deposits and begins at or above this height over the bed. If parts are
  /// deposited one after the other, one index for each part that is high enough.
  /// @throws InvalidConfig if there is none
  std::vector<std::size_t> above(double height_mm, const std::string& what) const;

  /// Height of a layer's top along the layers' normal, as programs state it.
  double topOf(std::size_t layer) const { return toolpath_.layers[layer].z_mm + rise_mm_; }

 private:
  const Toolpath& toolpath_;
  double rise_mm_;
};

/// Index of the first path that deposits; the number of paths if none does.
std::size_t firstBead(const ToolpathLayer& layer);

}  // namespace lamina
