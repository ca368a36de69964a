// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/drops/disc_picture.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kMostPicturePixels = 4e6;
enum PicturePixel : std::uint8_t { kPictureOutside, kMaterial, kNear, kPictureUncovered, kFilled };

}  // namespace

PixelWindow::PixelWindow(const Box2& box, double pixel_mm, double most) : low_(box.low), pixel_(pixel_mm) {
  const Point2 size = box.size();
  pixel_ = std::max(pixel_, std::sqrt(size.x() * size.y() / most));
  columns_ = 1 + static_cast<int>(size.x() / pixel_);
  rows_ = 1 + static_cast<int>(size.y() / pixel_);
  values_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
}

int PixelWindow::clamped(double position, int count) {
  return static_cast<int>(std::clamp(position, 0.0, static_cast<double>(count - 1)));
}

void PixelWindow::paintDisc(const Point2& centre, double radius, std::uint8_t from, std::uint8_t to) {
  const int last = row(centre.y() + radius);
  for (int r = row(centre.y() - radius); r <= last; ++r) {
    const double dy = low_.y() + (r + 0.5) * pixel_ - centre.y();
    const double half = radius * radius - dy * dy;
    if (half < 0.0) continue;
    const double left = (centre.x() - std::sqrt(half) - low_.x()) / pixel_ - 0.5;
    const double right = (centre.x() + std::sqrt(half) - low_.x()) / pixel_ - 0.5;
    const int end = static_cast<int>(std::min(std::floor(right), columns_ - 1.0));
    for (int c = static_cast<int>(std::max(std::ceil(left), 0.0)); c <= end; ++c)
      if (at(c, r) == from) at(c, r) = to;
  }
}

void PixelWindow::paintInside(const std::vector<Polygon>& outlines, std::uint8_t value) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
  for (const Polygon& outline : outlines) {
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      const Point2& a = outline[j].y() < outline[i].y() ? outline[j] : outline[i];
      const Point2& b = outline[j].y() < outline[i].y() ? outline[i] : outline[j];
      const double first = std::max(0.0, std::ceil((a.y() - low_.y()) / pixel_ - 0.5));
      const double end = std::min(rows_ - 1.0, std::ceil((b.y() - low_.y()) / pixel_ - 0.5) - 1.0);
      for (double r = first; r <= end; ++r) {
        const double y = low_.y() + (r + 0.5) * pixel_;
        crossings[static_cast<std::size_t>(r)].push_back(a.x() +
                                                         (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
      }
    }
  }
  for (int r = 0; r < rows_; ++r) {
    std::vector<double>& xs = crossings[static_cast<std::size_t>(r)];
    std::sort(xs.begin(), xs.end());
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
      const double end = std::min(std::floor((xs[i + 1] - low_.x()) / pixel_ - 0.5), columns_ - 1.0);
      for (double c = std::max(0.0, std::ceil((xs[i] - low_.x()) / pixel_ - 0.5)); c <= end; ++c)
        at(static_cast<int>(c), r) = value;
    }
  }
}

std::size_t PixelWindow::flood(int column, int row, std::uint8_t to) {
  const std::uint8_t from = at(column, row);
  if (from == to) return 0;
  std::size_t count = 0;
  std::vector<std::pair<int, int>> open = {{column, row}};
  at(column, row) = to;
  while (!open.empty()) {
    const auto [c, r] = open.back();
    open.pop_back();
    ++count;
    const std::pair<int, int> sides[] = {{c - 1, r}, {c + 1, r}, {c, r - 1}, {c, r + 1}};
    for (const auto& [x, y] : sides) {
      if (x < 0 || y < 0 || x >= columns_ || y >= rows_ || at(x, y) != from) continue;
      at(x, y) = to;
      open.emplace_back(x, y);
    }
  }
  return count;
}

std::size_t PixelWindow::count(std::uint8_t value) const {
  return static_cast<std::size_t>(std::count(values_.begin(), values_.end(), value));
}

PointGrid DiscPicture::gridOf(const std::vector<Point2>& points, double cell) {
  PointGrid grid(boundingBox({points}), cell);
  for (const Point2& point : points) grid.insert(point);
  return grid;
}

DiscPicture::DiscPicture(const std::vector<Point2>& prior, const std::vector<Point2>& added,
                         double diameter_mm, const std::vector<Polygon>& borders)
    : prior_(gridOf(prior, diameter_mm)),
      added_(gridOf(added, diameter_mm)),
      diameter_(diameter_mm),
      borders_(borders) {}

UncoveredArea DiscPicture::around(const std::vector<VoidPoint>& points) const {
  Box2 box;
  double greatest_mm = 0.0;
  for (const VoidPoint& point : points) {
    greatest_mm = std::max(greatest_mm, point.clearance_mm);
    box.include(point.position - Point2::Constant(point.clearance_mm));
    box.include(point.position + Point2::Constant(point.clearance_mm));
  }
  PixelWindow window(box, std::max(kPixel * diameter_, kVoidPixel * greatest_mm), kMostPicturePixels);
  window.paintInside(borders_, kMaterial);
  for (const VoidPoint& point : points)
    window.paintDisc(point.position, point.clearance_mm, kMaterial, kNear);
  const Point2 middle = box.centre();
  const double radius = kDrawnRadius * diameter_;
  const double reach = 0.5 * box.size().norm() + radius;
  prior_.visitNear(middle, reach, [&](std::uint32_t i, double) {
    window.paintDisc(prior_.points()[i], radius, kNear, kPictureOutside);
  });
  for (const VoidPoint& point : points) {
    const int column = window.column(point.position.x());
    const int row = window.row(point.position.y());
    if (window.at(column, row) == kNear) window.flood(column, row, kPictureUncovered);
  }
  UncoveredArea area;
  area.before_mm2 = static_cast<double>(window.count(kPictureUncovered)) * window.pixelArea();
  added_.visitNear(middle, reach, [&](std::uint32_t i, double) {
    window.paintDisc(added_.points()[i], radius, kPictureUncovered, kFilled);
  });
  area.after_mm2 = static_cast<double>(window.count(kPictureUncovered)) * window.pixelArea();
  return area;
}

}  // namespace lamina
