// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

struct BorderEdge {
  Point2 from;
  Point2 to;
};

/// Calls visit(edge) for the edges of its outline and then of its holes, in their order.
template <class Visit>
void forEachEdge(const Region& region, const Visit& visit) {
  const auto walk = [&](const Polygon& border) {
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++)
      visit(BorderEdge{border[j], border[i]});
  };
  walk(region.outer);
  for (const Polygon& hole : region.holes) walk(hole);
}

/// Edges of regions sorted into bands of equal y, in number such that an edge lies in at most three bands on
/// average. Queries at a point examine only the edges at about the same y.
class EdgeBands {
 public:
  /// Makes an empty set.
  EdgeBands() = default;
  explicit EdgeBands(const Regions& regions);

  const Box2& box() const { return box_; }

  /// Whether certainly none of the edges meets the given one.
  bool areApartFrom(const BorderEdge& edge) const;

  /// Whether a point lies inside, by the even-odd rule; on a border the result may be either.
  bool enclose(const Point2& point) const;

  /// The x at which edges cross the line at a given y, from left to right: the inside begins and ends at
  /// alternate crossings.
  std::vector<double> crossings(double y) const;

  /// Positions at which a segment crosses edges, ascending, as shares of its length between 0 and 1.
  std::vector<double> cuts(const Point2& from, const Point2& to) const;

  /// Calls visit(edge, index) for all edges that come within `reach_mm` of the y of a point, and for some
  /// others; an edge in several bands may be visited more than once. The index is that of the edge among all
  /// edges.
  template <class Visit>
  void visitNear(const Point2& point, double reach_mm, const Visit& visit) const {
    visitBetween(point.y() - reach_mm, point.y() + reach_mm, visit);
  }

 private:
  template <class Visit>
  void visitBetween(double low_y, double high_y, const Visit& visit) const {
    if (begin_.empty() || high_y < box_.low.y() || low_y > box_.high.y()) return;
    const std::size_t last = bandOf(high_y);
    for (std::size_t band = bandOf(low_y); band <= last; ++band)
      for (std::uint32_t k = begin_[band]; k < begin_[band + 1]; ++k) visit(edges_[in_band_[k]], in_band_[k]);
  }
  std::size_t bandOf(double y) const {
    const double band = (y - box_.low.y()) * per_mm_;
    return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(begin_.size() - 2)));
  }
  std::pair<std::size_t, std::size_t> bandsOf(const BorderEdge& edge) const;

  Box2 box_;
  double per_mm_ = 0.0;
  std::vector<BorderEdge> edges_;
  std::vector<std::uint32_t>
      begin_;  ///< for each band the position in in_band_, and the end of the last one; empty without edges
  std::vector<std::uint32_t> in_band_;  ///< indices of edges
};

}  // namespace lamina
