// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/rising_wall.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "geometry/spatial/box_tree.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "planning/travel/travel.hpp"
#include "planning/walls/opened_loop.hpp"

namespace lamina {
namespace {

/// Motions of a turn whose height changes are no longer than this part of it.
constexpr int kRampSteps = 64;
/// Points nearer to the loop below than this are drawn on it, those from twice that on are not [widths].
constexpr double kNear = 1.0;

Polygon seenFromAbove(const Path& path) {
  Polygon points;
  points.reserve(path.points.size());
  for (const Point3& point : path.points) points.emplace_back(point.head<2>());
  return points;
}

/// A point of a turn, and which motion of its loop leads to it.
struct TurnPoint {
  Point2 point;
  double part = 0.0;  ///< of the turn
  std::size_t waypoint = 0;
};

/// The turn that an open loop makes, its motions no longer than a part of the whole.
std::vector<TurnPoint> turnOf(const Path& loop) {
  const double whole = length(loop);
  std::vector<TurnPoint> turn = {{loop.points.front().head<2>(), 0.0, 1}};
  double gone = 0.0;
  for (std::size_t i = 1; i < loop.points.size(); ++i) {
    const Point2 from = loop.points[i - 1].head<2>();
    const Point2 along = loop.points[i].head<2>() - from;
    const int count = std::max(1, static_cast<int>(std::ceil(kRampSteps * along.norm() / whole)));
    for (int k = 1; k <= count; ++k) {
      const double t = static_cast<double>(k) / count;
      turn.push_back({from + t * along, (gone + t * along.norm()) / whole, i});
    }
    gone += along.norm();
  }
  return turn;
}

/// A loop that another one is deposited on.
class LoopBelow {
 public:
  explicit LoopBelow(Polygon points) : points_(std::move(points)), edges_(boxesOf(points_)) {}

  /// The nearest place no farther than `reach`.
  std::optional<Point2> nearest(const Point2& point, double reach) const {
    std::optional<Point2> best;
    double least = reach * reach;
    Box3 box;
    box.include({point.x() - reach, point.y() - reach, 0.0});
    box.include({point.x() + reach, point.y() + reach, 0.0});
    edges_.visitOverlapping(box, [&](std::uint32_t edge) {
      const Point2& from = points_[edge];
      const Point2 along = points_[edge + 1 < points_.size() ? edge + 1 : 0] - from;
      const double part = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const Point2 place = from + part * along;
      if ((place - point).squaredNorm() > least) return;
      least = (place - point).squaredNorm();
      best = place;
    });
    return best;
  }

 private:
  static std::vector<Box3> boxesOf(const Polygon& points) {
    std::vector<Box3> boxes(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const Point2& end : {points[i], points[i + 1 < points.size() ? i + 1 : 0]})
        boxes[i].include({end.x(), end.y(), 0.0});
    return boxes;
  }

  Polygon points_;
  BoxTree edges_;
};

/// What a turn is deposited on, and how it rises.
struct TurnHeights {
  double from_mm = 0.0;  ///< of the nozzle
  double to_mm = 0.0;
  double bead_from_mm = 0.0;
  double bead_to_mm = 0.0;
};

class WallRaiser {
 public:
  WallRaiser(std::vector<ToolpathLayer>& layers, std::size_t first, const TravelSettings& travel)
      : layers_(layers), first_(first), travel_(travel) {
    for (std::size_t i = 0; i < std::min(first, layers.size()); ++i)
      if (!layers[i].paths.empty()) nozzle_ = layers[i].paths.back().lastPoint();
  }

  void raise() {
    std::optional<std::size_t> last;
    for (std::size_t i = first_; i < layers_.size(); ++i) {
      if (!holdsLoop(i)) continue;
      const std::size_t expected = last ? *last + 1 : first_;
      if (i != expected) refuse(expected, "no room for a bead");
      raise(i);
      last = i;
    }
    if (!last)
      throw InvalidInput("no layer of " + std::to_string(layers_.size()) +
                         " has room for a rising wall above " + std::to_string(first_) + " base layers");
    closeTop(layers_[*last]);
  }

 private:
  [[noreturn]] void refuse(std::size_t layer, const std::string& reason) const {
    throw InvalidInput(layerPlace(layer, layers_[layer].z_mm) + " has " + reason +
                       "; infill.strategy 'vase' lays one wall, and needs one region without holes in each "
                       "layer above vase.base_layers");
  }

  static bool isLoop(const Path& path) { return path.is_closed && path.role == PathRole::OuterWall; }

