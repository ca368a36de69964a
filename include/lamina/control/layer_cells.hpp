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

/// The nearest cells of beads that lie beside a cell, of other paths or of the same one coming back, no
/// farther than 1.25 bead widths, as rasters lie at most one apart: one on each side, seen against growth.
struct CellsBeside {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::uint32_t left = kNone;
  std::uint32_t right = kNone;
  float left_mm = 0.0F;  ///< from middle to middle
  float right_mm = 0.0F;
};

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
  std::vector<Eigen::Vector3d> tangent;  ///< from where the cell begins to where it ends; unit
  std::vector<Eigen::Vector3d> growth;   ///< away from what it is laid onto; unit, square to the tangent but
                                         ///< where the layer is plane

  std::vector<CellsBeside> beside;  ///< of neighbouring beads

  std::size_t size() const { return middle.size(); }
};

/// Cells of a layer. Drops, travels and build aids, which are no part of the part, have none.
///
/// A layer that is plane, within its own height, grows along the layers' normal. Others grow against the tool
/// axis, as far as it is square to the path: what leads or trails does not count.
/// @param cell_mm  length of a cell at most; positive
/// @param normal  of the layers, in the frame of the toolpath; unit
/// @throws InvalidInput if the cell length is not positive and finite
LayerCells layerCells(const ToolpathLayer& layer, std::size_t index, double cell_mm,
                      const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ());

/// Normal of the layers of a toolpath, in its frame: the z of `part_from_layers`.
Eigen::Vector3d normalOfLayers(const Toolpath& toolpath);

/// Distance from an end, or a corner, within which cells count as such [mm].
constexpr double kRegionReach = 10.0;

/// For each cell of a layer the nearest cell of the layer beneath, no farther away in the plane square to
/// the layer's normal than its bead is wide; `kNoCellBelow` where there is none.
constexpr std::uint32_t kNoCellBelow = 0xFFFFFFFFU;
std::vector<std::uint32_t> cellsBelow(const LayerCells& layer, const LayerCells& below,
                                      const Eigen::Vector3d& normal);

/// How many cells of a layer, from its first on, the nozzle has left behind by a distance when it is so far
/// along a path: cells lie in the order in which it comes by. What it left behind on earlier paths counts as
/// left behind by what it has laid since.
/// @param path  of the layer, travels counted too
/// @param along_mm  from the start of that path
/// @param settle_mm  left behind by at least; not negative
std::size_t cellsPassed(const LayerCells& cells, std::size_t path, double along_mm, double settle_mm);

/// Mean by length of a value over all cells; 0 if there are none.
double meanOverCells(const LayerCells& cells, const std::vector<double>& values);

}  // namespace lamina
