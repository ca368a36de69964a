// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// What is done about runs of inclined layers that would begin unsupported along the tool axis.
enum class Anchoring {
  None,            ///< they stay as the strategy planned them
  SupportedStart,  ///< they begin on the bed or the layer before, if they pass over either; a part that
                   ///< begins in mid-air is refused
  WherePossible,   ///< the same, but nothing is refused
};

struct AnchorSettings {
  Anchoring strategy = Anchoring::SupportedStart;
};

/// Adds the key anchoring.strategy.
void describe(SettingsSchema& schema, AnchorSettings& anchoring);

/// The bed below inclined layers, in their frame.
struct BedPlane {
  Point3 up = Point3::UnitZ();  ///< away from the bed, of unit length
  double level_mm = 0.0;        ///< height of the bed along `up`

  double heightOf(const Point3& point) const { return up.dot(point) - level_mm; }
};

/// Numbers of runs with an unsupported start; 0 in level layers.
struct AnchoredStarts {
  /// Runs reversed, started elsewhere or divided, so that they begin on bed or material.
  std::size_t moved = 0;
  std::size_t in_air = 0;  ///< runs that still begin in the air
};

}  // namespace lamina
