// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/part_samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr std::uint64_t kSeed = 5;

}  // namespace

Point3 densestPlace(const std::vector<Point3>& points, double within_mm) {
  std::size_t most = 0;
  Point3 densest = points.front();
  for (const Point3& point : points) {
    std::size_t near = 0;
    for (const Point3& other : points)
      if ((other - point).squaredNorm() <= within_mm * within_mm) ++near;
    if (near <= most) continue;
    most = near;
    densest = point;
  }
  return densest;
}

PartSamples::PartSamples(const Mesh& mesh, std::size_t count)
    : spacing_(std::cbrt(volume(mesh) / static_cast<double>(count))) {
  const Box3 box = boundingBox(mesh);
  low_ = box.low.head<2>();
  const auto cells = [this](double length) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(length / spacing_)));
  };
  columns_x_ = cells(box.size().x());
  columns_y_ = cells(box.size().y());
  Random random(kSeed);
  columns_.resize(columns_x_ * columns_y_);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t row = i / columns_x_;
    const Point2 cell(static_cast<double>(i % columns_x_), static_cast<double>(row));
    const double x = random.uniform(0.0, 1.0);
    const double y = random.uniform(0.0, 1.0);
    columns_[i].place = low_ + spacing_ * (cell + Point2(x, y));
  }
  auto found = crossings(mesh);
  for (std::size_t i = 0; i < columns_.size(); ++i) fill(columns_[i], std::move(found[i]), box.low.z());
}

std::size_t PartSamples::cellOf(double offset, std::size_t count) const {
  const double cell = std::floor(offset / spacing_);
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
}

/// Heights at which the mesh crosses each column, with 1 where the column goes in from below, -1 where out.
std::vector<std::vector<std::pair<double, int>>> PartSamples::crossings(const Mesh& mesh) const {
  std::vector<std::vector<std::pair<double, int>>> found(columns_.size());
  for (const Triangle& corner : mesh.triangles) {
    const Point3& a = mesh.vertices[corner[0]];
    const Point3& b = mesh.vertices[corner[1]];
    const Point3& c = mesh.vertices[corner[2]];
    const Point2 low = a.cwiseMin(b).cwiseMin(c).head<2>() - low_;
    const Point2 high = a.cwiseMax(b).cwiseMax(c).head<2>() - low_;
    const double whole = side(a.head<2>(), b.head<2>(), c.head<2>());
    if (whole == 0.0) continue;
    const std::size_t last_x = cellOf(high.x(), columns_x_);
    const std::size_t last_y = cellOf(high.y(), columns_y_);
    for (std::size_t y = cellOf(low.y(), columns_y_); y <= last_y; ++y)
      for (std::size_t x = cellOf(low.x(), columns_x_); x <= last_x; ++x) {
        const Point2& place = columns_[y * columns_x_ + x].place;
        const double u = side(place, b.head<2>(), c.head<2>()) / whole;
        const double v = side(a.head<2>(), place, c.head<2>()) / whole;
        const double w = 1.0 - u - v;
        if (u < 0.0 || v < 0.0 || w < 0.0) continue;
        found[y * columns_x_ + x].emplace_back(u * a.z() + v * b.z() + w * c.z(), whole < 0.0 ? 1 : -1);
      }
  }
  return found;
}

void PartSamples::fill(Column& column, std::vector<std::pair<double, int>> crossings, double low_z) {
  column.first = static_cast<std::uint32_t>(points_.size());
  column.last = column.first;
  std::sort(crossings.begin(), crossings.end());
  int depth = 0;
  for (const auto& crossing : crossings) depth += crossing.second;
  if (depth != 0) return;  // it runs along an edge and one crossing is missing or double
  Random random(kSeed + column.first + crossings.size());
  std::size_t next = 0;
  if (crossings.empty()) return;
  for (double cell = 0.0; low_z + cell * spacing_ <= crossings.back().first; ++cell) {
    const double z = low_z + spacing_ * (cell + random.uniform(0.0, 1.0));
    while (next < crossings.size() && crossings[next].first <= z) depth += crossings[next++].second;
    if (depth > 0) points_.emplace_back(column.place.x(), column.place.y(), z);
  }
  column.last = static_cast<std::uint32_t>(points_.size());
}

}  // namespace lamina
