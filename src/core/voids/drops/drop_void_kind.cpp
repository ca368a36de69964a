// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/drops/drop_void_kind.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr std::size_t kNoContour = std::numeric_limits<std::size_t>::max();
constexpr double kCriticalCorner = 60.0 * M_PI / 180.0;
constexpr double kBounding = 0.02;  // diameters: drops as far as the nearest bound a void

double cornerAngle(const Polygon& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const Point2 back = outline[(i + n - 1) % n] - outline[i];
  const Point2 on = outline[(i + 1) % n] - outline[i];
  return std::abs(turn(back, on));
}

}  // namespace

VoidKinds::VoidKinds(const DropLayer& layer, const std::vector<DropContour>& contours)
    : layer_(layer),
      contours_(contours),
      drops_(boundingBox({layer.drops}), layer.diameter_mm),
      corners_(boundingBox({layer.drops}), layer.diameter_mm),
      role_of_drop_(layer.drops.size(), DropRole::Infill),
      contour_of_drop_(layer.drops.size(), kNoContour) {
  for (const Point2& drop : layer.drops) drops_.insert(drop);
  for (const DropChain& chain : layer.chains)
    for (std::size_t i = chain.begin; i < chain.end; ++i) role_of_drop_[i] = chain.role;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const DropChain& chain = layer.chains[contours[c].chain];
    for (std::size_t i = chain.begin; i < chain.end; ++i) contour_of_drop_[i] = c;
    for (std::size_t i = 0; i < contours[c].outline.size(); ++i)
      if (cornerAngle(contours[c].outline, i) < kCriticalCorner) corners_.insert(contours[c].outline[i]);
  }
}

bool VoidKinds::isInCorner(const std::vector<VoidPoint>& points) const {
  return std::any_of(points.begin(), points.end(), [this](const VoidPoint& point) {
    return corners_.hasNearer(point.position, 2.0 * layer_.diameter_mm);
  });
}

VoidClass VoidKinds::kindOf(const std::vector<VoidPoint>& points) const {
  bool has_infill = false;
  std::vector<std::size_t> contours;
  for (const VoidPoint& point : points)
    drops_.visitNear(point.position, point.clearance_mm + kBounding * layer_.diameter_mm,
                     [&](std::uint32_t i, double) {
                       has_infill |= role_of_drop_[i] == DropRole::Infill;
                       if (contour_of_drop_[i] != kNoContour) contours.push_back(contour_of_drop_[i]);
                     });
  std::sort(contours.begin(), contours.end());
  contours.erase(std::unique(contours.begin(), contours.end()), contours.end());
  if (contours.empty()) return VoidClass::Between;
  if (has_infill) return layer_.is_dense ? VoidClass::DenseBorder : VoidClass::RasterBorder;
  return kindOfContours(contours, points);
}

VoidClass VoidKinds::kindOfContours(const std::vector<std::size_t>& contours,
                                    const std::vector<VoidPoint>& points) const {
  if (contours.size() == 1 && contours_[contours.front()].is_innermost) return VoidClass::Core;
  const auto is_hole = [this](std::size_t c) { return contours_[c].is_hole; };
  const auto holes = std::count_if(contours.begin(), contours.end(), is_hole);
  if (holes > 0 && static_cast<std::size_t>(holes) < contours.size()) return VoidClass::Meeting;
  return isInCorner(points) ? VoidClass::Corner : VoidClass::ShapeChange;
}

}  // namespace lamina
