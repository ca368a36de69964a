// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/program/gcode/slicer_dialect.hpp"

namespace lamina {

/// What the comments of Lamina, Cura, PrusaSlicer, Slic3r (verbose) and Simplify3D state about the motions
/// that follow.
struct SlicerContext {
  SlicerDialect dialect = SlicerDialect::Unknown;
  std::optional<int> layer;  ///< as numbered by the slicer; nothing before the first layer and after the part
  std::optional<PathRole> role;     ///< nothing if not stated, or if Lamina has no such role
  std::optional<double> height_mm;  ///< height of the beads
  std::optional<double>
      layer_height_mm;  ///< first height stated since the layer opened; before it, that of the layer before
  bool is_layer_height_open = true;  ///< whether the next height stated is the layer's
  std::size_t section = 0;           ///< number of comments so far that open a layer or a path
};

/// What a comment states about the layer that begins with it.
struct LayerMark {
  bool is_next = false;  ///< whether the mark has no number and so denotes the layer after the one before
  std::optional<int> number;  ///< as the slicer counts; nothing if the mark has no readable number
};

/// Reads the marks of Lamina and Cura (`LAYER:3`), PrusaSlicer (`LAYER_CHANGE`) and Slic3r (`move to next
/// layer (3)`).
/// @param comment  without its semicolon, trimmed
/// @return         none for a comment that starts no layer
std::optional<LayerMark> readLayerMark(std::string_view comment);

/// Updates the context by a comment; comments of other kinds change nothing.
void readComment(std::string_view comment, SlicerContext& context);

/// The filament diameter [mm] for which the program was made, if the comment states it: `filament_diameter =
/// 1.75` as PrusaSlicer and Slic3r write it, `filamentDiameters,1.75|2.85` as Simplify3D does (of several the
/// first), `program.filament_diameter_mm = 2.85` among the settings of a program of Lamina.
std::optional<double> statedFilamentDiameter(std::string_view comment);

/// A motion with the properties that the comments state; all others have their defaults.
GcodeMotion motionIn(const SlicerContext& context);

}  // namespace lamina
