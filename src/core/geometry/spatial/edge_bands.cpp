// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/spatial/edge_bands.hpp"

#include <cmath>
#include <numeric>

#include "geometry/polygon/one_side.hpp"
#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

bool reachesAcross(const BorderEdge& edge, double y) { return (edge.from.y() > y) != (edge.to.y() > y); }

/// Of an edge that reaches across the line at that y.
double crossingAt(const BorderEdge& edge, double y) {
  const auto& [from, to] = edge;
  return from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
}

}  // namespace

EdgeBands::EdgeBands(const Regions& regions) {
  double spanned_mm = 0.0;
  for (const Region& region : regions)
    forEachEdge(region, [&](const BorderEdge& edge) {
      box_.include(edge.from);
      spanned_mm += std::abs(edge.to.y() - edge.from.y());
      edges_.push_back(edge);
    });
  if (edges_.empty()) return;
  const double height_mm = std::max(box_.size().y(), 1e-9);
  const double most =
      static_cast<double>(edges_.size()) * std::min(0.5, 2.0 * height_mm / std::max(spanned_mm, 1e-9));
  const std::size_t bands = std::max<std::size_t>(1, static_cast<std::size_t>(most));
  per_mm_ = static_cast<double>(bands) / height_mm;
  begin_.assign(bands + 1, 0);
  for (const BorderEdge& edge : edges_) {
    const auto [low, high] = bandsOf(edge);
    for (std::size_t band = low; band <= high; ++band) ++begin_[band + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  in_band_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const auto [low, high] = bandsOf(edges_[i]);
    for (std::size_t band = low; band <= high; ++band) in_band_[next[band]++] = i;
  }
}

bool EdgeBands::areApartFrom(const BorderEdge& edge) const {
  const auto [low_x, high_x] = std::minmax(edge.from.x(), edge.to.x());
  const auto [low_y, high_y] = std::minmax(edge.from.y(), edge.to.y());
  if (begin_.empty() || high_y < box_.low.y() || low_y > box_.high.y()) return true;
  if (high_x < box_.low.x() || low_x > box_.high.x()) return true;
  const auto [low, high] = bandsOf(edge);
  for (std::uint32_t k = begin_[low]; k < begin_[high + 1]; ++k) {
    const BorderEdge& other = edges_[in_band_[k]];
    if (std::max(other.from.x(), other.to.x()) < low_x || std::min(other.from.x(), other.to.x()) > high_x)
      continue;
    if (!leavesOnOneSide(other.from, other.to, edge.from, edge.to) &&
        !leavesOnOneSide(edge.from, edge.to, other.from, other.to))
      return false;
  }
  return true;
}

bool EdgeBands::enclose(const Point2& point) const {
  if (begin_.empty() || (point.array() < box_.low.array()).any() || (point.array() > box_.high.array()).any())
    return false;
  bool is_inside = false;
  visitBetween(point.y(), point.y(), [&](const BorderEdge& edge, std::uint32_t) {
    if (reachesAcross(edge, point.y()) && point.x() < crossingAt(edge, point.y())) is_inside = !is_inside;
  });
  return is_inside;
}

std::vector<double> EdgeBands::crossings(double y) const {
  std::vector<double> found;
  visitBetween(y, y, [&](const BorderEdge& edge, std::uint32_t) {
    if (reachesAcross(edge, y)) found.push_back(crossingAt(edge, y));
  });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<double> EdgeBands::cuts(const Point2& from, const Point2& to) const {
  std::vector<double> found;
  const Point2 along = to - from;
  const auto [low_y, high_y] = std::minmax(from.y(), to.y());
  visitBetween(low_y, high_y, [&](const BorderEdge& edge, std::uint32_t) {
    const double side_from = cross(along, edge.from - from);
    const double side_to = cross(along, edge.to - from);
    if ((side_from > 0.0) == (side_to > 0.0)) return;
    const Point2 crossing = edge.from + (edge.to - edge.from) * (side_from / (side_from - side_to));
    const double at = (crossing - from).dot(along) / along.squaredNorm();
    if (at > 0.0 && at < 1.0) found.push_back(at);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());  // an edge stands in several bands
  return found;
}

std::pair<std::size_t, std::size_t> EdgeBands::bandsOf(const BorderEdge& edge) const {
  const auto [low, high] = std::minmax(edge.from.y(), edge.to.y());
  return {bandOf(low), bandOf(high)};
}

}  // namespace lamina
