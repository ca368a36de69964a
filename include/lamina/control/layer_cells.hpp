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
  bool is_after_other = false;  ///< whether what is deposited just before it has no cells

  double cellLength() const { return length_mm / static_cast<double>(count); }  ///< [mm]
};

/// Region of its path in which a cell lies; growth differs between regions: within `kRegionReach` of an end
/// of an open path, within that distance of a corner (a change of direction by more than 30 deg), or
/// elsewhere.
enum class CellRegion : std::uint8_t { Straight, End, Corner };

/// The neighbours of a cell across the beads: on each side, seen against growth, the nearest cell of a
/// neighbouring bead whose middle lies within 1.25 bead widths. A neighbouring bead belongs to another path,
/// or to the same path at least two bead widths further along it.
struct CellsBeside {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::uint32_t left = kNone;
  std::uint32_t right = kNone;
  float left_mm = 0.0F;   ///< distance of the middles; without meaning if `left` is `kNone`
  float right_mm = 0.0F;  ///< distance of the middles; without meaning if `right` is `kNone`
};

/// A layer divided into cells: pieces of its depositing paths, equally long within a path. The vectors have
/// one value per cell.
struct LayerCells {
  std::size_t layer = 0;
  std::vector<CellRun> runs;
  std::vector<Point3> middle;      ///< middle of the bead's top [mm, frame of the toolpath]
  std::vector<double> along_mm;    ///< distance of the middle from the start of the path
  std::vector<double> height_mm;   ///< planned height of the layer
  std::vector<double> width_mm;    ///< width of the bead
  std::vector<double> speed_mm_s;  ///< planned speed of travel
  std::vector<CellRegion> region;
  std::vector<Eigen::Vector3d> tangent;  ///< from start to end of the cell; unit
  /// Direction away from the surface below; unit. It is perpendicular to the tangent, except in plane layers.
  std::vector<Eigen::Vector3d> growth;

  std::vector<CellsBeside> beside;  ///< neighbours across the beads
  bool ends_with_other = false;     ///< whether what is deposited last has no cells

  std::size_t size() const { return middle.size(); }
};

/// Whether a path is divided into cells. Other paths are deposited as planned.
bool hasCells(const Path& path);

/// Divides a layer into cells. Travels, drops and build aids (skirt, supports and the like) have none.
///
/// A layer whose paths lie within its own height of one another along the normal counts as plane, and grows
/// along the normal. In any other layer the growth direction is the component, perpendicular to the path, of
/// the direction against the tool axis.
/// @param index  number of the layer
/// @param cell_mm  greatest length of a cell; positive
/// @param normal  of the layers, in the frame of the toolpath; unit
/// @throws InvalidInput if the cell length is not positive and finite
LayerCells layerCells(const ToolpathLayer& layer, std::size_t index, double cell_mm,
                      const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ());

/// Normal of the layers of a toolpath, in its frame: the z of `part_from_layers`.
Eigen::Vector3d normalOfLayers(const Toolpath& toolpath);

/// Distance from an end or a corner within which cells belong to it [mm].
constexpr double kRegionReach = 10.0;

constexpr std::uint32_t kNoCellBelow = 0xFFFFFFFFU;
/// For each cell of a layer the nearest cell of the layer below, by distance in the plane perpendicular to
/// the normal; `kNoCellBelow` if none lies within the width of the cell's bead. For a cell that does not grow
/// along the normal, it is the cell nearest to the point one layer height below along its own growth
/// direction.
std::vector<std::uint32_t> cellsBelow(const LayerCells& layer, const LayerCells& below,
                                      const Eigen::Vector3d& normal);

/// Number of cells of a layer, from its first one on, that the nozzle has left behind. A cell is left behind
/// if the nozzle has deposited at least `settle_mm` since the end of the cell, on later paths too.
/// @param path       number in the layer of the path on which the nozzle is, travels included
/// @param along_mm   distance of the nozzle from the start of that path
/// @param settle_mm  not negative
std::size_t cellsPassed(const LayerCells& cells, std::size_t path, double along_mm, double settle_mm);

/// Mean of a value over all cells, weighted by their length; 0 if there are none.
double meanOverCells(const LayerCells& cells, const std::vector<double>& values);

}  // namespace lamina
