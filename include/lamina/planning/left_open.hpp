// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Share of a layer's area [%] that a solid fill may leave open without being reported.
inline constexpr double kMostOpenPercent = 0.5;

/// Area that beads leave open in solid layers whose fill lies in cells (`SolidFit::InCells`), or in those
/// regions of layers, as `findVoids` finds it; all 0 where there is no such layer.
struct LeftOpen {
  double area_mm2 = 0.0;        ///< of these layers, or of these regions of them
  double open_mm2 = 0.0;        ///< of that area, without any bead
  double worst_percent = 0.0;   ///< greatest share of a single layer
  std::size_t worst_layer = 0;  ///< index of that layer
  std::size_t open_layers = 0;  ///< number of layers that are open by more than `kMostOpenPercent`

  LeftOpen& operator+=(const LeftOpen& other);
};

}  // namespace lamina
