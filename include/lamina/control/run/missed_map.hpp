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
  /// The position from which on the map was applied after all; nothing if no part of the layer is deposited
  /// by its map.
  std::optional<PlaceOnLayer> held_from;
  /// Whether the part deposited without the map follows the coasting map; otherwise it is as planned.
  bool is_coasting = false;
};

/// The reason of alarm 6116 for such a map.
std::string reasonOf(const MissedMap& missed);

}  // namespace lamina
