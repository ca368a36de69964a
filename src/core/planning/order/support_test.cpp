// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/support_test.hpp"

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
  edges_ = EdgeBands(offset(material, kOverhang * bead.width_mm));
}

bool SupportTest::carries(const Point2& point) const { return touchesBed(point) || isOverMaterial(point); }

bool SupportTest::touchesBed(const Point2& point) const { return gapToBed(point) <= kTouching; }

double SupportTest::gapToBed(const Point2& point) const {
  return bed_.heightOf({point.x(), point.y(), top_mm_}) - reach_mm_;
}

bool SupportTest::isOverMaterial(const Point2& anywhere) const { return edges_.enclose(anywhere - origin_); }

}  // namespace lamina
