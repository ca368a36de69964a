// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/prime_tower.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

constexpr double kNarrowestTower = 5.0;  // mm
constexpr double kTowerStep = 0.25;      // mm
constexpr double kKeptSpacing = 5.0;     // pitches
constexpr double kLeastRest = 1e-3;      // mm: shorter runs are not deposited

/// The part of a polyline between two lengths along it.
std::vector<Point2> between(const std::vector<Point2>& points, double from_mm, double to_mm) {
  std::vector<Point2> part;
  double at_mm = 0.0;
  for (std::size_t i = 1; i < points.size() && at_mm < to_mm; ++i) {
    const double length_mm = (points[i] - points[i - 1]).norm();
    const auto placed = [&](double mm) {
      const double share = length_mm > 0.0 ? (mm - at_mm) / length_mm : 0.0;
      return Point2(points[i - 1] + std::clamp(share, 0.0, 1.0) * (points[i] - points[i - 1]));
    };
    if (at_mm + length_mm > from_mm) {
      if (part.empty()) part.push_back(placed(from_mm));
      part.push_back(placed(to_mm));
    }
    at_mm += length_mm;
  }
  return part;
}

}  // namespace

/// What beads of a layer fill in a tower.
struct PrimeTower::Measures {
  double section_mm2 = 0.0;  ///< of a bead
  double pitch_mm = 0.0;
  double wall_mm = 0.0;   ///< half the side of the outer wall's centre line
  double lines_mm = 0.0;  ///< half the side of the square of lines

  /// Lengths of both walls, which end where they began, and the step between them.
  double wallLength() const { return 16.0 * wall_mm - 8.0 * pitch_mm + M_SQRT2 * pitch_mm; }
  std::size_t lineCount() const {
    return lines_mm > 0.0 ? static_cast<std::size_t>(2.0 * lines_mm / pitch_mm) + 1 : 0;
  }
  double capacity() const {
    const auto count = static_cast<double>(lineCount());
    const double lines = count > 0.0 ? count * 2.0 * lines_mm + (count - 1.0) * pitch_mm : 0.0;
    return section_mm2 * (wallLength() + lines);
  }
};

PrimeTower::Measures PrimeTower::measuresAt(std::size_t layer, double side_mm) const {
  const Bead bead{settings_.bead.width_mm, layers_[layer].height_mm};
  Measures measures;
  measures.section_mm2 = crossSection(bead);
  measures.pitch_mm = planWidth(bead);
  measures.wall_mm = 0.5 * (side_mm - bead.width_mm);
  measures.lines_mm = measures.wall_mm - 2.0 * measures.pitch_mm;
  return measures;
}

PrimeTower::PrimeTower(std::vector<TowerLayer> layers, const PlanSettings& settings, const Box2& part)
    : layers_(std::move(layers)), settings_(settings) {
  for (std::size_t l = 0; l < layers_.size(); ++l)
    if (!layers_[l].purges.empty()) height_ = l + 1;
  fit();
  place(part);
}

void PrimeTower::fit() {
  side_mm_ = settings_.tools.tower_mm > 0.0 ? settings_.tools.tower_mm
                                            : std::max(kNarrowestTower, 8.0 * settings_.bead.width_mm);
  const double asked_mm = side_mm_;
  double needed_mm3 = 0.0;
  for (std::size_t l = 0; l < height_; ++l) {
    double volume_mm3 = 0.0;
    for (const Purge& purge : layers_[l].purges) volume_mm3 += purge.volume_mm3;
    if (volume_mm3 <= measuresAt(l, side_mm_).capacity()) continue;
    while (measuresAt(l, side_mm_).capacity() < volume_mm3) side_mm_ += kTowerStep;
    needed_mm3 = volume_mm3;
  }
  if (settings_.tools.tower_mm > 0.0 && side_mm_ > asked_mm)
    throw InvalidConfig("tools.tower_mm is " + numberText(asked_mm) + " mm; " + numberText(needed_mm3) +
                        " mm3 of tools.purge_mm3 in one layer need " + numberText(side_mm_) + " mm");
}