  bool holdsLoop(std::size_t index) const {
    const ToolpathLayer& layer = layers_[index];
    int regions = 0;
    int holes = 0;
    for (const Path& path : layer.paths)
      if (isLoop(path)) ++(signedArea(seenFromAbove(path)) > 0.0 ? regions : holes);
    if (regions > 1) refuse(index, std::to_string(regions) + " regions with room for a bead");
    if (holes > 0) refuse(index, std::to_string(holes) + (holes > 1 ? " holes" : " hole"));
    return regions > 0;
  }

  /// Leaves skirts and the wall of the layer.
  void raise(std::size_t index) {
    ToolpathLayer& layer = layers_[index];
    std::vector<Path> paths;
    Path loop;
    for (Path& path : layer.paths) {
      if (isLoop(path))
        loop = std::move(path);
      else if (kindOf(path.role) == RoleKind::BuildAid)
        add(std::move(path), paths);
    }
    const Point2 start = nozzle_ ? Point2(nozzle_->head<2>()) : Point2(loop.firstPoint().head<2>());
    Path own = opened(
        loop, {nearestPlace(loop, {start.x(), start.y(), loop.firstPoint().z()}), LoopSense::AsGiven, 0.0});
    std::vector<TurnPoint> turn = turnOf(own);
    if (below_) {
      drawDown(turn, *below_, own.bead.at(1).width_mm);
      turn.front().point = start;
    }
    const double height = layer.height_mm;
    Path raised = own;
    raised.points.clear();
    lay(turn, own, {layer.z_mm - height, layer.z_mm, below_ ? bead_height_ : 0.0, height}, raised);
    add(std::move(raised), paths);
    layer.paths = std::move(paths);
    below_.emplace(seenFromAbove(loop));
    last_ = std::move(own);
    bead_height_ = height;
  }

  void add(Path&& path, std::vector<Path>& paths) {
    if (!paths.empty())
      if (std::optional<Path> travel = makeTravel(*nozzle_, path.firstPoint(), travel_))
        paths.push_back(std::move(*travel));
    nozzle_ = path.lastPoint();
    paths.push_back(std::move(path));
  }

  static void drawDown(std::vector<TurnPoint>& turn, const LoopBelow& below, double width) {
    for (TurnPoint& at : turn) {
      const std::optional<Point2> place = below.nearest(at.point, 2.0 * kNear * width);
      if (!place) continue;
      const double share = std::min(1.0, 2.0 - (*place - at.point).norm() / (kNear * width));
      at.point += (1.0 - at.part) * share * (*place - at.point);
    }
  }

  /// Adds a turn to a path; what the turn starts from is its first waypoint if it has none.
  static void lay(const std::vector<TurnPoint>& turn, const Path& loop, const TurnHeights& heights,
                  Path& path) {
    const bool is_new = path.points.empty();
    std::vector<Bead> beads = is_new ? std::vector<Bead>() : path.bead.values();
    for (std::size_t i = is_new ? 0 : 1; i < turn.size(); ++i) {
      const double z = heights.from_mm + turn[i].part * (heights.to_mm - heights.from_mm);
      path.points.emplace_back(turn[i].point.x(), turn[i].point.y(), z);
      const std::size_t motion = std::max<std::size_t>(i, 1);
      const double middle = 0.5 * (turn[motion - 1].part + turn[motion].part);
      const double height = heights.bead_from_mm + middle * (heights.bead_to_mm - heights.bead_from_mm);
      const Bead& whole = loop.bead.at(turn[motion].waypoint);
      beads.push_back(beadOfArea(planWidth(whole) * height, height));
    }
    path.bead = AlongPath<Bead>(std::move(beads));
  }

  void closeTop(ToolpathLayer& layer) {
    const double top = layer.z_mm;
    lay(turnOf(last_), last_, {top, top, layer.height_mm, 0.0}, layer.paths.back());
  }

  std::vector<ToolpathLayer>& layers_;
  std::size_t first_;
  const TravelSettings& travel_;
  std::optional<Point3> nozzle_;
  std::optional<LoopBelow> below_;  ///< of the layer below
  Path last_;                       ///< the same, open where the turn on it ended
  double bead_height_ = 0.0;        ///< of the layer below
};

}  // namespace

void raiseWall(std::vector<ToolpathLayer>& layers, std::size_t first, const TravelSettings& travel) {
  WallRaiser(layers, first, travel).raise();
}

}  // namespace lamina
