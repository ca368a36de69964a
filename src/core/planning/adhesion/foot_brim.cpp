// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/adhesion/foot_brim.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/adhesion/brim.hpp"
#include "planning/supports/layers_below.hpp"

namespace lamina {
namespace {

/// Where inclined layers meet the bed. Places on the bed are (across, along): along the foot of a layer, and
/// from the foot of one layer to that of the next.
class LayerFeet {
 public:
  LayerFeet(const std::vector<Layer>& layers, const BedPlane& bed, double width_mm)
      : bed_(bed),
        sine_(bed.up.head<2>().norm()),
        away_(bed.up.head<2>() / sine_),
        across_(away_.y(), -away_.x()),
        width_mm_(width_mm),
        first_mm_(layers.front().bounds.bottom_mm) {}

  double pitch(const LayerBounds& bounds) const { return planWidth({width_mm_, bounds.height()}); }

  /// Lines of beads that cover the bed from the foot of this layer to that of the next.
  int lineCount(const LayerBounds& bounds) const {
    return std::max(1, static_cast<int>(std::lround(bounds.height() / sine_ / pitch(bounds))));
  }

  /// How far from its foot the lines of a layer reach.
  double reach(const LayerBounds& bounds) const {
    return width_mm_ + (lineCount(bounds) - 1) * pitch(bounds);
  }

  double along(double height_mm) const { return (height_mm - first_mm_) / sine_; }

  /// The place in a layer, so far from its foot.
  Point2 placeIn(const LayerBounds& bounds, double across_mm, double from_foot_mm) const {
    return across_mm * across_ + (foot(bounds) + from_foot_mm) * away_;
  }

  /// What a section covers of the bed, between the feet of its layer's bottom and top.
  void appendCovered(const Layer& layer, std::vector<Polygon>& covered) const {
    const double foot_mm = foot(layer.bounds);
    std::vector<Polygon> turned;
    Box2 box;
    for (const Polygon& contour : layer.section.contours) {
      Polygon& polygon = turned.emplace_back();
      polygon.reserve(contour.size());
      for (const Point2& point : contour) {
        polygon.emplace_back(across_.dot(point), away_.dot(point) - foot_mm);
        box.include(polygon.back());
      }
    }
    const double reach_mm = reach(layer.bounds);
    if (box.isEmpty() || box.low.y() >= reach_mm) return;
    const Regions beside_bed = {{rectangle({box.low.x(), box.low.y()}, {box.high.x(), reach_mm}), {}}};
    for (const Region& region : intersection(unite(turned), beside_bed)) {
      const Box2 piece = boundingBox({region.outer});
      covered.push_back(rectangle({piece.low.x(), along(layer.bounds.bottom_mm)},
                                  {piece.high.x(), along(layer.bounds.top_mm)}));
    }
  }

  static Polygon rectangle(const Point2& low, const Point2& high) {
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  }

 private:
  /// Distance of the foot from the origin of the layer, away from the bed.
  double foot(const LayerBounds& bounds) const {
    return (bed_.level_mm - bed_.up.z() * bounds.cut()) / sine_;
  }

  const BedPlane& bed_;
  double sine_;    ///< of the layers' inclination
  Point2 away_;    ///< from the bed, in the plane of the layers
  Point2 across_;  ///< along the feet
  double width_mm_;
  double first_mm_;
};

/// Where a line at that place along the bed is within an area, from one side to the other.
std::vector<std::pair<double, double>> stretchesAt(const std::vector<Polygon>& borders, double along_mm) {
  std::vector<double> crossings;
  for (const Polygon& border : borders)
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++) {
      const Point2& a = border[j];
      const Point2& b = border[i];
      if ((a.y() > along_mm) == (b.y() > along_mm)) continue;
      crossings.push_back(a.x() + (along_mm - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::pair<double, double>> stretches;
  stretches.reserve(crossings.size() / 2);
  for (std::size_t i = 1; i < crossings.size(); i += 2)
    stretches.emplace_back(crossings[i - 1], crossings[i]);
  return stretches;
}

FootBrim brimAt(const LayerBounds& bounds, const LayerFeet& feet, const std::vector<Polygon>& borders,
                double width_mm) {
  FootBrim brim;
  const double pitch_mm = feet.pitch(bounds);
  for (const auto& [low, high] : stretchesAt(borders, feet.along(bounds.cut()))) {
    // As far from part and edge as loops of a level brim.
    const double from = low + 0.5 * pitch_mm;
    const double to = high - 0.5 * pitch_mm;
    if (to - from < width_mm) continue;
    for (int k = 0; k < feet.lineCount(bounds); ++k) {
      const double from_foot_mm = 0.5 * width_mm + k * pitch_mm;
      const Polyline line = {feet.placeIn(bounds, from, from_foot_mm),
                             feet.placeIn(bounds, to, from_foot_mm)};
      brim.runs.push_back({line, false, PathRole::Brim, Deposit::Bead, {}});
    }
    const double reach_mm = feet.reach(bounds);
    brim.area.push_back({{feet.placeIn(bounds, low, 0.0), feet.placeIn(bounds, high, 0.0),
                          feet.placeIn(bounds, high, reach_mm), feet.placeIn(bounds, low, reach_mm)},
                         {}});
  }
  brim.area = unite(outlines(brim.area));
  return brim;
}

}  // namespace

std::size_t countBrimLayersBelow(const std::vector<Layer>& layers, const BedPlane& bed,
                                 const BrimSettings& settings) {
  if (settings.width_mm == 0.0 || layers.empty()) return 0;
  const double width_mm = settings.width_mm + settings.gap_mm;
  const double step_mm = heightAmid(layers) / bed.up.head<2>().norm();
  return static_cast<std::size_t>(std::ceil(width_mm / step_mm)) + 1;
}

std::vector<FootBrim> footBrim(const std::vector<Layer>& layers, const BedPlane& bed,
                               const BrimSettings& settings, double width_mm) {
  std::vector<FootBrim> brims(layers.size());
  if (layers.empty()) return brims;
  const LayerFeet feet(layers, bed, width_mm);
  std::vector<Polygon> covered;
  for (const Layer& layer : layers) feet.appendCovered(layer, covered);
  const double pitch_mm = planWidth({width_mm, heightAmid(layers)});
  const std::vector<Polygon> borders =
      outlines(makeBrim(unite(covered), settings, pitch_mm, std::nullopt).area);
  for (std::size_t i = 0; i < layers.size(); ++i)
    brims[i] = brimAt(layers[i].bounds, feet, borders, width_mm);
  return brims;
}

}  // namespace lamina
