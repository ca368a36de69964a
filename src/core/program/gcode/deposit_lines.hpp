// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Where a program lays the last bead of a layer, and in what state it leaves the machine there.
struct LayerEnd {
  std::size_t line = 0;  ///< 1 based; 0 if the layer deposits nothing
  Point3 nozzle = Point3::Zero();
  double feed_mm_s = 0.0;
  double filament_mm = 0.0;          ///< as an absolute E counts it
  bool is_filament_absolute = true;  ///< M82
  std::optional<double> height_mm;   ///< of the beads, if a comment reported it
  std::string_view type;  ///< the comment that reported the role last: ";TYPE:infill"; empty if none
};

/// The ends of all layers of the toolpath that was read from this program.
/// @throws InvalidProgram if the program uses inches, relative positions or another origin before such an end
std::vector<LayerEnd> layerEnds(std::string_view program, const Toolpath& toolpath);

}  // namespace lamina
