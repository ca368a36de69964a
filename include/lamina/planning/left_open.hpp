// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace lamina {

/// Share of a layer's area [%] that a solid fill may leave open without being reported.
inline constexpr double kMostOpenPercent = 0.5;

/// Area without beads, as found by `findVoids`, in solid layers, or regions of layers, whose fill lies in
/// cells (`SolidFit::InCells`). All 0 if there are none.
struct LeftOpen {
  double area_mm2 = 0.0;        ///< area of these layers or regions
  double open_mm2 = 0.0;        ///< area of these layers or regions without any bead
  double worst_percent = 0.0;   ///< greatest share of a single layer
  std::size_t worst_layer = 0;  ///< index of that layer
  std::size_t open_layers = 0;  ///< number of layers that are open by more than `kMostOpenPercent`

  LeftOpen& operator+=(const LeftOpen& other);
};

}  // namespace lamina
