// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The line of a program that deposits the last bead of a layer, and the state of the machine after it.
struct LayerEnd {
  std::size_t line = 0;  ///< 1 based; 0 if the layer deposits nothing
  Point3 nozzle = Point3::Zero();
  double feed_mm_s = 0.0;
  double filament_mm = 0.0;          ///< sum of E as an absolute E counts it
  bool is_filament_absolute = true;  ///< whether E is absolute (M82) or relative (M83)
  std::optional<double> height_mm;   ///< height of the beads, if a comment states it
  std::string_view type;  ///< the comment that stated the role last: ";TYPE:infill"; empty if there is none
};

/// The ends of all layers of a toolpath that was read from this program.
/// @throws InvalidProgram if the program uses inches, relative positions or a shifted origin before such an
///   end
std::vector<LayerEnd> layerEnds(std::string_view program, const Toolpath& toolpath);

}  // namespace lamina
