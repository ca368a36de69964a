// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/modifiers/island_pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "lamina/geometry/polygon/offset.hpp"
#include "planning/modifiers/run_clipping.hpp"
#include "planning/role_feed.hpp"

namespace lamina {
namespace {

constexpr double kLeastPiece = 1e-3;  // mm²

/// A waypoint of a wall that is divided finer.
struct FinerPoint {
  Point3 point = Point3::Zero();
  std::size_t like = 0;  ///< waypoint that has its bead and values
  double factor = 1.0;   ///< on the feed
};

/// Feeds of a role in the pieces of an island, against those of the plan.
class PieceFeeds {
 public:
  PieceFeeds(const std::vector<IslandPiece>& pieces, PathRole role, const WallFeeds& plan) {
    const double usual = feedIn(*plan.feed, role, plan.layer);
    for (const IslandPiece& piece : pieces) {
      borders_.push_back(outlines(piece.area));
      factors_.push_back(feedIn(piece.plan->context->settings.feed, role, plan.layer) / usual);
      all_.insert(all_.end(), borders_.back().begin(), borders_.back().end());
    }
  }

  bool areAsPlanned() const {
    return std::all_of(factors_.begin(), factors_.end(), [](double factor) { return factor == 1.0; });
  }
  const std::vector<Polygon>& borders() const { return all_; }
  /// Outside of all pieces it is that of the last one.
  double at(const Point2& point) const {
    for (std::size_t i = 0; i + 1 < factors_.size(); ++i)
      if (contains(borders_[i], point)) return factors_[i];
    return factors_.back();
  }

 private:
  std::vector<std::vector<Polygon>> borders_;
  std::vector<double> factors_;
  std::vector<Polygon> all_;
};

std::vector<FinerPoint> dividedBy(const PieceFeeds& feeds, const Path& wall) {
  std::vector<FinerPoint> finer;
  if (!wall.is_closed) finer.push_back({wall.points[0], 0, 1.0});
  for (std::size_t m = 0; m < wall.motionCount(); ++m) {
    const std::size_t end = wall.motionEnd(m);
    const Point3& from = wall.points[m];
    const Point3& to = wall.points[end];
    std::vector<double> shares = crossings(from.head<2>(), to.head<2>(), feeds.borders());
    shares.push_back(1.0);
    double share = 0.0;
    for (const double next : shares) {
      if (next - share < 1e-9) continue;
      const Point3 middle = from + 0.5 * (share + next) * (to - from);
      finer.push_back({next < 1.0 ? Point3(from + next * (to - from)) : to, end, feeds.at(middle.head<2>())});
      share = next;
    }
  }
  // The return of a closed wall is what leads to its first waypoint.
  if (wall.is_closed) std::rotate(finer.begin(), finer.end() - 1, finer.end());
  return finer;
}

template <class Value>
AlongPath<Value> likeBefore(const AlongPath<Value>& along, const std::vector<FinerPoint>& points) {
  if (along.isCommon()) return along;
  std::vector<Value> each;
  each.reserve(points.size());
  for (const FinerPoint& point : points) each.push_back(along.at(point.like));
  return AlongPath<Value>(std::move(each));
}

}  // namespace

std::vector<IslandPiece> piecesOf(const Region& island, const LayerVariant& plan,
                                  const std::vector<LayerVariant>& variants) {
  std::vector<IslandPiece> pieces;
  Regions rest = {island};
  for (const LayerVariant& variant : variants) {
    if (variant.area->empty()) continue;
    Regions common = intersection(rest, *variant.area);
    if (area(common) < kLeastPiece) continue;
    rest = difference(rest, *variant.area);
    pieces.push_back({&variant, std::move(common)});
  }
  if (pieces.empty() || area(rest) >= kLeastPiece) pieces.push_back({&plan, std::move(rest)});
  if (pieces.size() == 1) pieces.front().area = {island};
  return pieces;
}

int leastWalls(const std::vector<IslandPiece>& pieces) {
  int least = pieces.front().plan->context->settings.walls.count;
  for (const IslandPiece& piece : pieces) least = std::min(least, piece.plan->context->settings.walls.count);
  return least;
}

Path withFeedsOf(Path wall, const std::vector<IslandPiece>& pieces, const WallFeeds& laid_by) {
  const PieceFeeds feeds(pieces, wall.role, laid_by);
  if (feeds.areAsPlanned()) return wall;
  const std::vector<FinerPoint> finer = dividedBy(feeds, wall);
  std::vector<double> feed_mm_s;
  feed_mm_s.reserve(finer.size());
  for (const FinerPoint& point : finer) feed_mm_s.push_back(wall.feed_mm_s.at(point.like) * point.factor);
  wall.feed_mm_s = AlongPath<double>(std::move(feed_mm_s));
  wall.bead = likeBefore(wall.bead, finer);
  for (ProcessValue& each : wall.values) each.value = likeBefore(each.value, finer);
  wall.points.clear();
  for (const FinerPoint& point : finer) wall.points.push_back(point.point);
  return wall;
}

}  // namespace lamina
