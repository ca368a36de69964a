// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/beads/span_areas.hpp"

#include <algorithm>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <utility>

#include "lamina/geometry/polygon/simplify.hpp"

namespace lamina {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

struct Cell {
  std::size_t row = 0;
  Span span;
};

/// Walks round an area of cells. Side 2 i is the left side of cell i and side 2 i + 1 its right side.
class OutlineWalk {
  using Range = std::pair<std::size_t, std::size_t>;  // of cells

 public:
  /// @param cells  connected, by row, then by x
  OutlineWalk(const std::vector<Cell>& cells, const ScanRows& rows)
      : cells_(cells), rows_(rows), above_(2 * cells.size()), below_(2 * cells.size()) {
    Range lower = {0, 0};
    while (lower.second < cells.size()) {
      Range upper = {lower.second, lower.second};
      while (upper.second < cells.size() && cells[upper.second].row == cells[upper.first].row) ++upper.second;
      link(lower, upper);
      lower = upper;
    }
    link(lower, {cells.size(), cells.size()});
  }

  Region region() {
    Region region;
    std::vector<bool> is_done(2 * cells_.size(), false);
    for (std::size_t side = 0; side < is_done.size(); ++side) {
      Polygon loop = simplify(walk(side, is_done), 0.5 * rows_.spacing_mm);
      if (loop.size() < 3) continue;
      if (signedArea(loop) < 0.0)
        region.holes.push_back(std::move(loop));
      else if (signedArea(loop) > signedArea(region.outer))
        region.outer = std::move(loop);
    }
    return region;
  }

 private:
  double xOf(std::size_t side) const {
    const Span& span = cells_[side / 2].span;
    return side % 2 == 0 ? span.low : span.high;
  }

  /// Between two rows the outline runs wherever one of them has a cell and the other has none.
  void link(Range lower, Range upper) {
    struct End {
      double x;
      std::size_t side;
      bool is_below;
    };
    std::vector<End> ends;
    for (std::size_t i = lower.first; i < lower.second; ++i)
      for (const std::size_t side : {2 * i, 2 * i + 1}) ends.push_back({xOf(side), side, true});
    for (std::size_t i = upper.first; i < upper.second; ++i)
      for (const std::size_t side : {2 * i, 2 * i + 1}) ends.push_back({xOf(side), side, false});
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.x < b.x; });
    for (std::size_t k = 1; k < ends.size(); k += 2) {
      const End& a = ends[k - 1];
      const End& b = ends[k];
      (a.is_below ? above_ : below_)[a.side] = {b.side, a.is_below == b.is_below};
      (b.is_below ? above_ : below_)[b.side] = {a.side, a.is_below == b.is_below};
    }
  }

  /// Left sides are walked down and right sides up, so that the area is on the left.
  Polygon walk(std::size_t side, std::vector<bool>& is_done) const {
    Polygon loop;
    bool goes_down = side % 2 == 0;
    while (!is_done[side]) {
      is_done[side] = true;
      const double y = rows_.at(cells_[side / 2].row);
      loop.emplace_back(xOf(side), y);
      const Link& next = (goes_down ? below_ : above_)[side];
      if (next.side == kNone) break;
      if (next.is_turn) {
        const double edge = y + (goes_down ? -0.5 : 0.5) * rows_.spacing_mm;
        loop.emplace_back(xOf(side), edge);
        loop.emplace_back(xOf(next.side), edge);
        goes_down = !goes_down;
      }
      side = next.side;
    }
    return loop;
  }

  struct Link {
    std::size_t side = kNone;
    bool is_turn = false;  ///< to a side of the same row
  };

  const std::vector<Cell>& cells_;
  const ScanRows& rows_;
  std::vector<Link> above_;
  std::vector<Link> below_;
};

std::vector<Cell> cellsOf(const std::vector<Spans>& spans) {
  std::vector<Cell> cells;
  for (std::size_t row = 0; row < spans.size(); ++row)
    for (const Span& span : spans[row]) cells.push_back({row, span});
  return cells;
}

/// Cells of neighbouring rows that overlap hang together: of each cell, the first one of its area.
std::vector<std::size_t> firstOfArea(const std::vector<Cell>& cells) {
  boost::disjoint_sets_with_storage<> sets(cells.size());
  std::size_t below = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto isPassed = [&](const Cell& cell) {
      return cell.row + 1 < cells[i].row ||
             (cell.row + 1 == cells[i].row && cell.span.high <= cells[i].span.low);
    };
    while (below < i && isPassed(cells[below])) ++below;
    for (std::size_t k = below; k < i && cells[k].row + 1 == cells[i].row; ++k) {
      if (cells[k].span.low >= cells[i].span.high) break;
      sets.union_set(k, i);
    }
  }
  const boost::counting_iterator<std::size_t> begin(0);
  const boost::counting_iterator<std::size_t> end(cells.size());
  sets.compress_sets(begin, end);
  sets.normalize_sets(begin, end);
  return sets.parents();
}

}  // namespace

std::vector<SpanArea> connectedAreas(const std::vector<Spans>& spans, const ScanRows& rows,
                                     double least_mm2) {
  const std::vector<Cell> cells = cellsOf(spans);
  const std::vector<std::size_t> first = firstOfArea(cells);
  std::vector<double> area(cells.size(), 0.0);
  for (std::size_t i = 0; i < cells.size(); ++i) area[first[i]] += cells[i].span.length() * rows.spacing_mm;
  std::vector<std::vector<Cell>> members(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (area[first[i]] >= least_mm2) members[first[i]].push_back(cells[i]);
  std::vector<SpanArea> areas;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!members[i].empty()) areas.push_back({OutlineWalk(members[i], rows).region(), area[i]});
  return areas;
}

}  // namespace lamina
