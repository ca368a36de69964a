// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/csv/coordinate_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

double filamentArea(double diameter_mm) {
  if (!(diameter_mm > 0.0))
    throw InvalidInput("the filament diameter is " + std::to_string(diameter_mm) + " mm; must be positive");
  return 0.25 * M_PI * diameter_mm * diameter_mm;
}

void appendTrajectory(const Path& path, double filament_area_mm2, std::vector<CoordinateRow>& rows) {
  if (path.deposit == Deposit::Drops)
    throw InvalidInput("the toolpath lays drops; expected beads, which trajectories are made of");
  rows.push_back({path.firstPoint(), CoordinateFlag::Start, 0.0});
  double filament_mm = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    const double length_mm = (path.points[end] - path.points[m]).norm();
    filament_mm += length_mm * crossSection(path.bead.at(end)) / filament_area_mm2;
    rows.push_back({path.points[end], CoordinateFlag::Continue, filament_mm});
  }
}

void moveToCorner(std::vector<CoordinateRow>& rows) {
  if (rows.empty()) return;
  Point3 low = rows.front().point;
  for (const CoordinateRow& row : rows) low = low.cwiseMin(row.point);
  const Point3 shift(kMatrixCorner - low.x(), kMatrixCorner - low.y(), 0.0);
  for (CoordinateRow& row : rows) row.point += shift;
}

}  // namespace

std::vector<CoordinateRow> coordinateMatrix(const Toolpath& toolpath, double filament_diameter_mm) {
  const double area_mm2 = filamentArea(filament_diameter_mm);
  std::vector<CoordinateRow> rows;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (isPartOfPart(path)) appendTrajectory(path, area_mm2, rows);
  moveToCorner(rows);
  return rows;
}

std::string toCsv(const std::vector<CoordinateRow>& rows) {
  std::string text = "x_m,y_m,z_m,flag,e_mm\n";
  char line[160];
  for (const CoordinateRow& row : rows) {
    const Point3 metres = row.point / 1e3;
    const int size = std::snprintf(line, sizeof line, "%.7f,%.7f,%.7f,%d,%.5f\n", metres.x(), metres.y(),
                                   metres.z(), static_cast<int>(row.flag), row.filament_mm);
    text.append(line, static_cast<std::size_t>(size));
  }
  return text;
}

std::size_t trajectoryCount(const std::vector<CoordinateRow>& rows) {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [](const CoordinateRow& row) { return row.flag == CoordinateFlag::Start; }));
}

double extrusionWidth(double filament_mm, double length_mm, double height_mm, double filament_diameter_mm) {
  if (!(length_mm > 0.0 && height_mm > 0.0 && filament_mm >= 0.0))
    throw InvalidInput("filament " + std::to_string(filament_mm) + " mm over " + std::to_string(length_mm) +
                       " mm in a layer of " + std::to_string(height_mm) +
                       " mm has no width; expected a positive length and height and no negative filament");
  return beadWidth(filament_mm * filamentArea(filament_diameter_mm) / length_mm, height_mm);
}

}  // namespace lamina
