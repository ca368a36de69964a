// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace lamina {

/// A place on the paths of a layer.
struct PlaceOnLayer {
  std::size_t path = 0;   ///< number in the layer, travels included
  double along_mm = 0.0;  ///< from its start
};

/// The part of a layer's map that a machine did not apply.
struct MissedMap {
  std::size_t layer = 0;
  double waited_s = 0.0;  ///< for the map, before the layer
  std::string reason;     ///< in words; empty if the map did not come in time
  /// The place from which the map was applied after all; without one the whole layer is deposited as planned.
  std::optional<PlaceOnLayer> held_from;
};

}  // namespace lamina