void PrimeTower::place(const Box2& part) {
  const double half = 0.5 * side_mm_;
  const std::vector<double>& at = settings_.tools.tower_at_mm;
  middle_ = at.empty() ? Point2(part.high.x() + kTowerBesidePart + half, 0.5 * (part.low.y() + part.high.y()))
                       : Point2(at[0], at[1]);
  const bool is_beside = middle_.x() - half > part.high.x() || middle_.x() + half < part.low.x() ||
                         middle_.y() - half > part.high.y() || middle_.y() + half < part.low.y();
  if (!is_beside)
    throw InvalidConfig("tools.tower_at_mm is " + numberText(at[0]) + "," + numberText(at[1]) +
                        "; a tower of " + numberText(side_mm_) +
                        " mm would stand within the box of what is deposited");
}

std::vector<Point2> PrimeTower::walls(std::size_t layer) const {
  const Measures measures = measuresAt(layer, side_mm_);
  std::vector<Point2> points;
  for (const double r : {measures.wall_mm, measures.wall_mm - measures.pitch_mm})
    for (const Point2& corner : {Point2(-r, -r), Point2(r, -r), Point2(r, r), Point2(-r, r), Point2(-r, -r)})
      points.push_back(middle_ + corner);
  return points;
}

std::vector<Point2> PrimeTower::lines(std::size_t layer, double spacing) const {
  const Measures measures = measuresAt(layer, side_mm_);
  const double step = spacing * measures.pitch_mm;
  const double r = measures.lines_mm;
  std::vector<Point2> points;
  bool is_back = false;
  for (std::size_t i = 0; i < measures.lineCount(); ++i) {
    const double across = -r + static_cast<double>(i) * step;
    if (across > r + 1e-9) break;
    Point2 ends[] = {{-r, across}, {r, across}};
    if (std::exchange(is_back, !is_back)) std::swap(ends[0], ends[1]);
    for (const Point2& end : ends)
      points.push_back(middle_ + (layer % 2 == 0 ? end : Point2(end.y(), end.x())));
  }
  return points;
}

Path PrimeTower::path(const std::vector<Point2>& points, std::size_t layer, std::uint32_t tool,
                      double z_mm) const {
  Path path;
  path.role = PathRole::Prime;
  path.tool = tool;
  path.bead = Bead{settings_.bead.width_mm, layers_[layer].height_mm};
  const FeedSettings& feed = settings_.feed;
  path.feed_mm_s = layer == 0 ? std::min(feed.infill_mm_s, feed.first_layer_mm_s) : feed.infill_mm_s;
  for (const Point2& point : points) path.points.emplace_back(point.x(), point.y(), z_mm);
  return path;
}

std::vector<Path> PrimeTower::purge(std::size_t layer, std::size_t index, double z_mm) const {
  const Measures measures = measuresAt(layer, side_mm_);
  const std::vector<Purge>& purges = layers_[layer].purges;
  double from_mm = -measures.wallLength();
  for (std::size_t i = 0; i < index; ++i)
    from_mm = std::max(0.0, from_mm + purges[i].volume_mm3 / measures.section_mm2);
  const double to_mm = from_mm + purges[index].volume_mm3 / measures.section_mm2;
  std::vector<Path> paths;
  if (index == 0) paths.push_back(path(walls(layer), layer, purges[index].tool, z_mm));
  const std::vector<Point2> part = between(lines(layer, 1.0), std::max(0.0, from_mm), to_mm);
  if (length(part) > kLeastRest) paths.push_back(path(part, layer, purges[index].tool, z_mm));
  return paths;
}

std::vector<Path> PrimeTower::keep(std::size_t layer, std::uint32_t tool, double z_mm) const {
  std::vector<Path> paths = {path(walls(layer), layer, tool, z_mm)};
  const std::vector<Point2> few = lines(layer, kKeptSpacing);
  if (length(few) > kLeastRest) paths.push_back(path(few, layer, tool, z_mm));
  return paths;
}

}  // namespace lamina
