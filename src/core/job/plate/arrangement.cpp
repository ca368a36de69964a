// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/arrangement.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "job/plate/packing.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

Box2 boxAt(const Footprint& footprint, const Point2& at) {
  Box2 box = boundingBox({footprint.hull});
  box.low += at;
  box.high += at;
  return box;
}

bool areApart(const Box2& a, const Box2& b, double by_mm) {
  return (a.low.array() >= b.high.array() + by_mm).any() || (b.low.array() >= a.high.array() + by_mm).any();
}

/// Fills rows from the left, past what already stands.
class Rows {
 public:
  Rows(const Box2& bed, double spacing_mm) : bed_(bed), spacing_mm_(spacing_mm), next_(bed.low) {}

  void addObstacle(const Box2& box) { obstacles_.push_back(box); }

  /// @return lower left corner; none if there is no room
  std::optional<Point2> placed(const Point2& size) {
    while (next_.y() + size.y() <= bed_.high.y()) {
      while (next_.x() + size.x() <= bed_.high.x()) {
        const Box2 box{next_, next_ + size};
        const Box2* const hindrance = hindranceOf(box);
        if (hindrance == nullptr) {
          depth_mm_ = std::max(depth_mm_, size.y());
          next_.x() = box.high.x() + spacing_mm_;
          return box.low;
        }
        next_.x() = hindrance->high.x() + spacing_mm_;
      }
      if (!beginRow()) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  const Box2* hindranceOf(const Box2& box) const {
    for (const Box2& obstacle : obstacles_)
      if (!areApart(box, obstacle, spacing_mm_)) return &obstacle;
    return nullptr;
  }

  /// An empty row begins again where the next obstacle ends.
  bool beginRow() {
    double step_mm = depth_mm_ + spacing_mm_;
    if (depth_mm_ == 0.0) {
      step_mm = std::numeric_limits<double>::infinity();
      for (const Box2& obstacle : obstacles_)
        if (obstacle.high.y() + spacing_mm_ > next_.y())
          step_mm = std::min(step_mm, obstacle.high.y() + spacing_mm_ - next_.y());
    }
    next_ = {bed_.low.x(), next_.y() + step_mm};
    depth_mm_ = 0.0;
    return std::isfinite(step_mm);
  }

  Box2 bed_;
  double spacing_mm_;
  Point2 next_;
  double depth_mm_ = 0.0;
  std::vector<Box2> obstacles_;
};

[[noreturn]] void refuseForRoom(const Footprint& footprint, const Box2& bed, double spacing_mm) {
  const Point2 size = boxAt(footprint, Point2::Zero()).size();
  char text[256];
  std::snprintf(
      text, sizeof text,
      "part '%s' of %.4g x %.4g mm finds no room: parts and skirt may cover %.4g x %.4g mm of the bed, "
      "%.4g mm apart (plate.spacing_mm)",
      footprint.name.c_str(), size.x(), size.y(), bed.size().x(), bed.size().y(), spacing_mm);
  throw Unreachable(text);
}

std::vector<PlatePlace> inRows(const std::vector<Footprint>& footprints, const Box2& bed, double spacing_mm) {
  Rows rows(bed, spacing_mm);
  for (const Footprint& footprint : footprints)
    if (footprint.at_mm) rows.addObstacle(boxAt(footprint, *footprint.at_mm));
  std::vector<PlatePlace> places;
  for (const Footprint& footprint : footprints) {
    places.push_back({footprint.at_mm.value_or(Point2::Zero()), 0});
    if (footprint.at_mm) continue;
    const Box2 box = boxAt(footprint, Point2::Zero());
    const std::optional<Point2> corner = rows.placed(box.size());
    if (!corner) refuseForRoom(footprint, bed, spacing_mm);
    places.back().at_mm = *corner - box.low;
  }
  return places;
}

std::vector<PlatePlace> packed(const std::vector<Footprint>& footprints, const Box2& bed, double spacing_mm) {
  Packing packing(bed, spacing_mm);
  std::vector<PlatePlace> places(footprints.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (!footprints[i].at_mm) {
      order.push_back(i);
      continue;
    }
    places[i].at_mm = *footprints[i].at_mm;
    packing.addFixed(footprints[i].hull, places[i].at_mm);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return signedArea(footprints[a].hull) > signedArea(footprints[b].hull);
  });
  for (const std::size_t i : order) {
    const std::optional<PlatePlace> place = packing.placed(footprints[i].hull);
    if (!place) refuseForRoom(footprints[i], bed, spacing_mm);
    places[i] = *place;
  }
  return places;
}

/// Of the hull as it is turned.
Box2 turnedBox(const Footprint& footprint, const PlatePlace& place) {
  Box2 box;
  const Eigen::Rotation2D<double> turn(place.eighths * M_PI / 4.0);
  for (const Point2& corner : footprint.hull) box.include(turn * corner);
  const Point2 half = 0.5 * box.size();
  return {place.at_mm - half, place.at_mm + half};
}

}  // namespace

std::vector<PlatePlace> arranged(const std::vector<Footprint>& footprints, const Box2& bed,
                                 const PlateSettings& settings) {
  std::vector<PlatePlace> places = settings.arrangement == PlateArrangement::Pack
                                       ? packed(footprints, bed, settings.spacing_mm)
                                       : inRows(footprints, bed, settings.spacing_mm);
  if (std::any_of(footprints.begin(), footprints.end(),
                  [](const Footprint& f) { return f.at_mm.has_value(); }))
    return places;
  Box2 all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Box2 box = turnedBox(footprints[i], places[i]);
    all.include(box.low);
    all.include(box.high);
  }
  const Point2 shift = bed.centre() - all.centre();
  for (PlatePlace& place : places) place.at_mm += shift;
  return places;
}

}  // namespace lamina
