// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/modifiers/island_pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "lamina/geometry/polygon/offset.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/modifiers/run_clipping.hpp"
#include "planning/role_feed.hpp"

namespace lamina {
namespace {

constexpr double kLeastPiece = 1e-3;  // mm²

/// A waypoint of a wall that is divided finer, and the motion that leads to it.
struct FinerPoint {
  Point3 point = Point3::Zero();
  std::size_t like = 0;   ///< waypoint that has its bead and values
  std::size_t piece = 0;  ///< in which the motion lies
};

/// How walls of a role are deposited in the pieces of an island, against how the plan lays them.
class PieceRules {
 public:
  PieceRules(const std::vector<IslandPiece>& pieces, PathRole role, const WallRules& plan) {
    const double usual_mm_s = feedIn(plan.plan->feed, role, plan.layer);
    for (const IslandPiece& piece : pieces) {
      const PlanSettings& settings = piece.plan->context->settings;
      borders_.push_back(outlines(piece.area));
      feeds_.push_back(feedIn(settings.feed, role, plan.layer) / usual_mm_s);
      flows_.push_back(settings.bead.flow / plan.plan->bead.flow);
      tools_.push_back(static_cast<std::uint32_t>(toolFor(role, settings.tools)));
      all_.insert(all_.end(), borders_.back().begin(), borders_.back().end());
    }
    const auto is_one = [](double factor) { return factor == 1.0; };
    const auto usual_tool = static_cast<std::uint32_t>(toolFor(role, plan.plan->tools));
    has_usual_flow_ = std::all_of(flows_.begin(), flows_.end(), is_one);
    is_as_planned_ = has_usual_flow_ && std::all_of(feeds_.begin(), feeds_.end(), is_one) &&
                     std::all_of(tools_.begin(), tools_.end(),
                                 [usual_tool](std::uint32_t tool) { return tool == usual_tool; });
  }

  bool areAsPlanned() const { return is_as_planned_; }
  bool haveUsualFlow() const { return has_usual_flow_; }
  double feedFactor(std::size_t piece) const { return feeds_[piece]; }
  double flowFactor(std::size_t piece) const { return flows_[piece]; }
  std::uint32_t tool(std::size_t piece) const { return tools_[piece]; }
  const std::vector<Polygon>& borders() const { return all_; }
  /// Outside of all pieces it is the last one.
  std::size_t pieceAt(const Point2& point) const {
    for (std::size_t i = 0; i + 1 < borders_.size(); ++i)
      if (contains(borders_[i], point)) return i;
    return borders_.size() - 1;
  }

 private:
  std::vector<std::vector<Polygon>> borders_;
  std::vector<Polygon> all_;
  std::vector<double> feeds_;  ///< factors
  std::vector<double> flows_;  ///< the same
  std::vector<std::uint32_t> tools_;
  bool has_usual_flow_ = true;
  bool is_as_planned_ = true;
};

/// Ends of the motions of a wall, divided at borders.
std::vector<FinerPoint> dividedBy(const PieceRules& rules, const Path& wall) {
  std::vector<FinerPoint> finer;
  for (std::size_t m = 0; m < wall.motionCount(); ++m) {
    const std::size_t end = wall.motionEnd(m);
    const Point3& from = wall.points[m];
    const Point3& to = wall.points[end];
    std::vector<double> shares = crossings(from.head<2>(), to.head<2>(), rules.borders());
    shares.push_back(1.0);
    double share = 0.0;
    for (const double next : shares) {
      if (next - share < 1e-9) continue;
      const Point3 middle = from + 0.5 * (share + next) * (to - from);
      finer.push_back(
          {next < 1.0 ? Point3(from + next * (to - from)) : to, end, rules.pieceAt(middle.head<2>())});
      share = next;
    }
  }
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

/// The wall with a waypoint at each of the ends.
Path withRulesOf(const PieceRules& rules, Path wall, const std::vector<FinerPoint>& ends) {
  std::vector<FinerPoint> points = ends;
  // The return of a closed wall is what leads to its first waypoint.
  if (wall.is_closed)
    std::rotate(points.begin(), points.end() - 1, points.end());
  else
    points.insert(points.begin(), {wall.points.front(), 0, ends.front().piece});
  std::vector<double> feed_mm_s;
  std::vector<Bead> beads;
  for (const FinerPoint& point : points) {
    feed_mm_s.push_back(wall.feed_mm_s.at(point.like) * rules.feedFactor(point.piece));
    const Bead& bead = wall.bead.at(point.like);
    beads.push_back(beadOfArea(rules.flowFactor(point.piece) * crossSection(bead), bead.height_mm));
  }
  wall.feed_mm_s = AlongPath<double>(std::move(feed_mm_s));
  wall.bead = rules.haveUsualFlow() ? likeBefore(wall.bead, points) : AlongPath<Bead>(std::move(beads));
  for (ProcessValue& each : wall.values) each.value = likeBefore(each.value, points);
  wall.points.clear();
  for (const FinerPoint& point : points) wall.points.push_back(point.point);
  return wall;
}

/// One path, or several that follow each other where the tool changes.
std::vector<Path> depositedBy(const PieceRules& rules, Path wall) {
  if (rules.areAsPlanned()) return {std::move(wall)};
  const std::vector<FinerPoint> ends = dividedBy(rules, wall);
  if (ends.empty()) return {std::move(wall)};
  Path rest = withRulesOf(rules, std::move(wall), ends);
  std::vector<Path> parts;
  for (std::size_t m = ends.size(); m-- > 1;) {
    const std::uint32_t tool = rules.tool(ends[m].piece);
    if (tool == rules.tool(ends[m - 1].piece)) continue;
    std::pair<Path, Path> cut = cutAt(rest, m);
    parts.push_back(std::move(cut.second));
    parts.back().tool = tool;
    rest = std::move(cut.first);
  }
  rest.tool = rules.tool(ends.front().piece);
  parts.push_back(std::move(rest));
  std::reverse(parts.begin(), parts.end());
  return parts;
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

std::vector<Path> depositedByPieces(std::vector<Path> paths, std::size_t from,
                                    const std::vector<IslandPiece>& pieces, const WallRules& deposited_by) {
  std::vector<Path> deposited(std::make_move_iterator(paths.begin()),
                              std::make_move_iterator(paths.begin() + static_cast<std::ptrdiff_t>(from)));
  for (std::size_t i = from; i < paths.size(); ++i) {
    if (paths[i].role == PathRole::Travel) {
      deposited.push_back(std::move(paths[i]));
      continue;
    }
    const PieceRules rules(pieces, paths[i].role, deposited_by);
    std::vector<Path> parts = depositedBy(rules, std::move(paths[i]));
    std::move(parts.begin(), parts.end(), std::back_inserter(deposited));
  }
  return deposited;
}

}  // namespace lamina
