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

/// A path with more waypoints on its way.
struct FinerPath {
  std::vector<Point3> points;
  std::vector<Bead> beads;
  std::vector<double> feeds;

  void add(const Point3& point, const Bead& bead, double feed_mm_s) {
    points.push_back(point);
    beads.push_back(bead);
    feeds.push_back(feed_mm_s);
  }
};

/// Feeds of a role in the pieces of an island.
class PieceFeeds {
 public:
  PieceFeeds(const std::vector<IslandPiece>& pieces, PathRole role, std::size_t layer) {
    for (const IslandPiece& piece : pieces) {
      borders_.push_back(outlines(piece.area));
      feeds_.push_back(feedIn(piece.context->settings.feed, role, layer));
      all_.insert(all_.end(), borders_.back().begin(), borders_.back().end());
    }
  }

  bool areEqual() const {
    return std::all_of(feeds_.begin(), feeds_.end(), [this](double feed) { return feed == feeds_.front(); });
  }
  const std::vector<Polygon>& borders() const { return all_; }
  /// Outside of all pieces it is that of the last one.
  double at(const Point2& point) const {
    for (std::size_t i = 0; i + 1 < feeds_.size(); ++i)
      if (contains(borders_[i], point)) return feeds_[i];
    return feeds_.back();
  }

 private:
  std::vector<std::vector<Polygon>> borders_;
  std::vector<double> feeds_;
  std::vector<Polygon> all_;
};

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
    pieces.push_back({variant.context, variant.cover, std::move(common)});
  }
  if (pieces.empty() || area(rest) >= kLeastPiece)
    pieces.push_back({plan.context, plan.cover, std::move(rest)});
  if (pieces.size() == 1) pieces.front().area = {island};
  return pieces;
}

int leastWalls(const std::vector<IslandPiece>& pieces) {
  int least = pieces.front().context->settings.walls.count;
  for (const IslandPiece& piece : pieces) least = std::min(least, piece.context->settings.walls.count);
  return least;
}

Path withFeedsOf(Path wall, const std::vector<IslandPiece>& pieces, std::size_t layer) {
  const PieceFeeds feeds(pieces, wall.role, layer);
  if (feeds.areEqual()) {
    wall.feed_mm_s = feeds.at(wall.firstPoint().head<2>());
    return wall;
  }
  FinerPath finer;
  const std::size_t motions = wall.motionCount();
  if (!wall.is_closed) finer.add(wall.points[0], wall.bead.at(0), wall.feed_mm_s.at(0));
  for (std::size_t m = 0; m < motions; ++m) {
    const std::size_t end = wall.motionEnd(m);
    const Point3& from = wall.points[m];
    const Point3& to = wall.points[end];
    std::vector<double> shares = crossings(from.head<2>(), to.head<2>(), feeds.borders());
    shares.push_back(1.0);
    double share = 0.0;
    for (const double next : shares) {
      if (next - share < 1e-9) continue;
      const Point3 middle = from + 0.5 * (share + next) * (to - from);
      finer.add(next < 1.0 ? Point3(from + next * (to - from)) : to, wall.bead.at(end),
                feeds.at(middle.head<2>()));
      share = next;
    }
  }
  // The return of a closed wall is what leads to its first waypoint.
  const auto to_front = [](auto& values) { std::rotate(values.begin(), values.end() - 1, values.end()); };
  if (wall.is_closed) {
    to_front(finer.points);
    to_front(finer.beads);
    to_front(finer.feeds);
  }
  if (!wall.bead.isCommon()) wall.bead = AlongPath<Bead>(std::move(finer.beads));
  wall.points = std::move(finer.points);
  wall.feed_mm_s = AlongPath<double>(std::move(finer.feeds));
  return wall;
}

}  // namespace lamina
