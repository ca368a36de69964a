// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/voxel_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/picture/annotation.hpp"
#include "lamina/picture/canvas.hpp"

namespace lamina {
namespace {

constexpr int kWidth = 1200;
constexpr int kHeight = 900;
constexpr int kAround = 4;  // voxels shown around what is solid
constexpr Colour kOpen{0.93, 0.94, 0.96};
constexpr Colour kSolid{0.13, 0.22, 0.36};

/// Axes of a sheet: to the right and up on the picture.
std::array<std::size_t, 2> axesOf(const VoxelSheet& sheet) {
  return {sheet.axis == 0 ? std::size_t{1} : std::size_t{0},
          sheet.axis == 2 ? std::size_t{1} : std::size_t{2}};
}

VoxelRange shownRange(const VoxelGrid& grid) {
  VoxelRange range = grid.solidRange();
  if (range.isEmpty()) throw InvalidInput("nothing is solid in the voxels to be drawn");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    range.low[axis] -= kAround;
    range.high[axis] += kAround;
  }
  return range;
}

Colour between(double solid) {
  return {kOpen.red + solid * (kSolid.red - kOpen.red), kOpen.green + solid * (kSolid.green - kOpen.green),
          kOpen.blue + solid * (kSolid.blue - kOpen.blue)};
}

/// Cells of `factor` by `factor` voxels, each coloured by its share that is solid.
CellColours voxelCellsOf(const VoxelGrid& grid, const VoxelSheet& sheet, const VoxelRange& range,
                         int factor) {
  const auto [across, up] = axesOf(sheet);
  CellColours cells;
  cells.columns = (range.high[across] - range.low[across] + factor - 1) / factor;
  cells.rows = (range.high[up] - range.low[up] + factor - 1) / factor;
  std::vector<int> solid(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows), 0);
  std::array<int, 3> at{};
  at[sheet.axis] = sheet.index;
  for (at[up] = range.low[up]; at[up] < range.high[up]; ++at[up])
    for (at[across] = range.low[across]; at[across] < range.high[across]; ++at[across]) {
      if (!grid.isSolid(at[0], at[1], at[2])) continue;
      const int row = (at[up] - range.low[up]) / factor;
      const int column = (at[across] - range.low[across]) / factor;
      ++solid[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns) +
              static_cast<std::size_t>(column)];
    }
  cells.cells.reserve(solid.size());
  for (const int count : solid) cells.cells.push_back(between(double(count) / (factor * factor)));
  return cells;
}

Point2 cornerOf(const VoxelFrame& frame, const VoxelSheet& sheet, const std::array<int, 3>& at) {
  const auto [across, up] = axesOf(sheet);
  const auto mm = [&](std::size_t axis) {
    return frame.corner[static_cast<Eigen::Index>(axis)] + frame.voxel_mm * at[axis];
  };
  return {mm(across), mm(up)};
}

}  // namespace

VoxelSheet sheetAt(const VoxelFrame& frame, std::size_t axis, double at_mm) {
  const double corner = frame.corner[static_cast<Eigen::Index>(axis)];
  const double index = std::floor((at_mm - corner) / frame.voxel_mm);
  if (!(index >= 0.0 && index < frame.count[axis]))
    throw InvalidInput(std::string("section at ") + "xyz"[axis] + " = " + numberText(at_mm) +
                       " mm; expected " + numberText(corner) + " to " +
                       numberText(corner + frame.voxel_mm * frame.count[axis]) + " mm");
  return {axis, static_cast<int>(index)};
}

void drawVoxelSheet(const std::string& path, const VoxelGrid& grid, const VoxelSheet& sheet,
                    const PictureTitle& title) {
  const VoxelFrame& frame = grid.frame();
  const VoxelRange range = shownRange(grid);
  Canvas canvas(kWidth, kHeight);
  drawTitle(canvas, title.title, title.subtitle);
  canvas.show({cornerOf(frame, sheet, range.low), cornerOf(frame, sheet, range.high)},
              {Point2(30, 90), Point2(kWidth - 30, kHeight - 80)});
  const int factor = std::max(1, static_cast<int>(1.0 / (canvas.pixelsPerMm() * frame.voxel_mm)));
  const CellColours cells = voxelCellsOf(grid, sheet, range, factor);
  const Point2 low = cornerOf(frame, sheet, range.low);
  const Point2 size = factor * frame.voxel_mm * Point2(cells.columns, cells.rows);
  canvas.raster({low, low + size}, cells);
  drawScaleBar(canvas, Point2(40, kHeight - 30));
  canvas.writePng(path);
}

}  // namespace lamina
