// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/hilbert.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "infill/hilbert/angle_search.hpp"
#include "infill/hilbert/outline_links.hpp"
#include "infill/lattice/lattice.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

bool areNeighbours(const Cell& a, const Cell& b) {
  return std::abs(a.column - b.column) + std::abs(a.row - b.row) == 1;
}

/// Cuts the curve over a lattice into the runs that lie in the region; in lattice coordinates.
class CurveCutter {
 public:
  explicit CurveCutter(const Lattice& lattice) : lattice_(lattice) {}

  std::vector<RunOnOutlines> cut() && {
    const std::vector<Cell> order = hilbertOrder(lattice_.frame.columns(), lattice_.frame.rows());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Cell& cell = order[i];
      if (!lattice_.isInside(lattice_.indexOf(cell))) continue;
      const bool comes_from_inside = i > 0 && staysInside(order[i - 1], cell);
      if (!comes_from_inside) begin(cell, i > 0 ? &order[i - 1] : nullptr);
      runs_.back().points.emplace_back(cell.column, cell.row);
      const bool goes_on_inside = i + 1 < order.size() && staysInside(cell, order[i + 1]);
      if (!goes_on_inside) end(cell, i + 1 < order.size() ? &order[i + 1] : nullptr);
    }
    return std::move(runs_);
  }

 private:
  bool staysInside(const Cell& a, const Cell& b) const {
    if (!areNeighbours(a, b)) return false;
    const std::size_t low = lattice_.indexOf({std::min(a.column, b.column), std::min(a.row, b.row)});
    return a.row == b.row ? lattice_.leadsRight(low) : lattice_.leadsUp(low);
  }

  void begin(const Cell& cell, const Cell* previous) {
    runs_.emplace_back();
    if (previous == nullptr || !areNeighbours(*previous, cell)) return;
    RunOnOutlines& run = runs_.back();
    run.points.push_back(borderBetween(cell, *previous));
    run.first = placeOf(run.points.back(), crossing_);
  }

  void end(const Cell& cell, const Cell* next) {
    RunOnOutlines& run = runs_.back();
    if (next != nullptr && areNeighbours(cell, *next)) {
      run.points.push_back(borderBetween(cell, *next));
      run.last = placeOf(run.points.back(), crossing_);
    }
    if (run.points.size() < 2) runs_.pop_back();
  }

  /// Where the step from a cell inside to its neighbour leaves the region; keeps the crossing.
  Point2 borderBetween(const Cell& inside, const Cell& towards) {
    const bool is_along_row = inside.row == towards.row;
    const Raster& raster = is_along_row ? lattice_.rows : lattice_.columns;
    const std::int64_t line = is_along_row ? inside.row : -inside.column;
    const double x = is_along_row ? inside.column : inside.row;
    const bool is_upwards = is_along_row ? towards.column > inside.column : towards.row > inside.row;
    const auto after =
        std::partition_point(raster.sorted.begin(), raster.sorted.end(), [&](std::uint32_t index) {
          const Crossing& crossing = raster.crossings[index];
          return crossing.line != line ? crossing.line < line : crossing.x < x;
        });
    // A cell inside has a crossing on either side of it; one just on the cell may count as either.
    crossing_ = raster.crossings[is_upwards || after == raster.sorted.begin() ? *after : *(after - 1)];
    return is_along_row ? Point2(crossing_.x, inside.row) : Point2(inside.column, crossing_.x);
  }

  OutlinePoint placeOf(const Point2& point, const Crossing& crossing) const {
    const Point2& start = lattice_.rows.outlines[crossing.outline][crossing.edge];
    return {crossing.outline, crossing.edge, (point - start).norm()};
  }

  const Lattice& lattice_;
  Crossing crossing_;  ///< met last
  std::vector<RunOnOutlines> runs_;
};

Polyline outOfLattice(const Polyline& points, const LatticeFrame& frame) {
  Polyline result;
  result.reserve(points.size());
  for (const Point2& point : points) {
    const Point2 placed = frame.outOfLattice(point);
    if (result.empty() || (placed - result.back()).norm() > 1e-9) result.push_back(placed);
  }
  return result;
}

FillAtAngle fillAt(const Region& centre_lines, const InfillRequest& request, double angle_rad) {
  const Lattice lattice(centre_lines, request.spacing_mm, angle_rad);
  const double width = beadWidth(lattice.frame, request);
  FillAtAngle fill;
  const double longest = longestLink(request, request.spacing_mm);
  const std::vector<RunOnOutlines> runs = CurveCutter(lattice).cut();
  for (const Polyline& joined : joinAlongOutlines(runs, lattice.rows.outlines, longest)) {
    FillPath path;
    path.points = outOfLattice(joined, lattice.frame);
    if (path.points.size() < 2) continue;
    path.width_mm.assign(path.points.size(), width);
    fill.covered += length(path.points);
    fill.paths.push_back(std::move(path));
  }
  return fill;
}

}  // namespace

std::vector<FillPath> hilbert(const Regions& regions, const InfillRequest& request) {
  return fillAtBestAngle(offset(regions, -0.5 * request.pitch_mm), request, fillAt);
}

}  // namespace lamina
