// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/layer_travels.hpp"

#include <algorithm>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/travel/retraction.hpp"

namespace lamina {
namespace {

bool crosses(const Point2& a, const Point2& b, const Polygon& outline) {
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
    if (areCrossing(a, b, outline[j], outline[i])) return true;
  return false;
}

}  // namespace

void LayerTravels::addSeen(const Regions& top_skin) {
  seen_.insert(seen_.end(), top_skin.begin(), top_skin.end());
  if (settings_.comb == Combing::NoSkin && !top_skin.empty()) area_.reset();
}

void LayerTravels::setSeen(const Regions& top_skins) {
  if (top_skins.size() == seen_.size()) return;  // skins are only ever added
  seen_ = top_skins;
  if (settings_.comb == Combing::NoSkin) area_.reset();
}

std::optional<Path> LayerTravels::between(const Point3& from, const Point3& to, TravelOver over) {
  const Point2 start = from.head<2>();
  const Point2 end = to.head<2>();
  if (over == TravelOver::Infill && settings_.comb == Combing::NoSkin && crossesSeen({start, end}))
    over = TravelOver::Anything;
  if (settings_.comb != Combing::None && isRetracted((end - start).norm(), over, settings_))
    if (const std::optional<Polyline> way = combed(start, end)) return along(*way, from.z());
  if (settings_.hop != Hopping::OverSkin || crossesSeen({start, end}))
    return makeTravel(from, to, settings_, over);
  TravelSettings level = settings_;
  level.hop_mm = 0.0;
  return makeTravel(from, to, level, over);
}

const CombArea& LayerTravels::area() {
  if (area_) return *area_;
  const double off = 0.5 * bead_width_mm_ + settings_.keep_off_mm;
  Regions inside = offset(*material_, -off);
  if (settings_.comb == Combing::NoSkin && !seen_.empty()) inside = difference(inside, seen_);
  area_.emplace(inside);
  return *area_;
}

std::optional<Polyline> LayerTravels::combed(const Point2& from, const Point2& to) {
  if (material_ == nullptr) return std::nullopt;
  WayLimits limits;
  limits.longest_mm = settings_.comb_detour * (to - from).norm();
  limits.reach_mm = settings_.keep_off_mm + bead_width_mm_;
  return area().shortestWay(from, to, limits);
}

bool LayerTravels::crossesSeen(const Polyline& way) const {
  for (const Region& region : seen_) {
    if (encloses(region.outer, way.front())) return true;
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
      if (crosses(way[i], way[i + 1], region.outer)) return true;
  }
  return false;
}

Path LayerTravels::along(const Polyline& way, double z) const {
  Path path;
  path.role = PathRole::Travel;
  path.feed_mm_s = settings_.feed_mm_s;
  path.process.is_retracted = isRetractedInside(length(way), settings_);
  const bool hops = path.process.is_retracted && settings_.hop_mm > 0.0 &&
                    (settings_.hop != Hopping::OverSkin || crossesSeen(way));
  const auto at = [z](const Point2& point, double lift) { return Point3(point.x(), point.y(), z + lift); };
  if (hops) path.points.push_back(at(way.front(), 0.0));
  for (const Point2& point : way) path.points.push_back(at(point, hops ? settings_.hop_mm : 0.0));
  if (hops) path.points.push_back(at(way.back(), 0.0));
  return path;
}

}  // namespace lamina
