// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How parts of a plate without a position of their own are arranged.
enum class PlateArrangement : std::uint8_t {
  None,  ///< where their files place them
  Rows,  ///< side by side in the order given, row behind row
  Pack   ///< close together, rotated by multiples of 45 deg as fits best
};

/// In which order the parts of a plate are printed.
enum class PlateOrder : std::uint8_t {
  ByLayer,  ///< all together, layer by layer
  ByPart    ///< one after the other, the lowest first
};

/// Commands with which a program labels its parts, so that host or firmware can leave out one of them.
enum class ObjectLabels : std::uint8_t {
  None,          ///< by comments only
  M486,          ///< Marlin, RepRapFirmware
  ExcludeObject  ///< Klipper
};

/// The value of `plate.labels`.
const char* toString(ObjectLabels labels);

/// How several parts share a bed.
struct PlateSettings {
  PlateArrangement arrangement = PlateArrangement::Rows;
  double spacing_mm = 5.0;  ///< between parts that are arranged
  PlateOrder order = PlateOrder::ByLayer;
  ObjectLabels labels = ObjectLabels::None;
};

/// Adds the keys plate.*.
void describe(SettingsSchema& schema, PlateSettings& settings);

}  // namespace lamina
