// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/grid_sections.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "infill/rectilinear/raster.hpp"

namespace lamina {
namespace {

/// Nodes of a row from one index to another, both included.
struct NodeRun {
  std::int64_t first = 0;
  std::int64_t last = 0;
};
using NodeRow = std::vector<NodeRun>;

/// Nodes this near to the perimeter are on it, and count as inside [distances].
constexpr double kOnPerimeter = 1e-9;

/// Rows of a grid whose node 0 of row 0 is the origin.
std::vector<NodeRow> rowsInside(const Raster& raster) {
  std::vector<NodeRow> rows(raster.line_begin.empty() ? 0 : raster.line_begin.size() - 1);
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t i = raster.line_begin[row]; i + 1 < raster.line_begin[row + 1]; i += 2) {
      const double left = raster.crossings[raster.sorted[i]].x / raster.spacing_mm;
      const double right = raster.crossings[raster.sorted[i + 1]].x / raster.spacing_mm;
      const NodeRun run{static_cast<std::int64_t>(std::ceil(left - kOnPerimeter)),
                        static_cast<std::int64_t>(std::floor(right + kOnPerimeter))};
      if (run.first <= run.last) rows[row].push_back(run);
    }
  return rows;
}

/// Runs without the node at either end.
NodeRow shortened(const NodeRow& row) {
  NodeRow result;
  for (const NodeRun& run : row)
    if (run.first + 1 <= run.last - 1) result.push_back({run.first + 1, run.last - 1});
  return result;
}

NodeRow common(const NodeRow& a, const NodeRow& b) {
  NodeRow result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const NodeRun both{std::max(a[i].first, b[j].first), std::min(a[i].last, b[j].last)};
    if (both.first <= both.last) result.push_back(both);
    ++(a[i].last < b[j].last ? i : j);
  }
  return result;
}

std::vector<NodeRow> interior(const std::vector<NodeRow>& rows) {
  std::vector<NodeRow> result(rows.size());
  for (std::size_t i = 1; i + 1 < rows.size(); ++i)
    result[i] = common(shortened(rows[i]), common(shortened(rows[i - 1]), shortened(rows[i + 1])));
  return result;
}

std::vector<std::size_t> beside(const NodeRun& run, const NodeRow& row) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i].first <= run.last && row[i].last >= run.first) found.push_back(i);
  return found;
}

class SectionBuilder {
 public:
  SectionBuilder(std::vector<NodeRow> rows, const Raster& raster) : rows_(std::move(rows)), raster_(raster) {
    for (const NodeRow& row : rows_) is_taken_.emplace_back(row.size(), false);
  }

  std::vector<GridSection> build() {
    std::size_t most = 0;
    for (const NodeRow& row : rows_) most = std::max(most, row.size());
    std::vector<GridSection> sections;
    for (std::size_t crossing = 0; crossing < most; ++crossing)
      for (std::size_t row = 0; row < rows_.size(); ++row)
        if (crossing < rows_[row].size() && !is_taken_[row][crossing])
          sections.push_back(climb(row, crossing));
    return sections;
  }

 private:
  std::vector<std::size_t> neighbours(std::size_t row, std::size_t run, std::size_t other_row) const {
    return other_row < rows_.size() ? beside(rows_[row][run], rows_[other_row]) : std::vector<std::size_t>();
  }

  /// The only run above that has no other run below.
  std::optional<std::size_t> successor(std::size_t row, std::size_t run) const {
    const std::vector<std::size_t> above = neighbours(row, run, row + 1);
    if (above.size() != 1 || is_taken_[row + 1][above[0]]) return std::nullopt;
    if (neighbours(row + 1, above[0], row).size() != 1) return std::nullopt;
    return above[0];
  }

  /// The lowest run of the section that a run belongs to.
  GridSection climb(std::size_t row, std::size_t run) {
    while (row > 0) {
      const std::vector<std::size_t> below = neighbours(row, run, row - 1);
      if (below.size() != 1 || is_taken_[row - 1][below[0]]) break;
      if (neighbours(row - 1, below[0], row).size() != 1) break;
      --row;
      run = below[0];
    }
    GridSection section;
    section.is_bordered_below = row == 0 || neighbours(row, run, row - 1).empty();
    for (std::optional<std::size_t> next = run; next; ++row) {
      run = *next;
      is_taken_[row][run] = true;
      section.passes.push_back(passOf(row, run));
      next = successor(row, run);
    }
    section.is_bordered_above = neighbours(row - 1, run, row).empty();
    return section;
  }

  Polyline passOf(std::size_t row, std::size_t run) const {
    const double y =
        static_cast<double>(raster_.lowest + static_cast<std::int64_t>(row)) * raster_.spacing_mm;
    const NodeRun& nodes = rows_[row][run];
    Polyline pass = {{static_cast<double>(nodes.first) * raster_.spacing_mm, y}};
    if (nodes.last > nodes.first) pass.emplace_back(static_cast<double>(nodes.last) * raster_.spacing_mm, y);
    return pass;
  }

  std::vector<NodeRow> rows_;
  const Raster& raster_;
  std::vector<std::vector<bool>> is_taken_;
};

Polygon moved(const Polygon& polygon, const Point2& by) {
  Polygon result;
  result.reserve(polygon.size());
  for (const Point2& point : polygon) result.emplace_back(point + by);
  return result;
}

}  // namespace

std::vector<GridSection> gridSections(const std::vector<Polygon>& perimeter, double distance_mm,
                                      const Point2& node) {
  Regions at_node;
  for (const Polygon& outline : perimeter) at_node.push_back({moved(outline, -node), {}});
  const Raster raster = rasterise(at_node, distance_mm, RasterFrame(0.0));
  std::vector<GridSection> sections = SectionBuilder(interior(rowsInside(raster)), raster).build();
  for (GridSection& section : sections)
    for (Polyline& pass : section.passes) pass = moved(pass, node);
  return sections;
}

}  // namespace lamina
