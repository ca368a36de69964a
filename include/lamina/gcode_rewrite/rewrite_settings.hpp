// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// How motions are transformed.
enum class RewriteMode {
  Corrected,  ///< by the rules of docs/programs/incline.md
  /// As the published listing does [Garcia2024, figures 4.11 to 4.16]: the height is determined from all
  /// lines that begin with G0 or G1, and the end code is transformed too.
  Listing,
};
/// Whether the part is lifted so that its lowest deposition is one layer height above the bed.
enum class Lift { ToFirstLayer, None };
/// Which direction of the nozzle is accepted if the machine's tool axis is given.
enum class ToolAxisRule {
  AlongNormal,  ///< only into the layers, perpendicular to them
  AsMachine,    ///< any, as the machine holds it
};
/// Whether G28 becomes a comment.
enum class Homing { Annulled, Kept };
/// Whether the motions of skirt, brim, raft, support and priming tower stay.
enum class BuildAids { Kept, Dropped };
/// The rule by which E changes if the map is not an isometry.
enum class ExtrusionRule {
  ByVolume,  ///< by the volume ratio: the part is deformed, and filled as before
  ByLength,  ///< by the length ratio: beads keep their cross-section
  Kept,      ///< the map changes coordinates only, not the part
};
enum class ExtrusionMode { Absolute, Relative };

/// Settings of the transformation of a program. Lengths are in mm, in the frame of the machine unless stated
/// otherwise.
struct RewriteSettings {
  RewriteMode mode = RewriteMode::Corrected;
  /// Number of decimals of coordinates, 0 to 6; empty: 3, or 2 in the mode `Listing`.
  std::optional<int> decimals;
  /// Height [mm] to which the lowest end of deposition is lifted; empty: the layer height that the slicer's
  /// comments state.
  std::optional<double> layer_height_mm;
  Lift lift = Lift::ToFirstLayer;
  Point3 offset_mm = Point3::Zero();  ///< shift of the part after the lift
  /// Position of the middle of the part in x and y, instead of an offset in these; empty: none is given.
  std::optional<Point2> table_position_mm;
  /// Position to which the nozzle moves at the end; empty: it does not.
  std::optional<Point3> final_position_mm;
  double final_feed_mm_min = 3000.0;  ///< feed of that motion
  std::string begin_code;             ///< lines inserted after the comments at the beginning of the program
  std::string end_code;               ///< lines appended at the end
  std::optional<Box3> limits_mm;      ///< limits of the nozzle's position; empty: none
  /// Direction of the machine's tool axis over the bed, which the comments of the output then state. Empty:
  /// the nozzle is tilted together with the layers.
  std::optional<Point3> tool_axis;
  ToolAxisRule tool_axis_rule = ToolAxisRule::AlongNormal;
  Homing homing = Homing::Annulled;
  BuildAids build_aids = BuildAids::Kept;
  ExtrusionRule extrusion_rule = ExtrusionRule::ByVolume;
  /// Whether E is absolute or relative until M82 or M83 says so. If empty, E is taken as absolute, and a
  /// program that contradicts this is refused.
  std::optional<ExtrusionMode> initial_extrusion;
  /// Greatest distance of chords from an arc, or from a line that a map bends.
  double chord_tolerance_mm = 0.01;
};

/// Checks the settings.
/// @throws InvalidConfig naming field, value and bound if one is out of bounds
void validate(const RewriteSettings& settings);

/// Number of decimals of coordinates: as set, otherwise that of the mode.
int decimalsOf(const RewriteSettings& settings);

}  // namespace lamina
