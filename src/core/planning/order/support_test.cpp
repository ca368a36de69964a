// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/support_test.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/geometry/polygon/offset.hpp"
#include "planning/order/near_origin.hpp"

namespace lamina {
namespace {

constexpr double kOverhang = 0.25;  // of the bead width
constexpr double kTouching = 1e-6;  // mm: rounding of rotations

Layer carryingLayer(const BelowLayer& below) {
  Layer carrying = below.layer != nullptr ? *below.layer : Layer{};
  if (below.supports != nullptr)
    for (Polygon& outline : outlines(*below.supports))
      carrying.section.contours.push_back(std::move(outline));
  return carrying;
}

}  // namespace

SupportTest::SupportTest(const Layer& layer, const BelowLayer& below, const BedPlane& bed, const Bead& bead)
    : bed_(bed),
      top_mm_(layer.bounds.top_mm),
      reach_mm_(bed.up.z() * layer.bounds.height() + 0.5 * bead.width_mm * bed.up.head<2>().norm()) {
  const Layer carrying = carryingLayer(below);
  if (carrying.section.contours.empty()) return;
  origin_ = distanceFromOrigin(carrying);
  const Regions material = unite(moved(carrying, -origin_).section.contours);
  const std::vector<Polygon> borders = outlines(offset(material, kOverhang * bead.width_mm));
  const Box2 box = boundingBox(borders);
  if (box.isEmpty()) return;
  std::size_t edges = 0;
  for (const Polygon& border : borders) edges += border.size();
  rows_.resize(1 + edges / 4);
  low_y_ = box.low.y();
  row_mm_ = std::max(box.size().y(), 1e-3) / static_cast<double>(rows_.size());
  for (const Polygon& border : borders)
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++) {
      const auto [low, high] = std::minmax(border[j].y(), border[i].y());
      for (std::size_t row = rowOf(low); row <= rowOf(high); ++row)
        rows_[row].emplace_back(border[j], border[i]);
    }
}

std::size_t SupportTest::rowOf(double y) const {
  const double row = std::floor((y - low_y_) / row_mm_);
  return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
}

bool SupportTest::carries(const Point2& point) const { return touchesBed(point) || isOverMaterial(point); }

bool SupportTest::touchesBed(const Point2& point) const { return gapToBed(point) <= kTouching; }

double SupportTest::gapToBed(const Point2& point) const {
  return bed_.heightOf({point.x(), point.y(), top_mm_}) - reach_mm_;
}

bool SupportTest::isOverMaterial(const Point2& anywhere) const {
  if (rows_.empty()) return false;
  const Point2 point = anywhere - origin_;
  bool is_inside = false;
  for (const auto& [a, b] : rows_[rowOf(point.y())]) {
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < x) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace lamina
