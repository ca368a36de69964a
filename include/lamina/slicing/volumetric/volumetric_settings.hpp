// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What volumetric layers are fitted to. `Arrival`: to nothing; growth is the cost of the cheapest path from
/// the bed. `Smooth`: to this growth, smoothed. `Surface`: to skins that face growth. `Tangent`: to lie
/// across the part, from the bed to its ends. `Given`: to lie across directions from a file.
enum class GrowthTarget { Arrival, Smooth, Surface, Tangent, Given };

/// How fitted layers meet the bed. `Flat`: the first layer is flat. `Free`: at any angle, as on belts and
/// below heads that deposit.
enum class GrowthFoot { Flat, Free };

/// How a part is cut into layers of equal growth.
struct VolumetricSettings {
  double cell_mm = 0.0;  ///< side of the cells in which growth is computed; 0 to derive it from the volume
  /// Greatest overhang that the material can bear: angle of a surface from the normal of its layer.
  double max_overhang_deg = 45.0;
  /// Overhang up to which layers stay level, before they tilt. If negative, it is chosen: 20 deg less than
  /// `max_overhang_deg`, or another angle if this gives the head room or supports more of the surface.
  double overhang_used_deg = -1.0;
  double max_thickness = 2.0;   ///< greatest thickness of a layer over `slicing.layer_height_mm`, the least
  double max_tilt_deg = 80.0;   ///< greatest angle of the direction of growth from the vertical
  double deviation_deg = 55.0;  ///< greatest angle by which the tool axis leans from the layer's normal
  double sink_mm = 0.0;         ///< depth by which the part is sunk into the bed, and cut off there
  GrowthTarget target = GrowthTarget::Arrival;  ///< what layers are fitted to
  GrowthFoot foot = GrowthFoot::Flat;           ///< how layers fitted to `target` meet the bed
  std::string target_file;  ///< path of the table of directions if `target` is Given; else empty
  /// Greatest angle between a skin and the layers of the arrival field at which fitted layers follow the
  /// skin.
  double skin_slope_deg = 25.0;
  int rounds = 8;  ///< number of rounds of the fit
  /// Greatest share of the volume that growth from the bed does not reach before the part is refused.
  double largest_pendant_percent = 0.5;
  /// Greatest share of the surface that overhangs by more than allowed before the part is refused.
  double largest_unsupported_percent = 5.0;
  /// Greatest share of the volume in which layers may be thinner or thicker than they should before the part
  /// is refused.
  double largest_uneven_percent = 0.5;
  /// Greatest share of the volume that layers may leave open, beyond what level layers leave, or cover twice,
  /// before the part is refused.
  double largest_uncovered_percent = 5.0;
  /// Greatest share of the deposited volume that may be left out where a head that tilts would collide, in
  /// any slicing mode.
  double largest_left_out_percent = 0.5;
};

/// Adds the keys volumetric.*.
void describe(SettingsSchema& schema, VolumetricSettings& settings);

/// @throws InvalidConfig if `overhang_used_deg` exceeds `max_overhang_deg`, if `target` is Given without
///   `target_file`, if it is not Given with a `target_file`, or if `foot` is Free and nothing is fitted
void requireConsistent(const VolumetricSettings& settings);

}  // namespace lamina
