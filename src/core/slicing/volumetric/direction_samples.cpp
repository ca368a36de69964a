// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/volumetric/direction_samples.hpp"

#include <array>
#include <cstddef>

#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"

namespace lamina {

std::vector<DirectionSample> readDirectionSamples(const std::string& path) {
  const CsvTable table = readCsvTable(path);
  const auto columnsOf = [&table](const char* x, const char* y, const char* z) {
    return std::array<std::size_t, 3>{columnOf(table, x), columnOf(table, y), columnOf(table, z)};
  };
  const std::array<std::size_t, 3> place = columnsOf("x", "y", "z");
  const std::array<std::size_t, 3> direction = columnsOf("nx", "ny", "nz");
  if (table.rows.empty())
    throw InvalidInput("'" + path + "' has 0 rows; expected a direction in one at least");
  const auto pointIn = [&table](std::size_t row, const std::array<std::size_t, 3>& column) {
    return Point3(numberAt(table, row, column[0]), numberAt(table, row, column[1]),
                  numberAt(table, row, column[2]));
  };
  std::vector<DirectionSample> samples;
  samples.reserve(table.rows.size());
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const Point3 along = pointIn(row, direction);
    const Point3 unit = along.stableNormalized();
    if (unit.isZero()) refuseRow(table, row, "nx, ny and nz are 0; expected a direction");
    samples.push_back({pointIn(row, place), unit});
  }
  return samples;
}

std::vector<DirectionSample> transformed(std::vector<DirectionSample> samples,
                                         const Eigen::Affine3d& transform) {
  const Eigen::Matrix3d of_normals = transform.linear().inverse().transpose();
  for (DirectionSample& sample : samples) {
    sample.place = transform * sample.place;
    sample.direction = (of_normals * sample.direction).normalized();
  }
  return samples;
}

}  // namespace lamina
