// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The cells of one path, in the order in which the nozzle passes them.
struct CellRun {
  std::size_t path = 0;   ///< number in the layer, travels included
  std::size_t first = 0;  ///< number of its first cell in the layer
  std::size_t count = 0;
  double length_mm = 0.0;
  bool is_closed = false;

  double cellLength() const { return length_mm / static_cast<double>(count); }  ///< [mm]
};

/// The part of a path in which a cell lies: growth differs between them.
enum class CellRegion : std::uint8_t { Straight, End, Corner };

/// The nearest cell of a neighbouring bead on each side of a cell, seen against growth. Neighbouring are
/// beads of other paths, or of the same one coming back, within 1.25 bead widths: rasters lie at most one
/// apart.
struct CellsBeside {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::uint32_t left = kNone;
  std::uint32_t right = kNone;
  float left_mm = 0.0F;   ///< distance of the middles
  float right_mm = 0.0F;  ///< likewise
};

/// A layer divided into cells, which are pieces of its depositing paths, equally long within a path. The
/// vectors have one value per cell.
struct LayerCells {
  std::size_t layer = 0;
  std::vector<CellRun> runs;
  std::vector<Point3> middle;      ///< point of the bead's top [mm, frame of the toolpath]
  std::vector<double> along_mm;    ///< from the start of the path
  std::vector<double> height_mm;   ///< planned
  std::vector<double> width_mm;    ///< of the bead
  std::vector<double> speed_mm_s;  ///< planned
  std::vector<CellRegion> region;
  std::vector<Eigen::Vector3d> tangent;  ///< from start to end of the cell; unit
  std::vector<Eigen::Vector3d> growth;   ///< away from the surface below; unit, square to the tangent except
                                         ///< in plane layers

  std::vector<CellsBeside> beside;  ///< of neighbouring beads

  std::size_t size() const { return middle.size(); }
};

/// Divides a layer into cells. Drops, travels and build aids, which are not of the part, have none.
///
/// A layer that is plane within its own height grows along the layers' normal. Any other grows against the
/// component of the tool axis that is square to the path.
/// @param cell_mm  greatest length of a cell; positive
/// @param normal  of the layers, in the frame of the toolpath; unit
/// @throws InvalidInput if the cell length is not positive and finite
LayerCells layerCells(const ToolpathLayer& layer, std::size_t index, double cell_mm,
                      const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ());

/// Normal of the layers of a toolpath, in its frame: the z of `part_from_layers`.
Eigen::Vector3d normalOfLayers(const Toolpath& toolpath);

/// Distance from an end, or a corner, within which cells count as such [mm].
constexpr double kRegionReach = 10.0;

constexpr std::uint32_t kNoCellBelow = 0xFFFFFFFFU;
/// For each cell of a layer the nearest cell of the layer below, by distance in the plane square to the
/// normal; `kNoCellBelow` if none is within the width of its bead.
std::vector<std::uint32_t> cellsBelow(const LayerCells& layer, const LayerCells& below,
                                      const Eigen::Vector3d& normal);

/// Number of cells of a layer, counted from its first one, that the nozzle has passed by at least
/// `settle_mm`. How far it has passed a cell is the length that it has deposited since, on later paths too.
/// @param path       on which the nozzle is: number in the layer, travels included
/// @param along_mm   distance of the nozzle from the start of that path
/// @param settle_mm  not negative
std::size_t cellsPassed(const LayerCells& cells, std::size_t path, double along_mm, double settle_mm);

/// Mean by length of a value over all cells; 0 if there are none.
double meanOverCells(const LayerCells& cells, const std::vector<double>& values);

}  // namespace lamina
