// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// How motions are written.
enum class RewriteMode {
  Corrected,  ///< as docs/programs/incline.md says
  /// As the published listing does [Garcia2024, figures 4.11 to 4.16]: the height comes from every line that
  /// begins with G0 or G1, and the end code is transformed too.
  Listing,
};
enum class Lift { ToFirstLayer, None };
/// Which way the nozzle must point where the machine's tool axis is given.
enum class ToolAxisRule {
  AlongNormal,  ///< into the layers, square to them; refused otherwise
  AsMachine,    ///< as the machine holds it
};
enum class Homing { Annulled, Kept };
/// What becomes of skirt, brim, raft, support and priming tower.
enum class BuildAids { Kept, Dropped };
/// What E becomes where the map is no isometry.
enum class ExtrusionRule {
  ByVolume,  ///< times the volume ratio: the part is changed, and filled as before
  ByLength,  ///< times the length ratio: the beads keep their cross-section
  Kept,      ///< the map changes coordinates only, not the part
};
enum class ExtrusionMode { Absolute, Relative };

/// How a program is transformed. Lengths in mm, in the frame of the machine unless said otherwise.
struct RewriteSettings {
  RewriteMode mode = RewriteMode::Corrected;
  std::optional<int> decimals;  ///< of coordinates, 0 to 6; else 3, or 2 as the listing
  /// Height [mm] at which the lowest deposition end is put; if empty, what the slicer's comments state.
  std::optional<double> layer_height_mm;
  Lift lift = Lift::ToFirstLayer;
  Point3 offset_mm = Point3::Zero();  ///< moves the part after the lift
  std::optional<Point2>
      table_position_mm;  ///< where the middle of the part comes, instead of an offset in x and y
  std::optional<Point3> final_position_mm;  ///< where the nozzle goes at the end
  double final_feed_mm_min = 3000.0;        ///< in which it goes there
  std::string begin_code;                   ///< after the comments at the head
  std::string end_code;                     ///< after all else
  std::optional<Box3> limits_mm;            ///< of the nozzle
  /// Direction of the machine's tool axis over the bed, which the output's comments then state; if empty, the
  /// nozzle turns with the layers.
  std::optional<Point3> tool_axis;
  ToolAxisRule tool_axis_rule = ToolAxisRule::AlongNormal;
  Homing homing = Homing::Annulled;
  BuildAids build_aids = BuildAids::Kept;
  ExtrusionRule extrusion_rule = ExtrusionRule::ByVolume;
  /// Mode of E until M82 or M83 sets it. If empty, E is taken as absolute; a program that contradicts this is
  /// refused.
  std::optional<ExtrusionMode> initial_extrusion;
  double chord_tolerance_mm = 0.01;  ///< how far chords may be off an arc, or off a line that a map bends
};

/// @throws InvalidConfig naming field, value and bound
void validate(const RewriteSettings& settings);

/// Decimals of the coordinates: as set, else of the mode.
int decimalsOf(const RewriteSettings& settings);

}  // namespace lamina
