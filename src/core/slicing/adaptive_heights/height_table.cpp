// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adaptive_heights/height_table.hpp"

#include <cmath>

#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kTableGap = 1e-6;  // mm: what decimals of a table may leave

}  // namespace

std::string heightTable(const std::vector<LayerBounds>& bounds) {
  std::string text = "z_mm,height_mm\n";
  const double bottom_mm = bounds.empty() ? 0.0 : bounds.front().bottom_mm;
  for (const LayerBounds& layer : bounds)
    text += exactText(layer.top_mm - bottom_mm) + "," + exactText(layer.height()) + "\n";
  return text;
}

std::vector<LayerBounds> readHeightTable(const std::string& path, double bottom_mm, double top_mm) {
  const CsvTable table = readCsvTable(path);
  const std::size_t z_column = columnOf(table, "z_mm");
  const std::size_t height_column = columnOf(table, "height_mm");
  std::vector<LayerBounds> bounds;
  double reached_mm = 0.0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double z_mm = numberAt(table, row, z_column);
    const double height_mm = numberAt(table, row, height_column);
    if (!(height_mm > 0.0))
      refuseRow(table, row, "height_mm is " + numberText(height_mm) + " mm; must be positive");
    if (std::abs(z_mm - height_mm - reached_mm) > kTableGap)
      refuseRow(table, row,
                "the layer begins at " + numberText(z_mm - height_mm) + " mm; expected " +
                    numberText(reached_mm) + " mm, where the one before ends");
    bounds.push_back({bottom_mm + reached_mm, bottom_mm + z_mm});
    reached_mm = z_mm;
  }
  const double last_mm = bounds.empty() ? 0.0 : bounds.back().height();
  if (bottom_mm + reached_mm < top_mm - 0.5 * last_mm - kTableGap)
    throw InvalidInput("'" + path + "' ends at " + numberText(reached_mm) + " mm; the part is " +
                       numberText(top_mm - bottom_mm) + " mm high across its layers");
  while (!bounds.empty() && !(bounds.back().cut() < top_mm)) bounds.pop_back();
  return bounds;
}

}  // namespace lamina
