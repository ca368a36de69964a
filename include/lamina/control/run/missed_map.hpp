// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace lamina {

/// A position on the paths of a layer.
struct PlaceOnLayer {
  std::size_t path = 0;   ///< number in the layer, travels included
  double along_mm = 0.0;  ///< distance from the start of the path
};

/// The part of a layer's map that a machine did not apply.
struct MissedMap {
  std::size_t layer = 0;
  double waited_s = 0.0;  ///< time for which the machine waited for the map before the layer
  std::string reason;     ///< in words; empty if the map did not arrive in time
  /// The position from which on the map was applied after all. Without it none of the layer is deposited by
  /// its map.
  std::optional<PlaceOnLayer> held_from;
  /// Whether what is deposited without its map is deposited by its coasting map, else as planned.
  bool is_coasting = false;
};

/// The reason of alarm 6116 for such a map.
std::string reasonOf(const MissedMap& missed);

}  // namespace lamina
