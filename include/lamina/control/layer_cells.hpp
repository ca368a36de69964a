// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The cells of one path, in the order in which the nozzle comes by.
struct CellRun {
  std::size_t path = 0;   ///< of the layer, travels counted too
  std::size_t first = 0;  ///< cell
  std::size_t count = 0;
  double length_mm = 0.0;
  bool is_closed = false;

  double cellLength() const { return length_mm / static_cast<double>(count); }  ///< [mm]
};

/// Where along a path a cell lies: growth differs there.
enum class CellRegion : std::uint8_t { Straight, End, Corner };

/// A layer in cells: pieces of its depositing paths, equally long within a path. The vectors have one value
/// per cell.
struct LayerCells {
  std::size_t layer = 0;
  std::vector<CellRun> runs;
  std::vector<Point3> middle;      ///< of the bead's top [mm, frame of the toolpath]
  std::vector<double> along_mm;    ///< from the start of the path
  std::vector<double> height_mm;   ///< planned
  std::vector<double> width_mm;    ///< of the bead
  std::vector<double> speed_mm_s;  ///< planned
  std::vector<CellRegion> region;

  std::size_t size() const { return middle.size(); }
};

/// Cells of a layer. Drops, travels and build aids, which are no part of the part, have none.
/// @param cell_mm  length of a cell at most; positive
/// @throws InvalidInput if the cell length is not positive and finite
LayerCells layerCells(const ToolpathLayer& layer, std::size_t index, double cell_mm);

/// Distance from an end, or a corner, within which cells count as such [mm].
constexpr double kRegionReach = 10.0;

/// For each cell of a layer the nearest cell of the layer beneath, no farther away in the plane square to
/// the layer's normal than its bead is wide; `kNoCellBelow` where there is none.
constexpr std::uint32_t kNoCellBelow = 0xFFFFFFFFU;
std::vector<std::uint32_t> cellsBelow(const LayerCells& layer, const LayerCells& below,
                                      const Eigen::Vector3d& normal);

/// Mean by length of a value over all cells; 0 if there are none.
double meanOverCells(const LayerCells& cells, const std::vector<double>& values);

}  // namespace lamina
