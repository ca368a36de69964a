// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Where the parts of a plate stand that have no place of their own.
enum class PlateArrangement : std::uint8_t {
  None,  ///< where their files say
  Rows,  ///< side by side in the order given, row behind row
  Pack   ///< close together, turned as fits
};

/// In which order the parts of a plate are printed.
enum class PlateOrder : std::uint8_t {
  ByLayer,  ///< all of them layer by layer, by height
  ByPart    ///< one after the other, the lowest first
};

/// By which commands a host or firmware can leave out one part of a plate.
enum class ObjectLabels : std::uint8_t {
  None,          ///< by comments only
  M486,          ///< Marlin, RepRapFirmware
  ExcludeObject  ///< Klipper
};

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
