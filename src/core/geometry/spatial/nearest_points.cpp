// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/spatial/nearest_points.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace lamina {
namespace {

constexpr std::size_t kFewPoints = 8;  // that are looked through one by one

bool isNearer(const NearPoint& a, const NearPoint& b) {
  return a.squared != b.squared ? a.squared < b.squared : a.index < b.index;
}

}  // namespace

struct NearestPoints::Search {
  const Point3& place;
  std::size_t count;
  std::vector<NearPoint> found = {};  // nearest first

  double bound() const {
    return found.size() < count ? std::numeric_limits<double>::infinity() : found.back().squared;
  }
  void add(const NearPoint& point) {
    if (found.size() == count) {
      if (!isNearer(point, found.back())) return;
      found.pop_back();
    }
    found.insert(std::upper_bound(found.begin(), found.end(), point, isNearer), point);
  }
};

NearestPoints::NearestPoints(std::vector<Point3> points)
    : points_(std::move(points)), order_(points_.size()), axis_(points_.size(), 0) {
  std::iota(order_.begin(), order_.end(), 0U);
  build(0, order_.size());
}

void NearestPoints::build(std::size_t first, std::size_t last) {
  if (last - first <= kFewPoints) return;
  Point3 low = points_[order_[first]];
  Point3 high = low;
  for (std::size_t i = first; i < last; ++i) {
    low = low.cwiseMin(points_[order_[i]]);
    high = high.cwiseMax(points_[order_[i]]);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
    const double left = points_[a][axis];
    const double right = points_[b][axis];
    return left != right ? left < right : a < b;
  });
  axis_[middle] = static_cast<std::uint8_t>(axis);
  build(first, middle);
  build(middle + 1, last);
}

void NearestPoints::visit(std::size_t first, std::size_t last, Search& search) const {
  const auto look = [&](std::size_t i) {
    search.add({(points_[order_[i]] - search.place).squaredNorm(), order_[i]});
  };
  if (last - first <= kFewPoints) {
    for (std::size_t i = first; i < last; ++i) look(i);
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  look(middle);
  const auto axis = static_cast<Eigen::Index>(axis_[middle]);
  const double beyond = search.place[axis] - points_[order_[middle]][axis];
  if (beyond < 0.0) {
    visit(first, middle, search);
    if (beyond * beyond <= search.bound()) visit(middle + 1, last, search);
  } else {
    visit(middle + 1, last, search);
    if (beyond * beyond <= search.bound()) visit(first, middle, search);
  }
}

std::vector<NearPoint> NearestPoints::nearest(const Point3& place, std::size_t count) const {
  if (count == 0) return {};
  Search search{place, count};
  visit(0, order_.size(), search);
  return std::move(search.found);
}

}  // namespace lamina
