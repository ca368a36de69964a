// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/program/gcode/slicer_dialect.hpp"

namespace lamina {

/// What the comments of Lamina, Cura, PrusaSlicer, Slic3r (verbose) and Simplify3D report of the motions that
/// follow.
struct SlicerContext {
  SlicerDialect dialect = SlicerDialect::Unknown;
  std::optional<int> layer;         ///< as numbered by the slicer; none before the first and after the part
  std::optional<PathRole> role;     ///< none if not reported, or of a kind Lamina has no name for
  std::optional<double> height_mm;  ///< of the beads
  std::optional<double>
      layer_height_mm;               ///< the first height reported since the layer opened, or that before
  bool is_layer_height_open = true;  ///< the next height is the layer's
  std::size_t section = 0;           ///< counts the comments that open a layer or a path
};

/// What a comment says of the layer that starts with it.
struct LayerMark {
  bool is_next = false;       ///< the one after the layer before, without a number of its own
  std::optional<int> number;  ///< as the slicer counts; none if the mark has no number that can be read
};

/// Reads the marks of Lamina and Cura (`LAYER:3`), PrusaSlicer (`LAYER_CHANGE`) and Slic3r (`move to next
/// layer (3)`).
/// @param comment  without its semicolon, trimmed
/// @return         none for a comment that starts no layer
std::optional<LayerMark> readLayerMark(std::string_view comment);

/// Updates the context; other comments change nothing.
void readComment(std::string_view comment, SlicerContext& context);

/// The diameter [mm] of the filament the program was made for, if the comment reports it: `filament_diameter
/// = 1.75` as PrusaSlicer and Slic3r have it, `filamentDiameters,1.75|2.85` as Simplify3D; the first of
/// several.
std::optional<double> statedFilamentDiameter(std::string_view comment);

/// A motion of which nothing is known but what the comments report.
GcodeMotion motionIn(const SlicerContext& context);

}  // namespace lamina
