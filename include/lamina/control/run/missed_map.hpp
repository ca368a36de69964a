// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace lamina {

/// A place on the paths of a layer.
struct PlaceOnLayer {
  std::size_t path = 0;   ///< travels counted too
  double along_mm = 0.0;  ///< from its start
};

/// What a machine did not have of a layer's map.
struct MissedMap {
  std::size_t layer = 0;
  double waited_s = 0.0;  ///< in front of the layer
  std::string reason;     ///< why, in words; empty where the map did not come in time
  /// The place from which it holds after all; without one all of the layer is laid as planned.
  std::optional<PlaceOnLayer> held_from;
};

}  // namespace lamina
