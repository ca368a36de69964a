// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lightning/edge_rows.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kMostRows = 1e5;

double crossingAt(const Point2& a, const Point2& b, double y) {
  return a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

}  // namespace

EdgeRows::EdgeRows(const Regions& regions, double row_mm) : row_mm_(row_mm) {
  const std::vector<Polygon> borders = outlines(regions);
  box_ = boundingBox(borders);
  if (box_.isEmpty()) return;
  row_mm_ = std::max(row_mm_, box_.size().y() / kMostRows);
  rows_.resize(1 + static_cast<std::size_t>(box_.size().y() / row_mm_));
  for (const Polygon& border : borders)
    for (std::size_t i = 0; i < border.size(); ++i) {
      const Edge edge{border[i], border[(i + 1) % border.size()]};
      const std::size_t last = rowOf(std::max(edge.first.y(), edge.second.y()));
      for (std::size_t row = rowOf(std::min(edge.first.y(), edge.second.y())); row <= last; ++row)
        rows_[row].push_back(edge);
    }
}

std::size_t EdgeRows::rowOf(double y) const {
  const double row = (y - box_.low.y()) / row_mm_;
  return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
}

std::vector<double> EdgeRows::crossings(double y) const {
  std::vector<double> found;
  if (rows_.empty()) return found;
  for (const auto& [a, b] : rows_[rowOf(y)])
    if ((a.y() > y) != (b.y() > y)) found.push_back(crossingAt(a, b, y));
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<double> EdgeRows::cuts(const Point2& from, const Point2& to) const {
  std::vector<double> found;
  if (rows_.empty()) return found;
  const Point2 along = to - from;
  const std::size_t last = rowOf(std::max(from.y(), to.y()));
  for (std::size_t row = rowOf(std::min(from.y(), to.y())); row <= last; ++row)
    for (const auto& [a, b] : rows_[row]) {
      const double side_a = cross(along, a - from);
      const double side_b = cross(along, b - from);
      if ((side_a > 0.0) == (side_b > 0.0)) continue;
      const Point2 crossing = a + (b - a) * (side_a / (side_a - side_b));
      const double at = (crossing - from).dot(along) / along.squaredNorm();
      if (at > 0.0 && at < 1.0) found.push_back(at);
    }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());  // an edge stands in several rows
  return found;
}

bool EdgeRows::contains(const Point2& place) const {
  if (rows_.empty()) return false;
  bool is_inside = false;
  for (const auto& [a, b] : rows_[rowOf(place.y())])
    if ((a.y() > place.y()) != (b.y() > place.y()) && crossingAt(a, b, place.y()) > place.x())
      is_inside = !is_inside;
  return is_inside;
}

}  // namespace lamina
