// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/path_nesting.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "geometry/polygon/clipper_units.hpp"

namespace lamina {
namespace {

constexpr std::size_t kOutside = std::numeric_limits<std::size_t>::max();
constexpr int kOnOutline = -1;
constexpr std::size_t kManyPoints = 256;

/// In units: an outline narrower than this may have been turned round when its corners were rounded.
constexpr double kNeedle = 1.0;

struct Extent {
  ClipperLib::cInt low_x, high_x, low_y, high_y;
  double area;       ///< negative for holes
  double perimeter;  ///< at most, by the sides of the bounding boxes of its edges
  const ClipperLib::Path* path;
};

Extent extentOf(const ClipperLib::Path& path) {
  const ClipperLib::IntPoint& first = path.front();
  Extent extent{first.X, first.X, first.Y, first.Y, ClipperLib::Area(path), 0.0, &path};
  const ClipperLib::IntPoint* before = &path.back();
  for (const ClipperLib::IntPoint& point : path) {
    extent.perimeter += std::abs(static_cast<double>(point.X - before->X)) +
                        std::abs(static_cast<double>(point.Y - before->Y));
    before = &point;
    extent.low_x = std::min(extent.low_x, point.X);
    extent.high_x = std::max(extent.high_x, point.X);
    extent.low_y = std::min(extent.low_y, point.Y);
    extent.high_y = std::max(extent.high_y, point.Y);
  }
  return extent;
}

bool runsWrongWay(const Extent& extent, bool is_hole) {
  if ((extent.area < 0.0) == is_hole) return false;
  return std::abs(extent.area) > kNeedle * extent.perimeter;
}

bool mayHold(const Extent& outer, const Extent& inner) {
  return outer.low_x <= inner.low_x && inner.high_x <= outer.high_x && outer.low_y <= inner.low_y &&
         inner.high_y <= outer.high_y && std::abs(outer.area) >= std::abs(inner.area);
}

/// An outline whose edges are sorted by their heights, for many points.
class BandedPath {
 public:
  explicit BandedPath(const Extent& extent)
      : path_(*extent.path),
        low_(extent.low_y),
        band_(1 + (extent.high_y - extent.low_y) / static_cast<ClipperLib::cInt>(path_.size())),
        edges_(static_cast<std::size_t>((extent.high_y - extent.low_y) / band_) + 1) {
    for (std::size_t i = 0, j = path_.size() - 1; i < path_.size(); j = i++) {
      const auto [low, high] = std::minmax(path_[j].Y, path_[i].Y);
      for (std::size_t band = bandOf(low); band <= bandOf(high); ++band)
        edges_[band].push_back(static_cast<std::uint32_t>(j));
    }
  }

  /// As `ClipperLib::PointInPolygon` reports it, for points within the height of the outline.
  int where(const ClipperLib::IntPoint& point) const {
    bool is_inside = false;
    for (const std::uint32_t edge : edges_[bandOf(point.Y)]) {
      const ClipperLib::IntPoint& from = path_[edge];
      const ClipperLib::IntPoint& to = path_[edge + 1 < path_.size() ? edge + 1 : 0];
      if (to.Y == point.Y &&
          (to.X == point.X || (from.Y == point.Y && (to.X > point.X) == (from.X < point.X))))
        return kOnOutline;
      if ((from.Y < point.Y) == (to.Y < point.Y) || (from.X < point.X && to.X <= point.X)) continue;
      if (from.X >= point.X && to.X > point.X) {
        is_inside = !is_inside;
        continue;
      }
      const double turn = static_cast<double>(from.X - point.X) * static_cast<double>(to.Y - point.Y) -
                          static_cast<double>(to.X - point.X) * static_cast<double>(from.Y - point.Y);
      if (turn == 0.0) return kOnOutline;
      if ((turn > 0.0) == (to.Y > from.Y)) is_inside = !is_inside;
    }
    return is_inside ? 1 : 0;
  }

 private:
  std::size_t bandOf(ClipperLib::cInt y) const { return static_cast<std::size_t>((y - low_) / band_); }

  const ClipperLib::Path& path_;
  ClipperLib::cInt low_;
  ClipperLib::cInt band_;
  std::vector<std::vector<std::uint32_t>> edges_;  ///< of each band, by their first points
};

/// Each outline, and those directly in it, in the order in which Clipper reports them.
class PathTree {
 public:
  explicit PathTree(const ClipperLib::Paths& paths) {
    extents_.reserve(paths.size());
    for (const ClipperLib::Path& path : paths)
      if (path.size() > 2) extents_.push_back(extentOf(path));  // Clipper's tree leaves the others out too
    parents_.assign(extents_.size(), kOutside);
    children_.resize(extents_.size());
  }

  /// Finds what lies in what, from below upwards. False where that is in doubt.
  bool build() {
    std::vector<std::pair<ClipperLib::cInt, std::size_t>> from_below;
    from_below.reserve(extents_.size());
    for (std::size_t i = 0; i < extents_.size(); ++i) from_below.emplace_back(extents_[i].low_y, i);
    std::sort(from_below.begin(), from_below.end());
    std::vector<std::size_t> beside;
    std::size_t entered = 0;
    for (const auto& [low_y, i] : from_below) {
      for (; entered < from_below.size() && from_below[entered].first <= low_y; ++entered)
        beside.push_back(from_below[entered].second);
      std::size_t kept = 0;
      for (const std::size_t other : beside)
        if (extents_[other].high_y >= low_y) beside[kept++] = other;
      beside.resize(kept);
      if (!findParent(i, beside)) return false;
    }
    for (std::size_t i = 0; i < extents_.size(); ++i)
      (parents_[i] == kOutside ? outermost_ : children_[parents_[i]]).push_back(i);
    return true;
  }

  /// Outer outlines with their holes; nothing if one does not run the way round that its depth asks for.
  std::optional<Regions> regions() const {
    Regions found;
    std::vector<std::size_t> ahead(outermost_.rbegin(), outermost_.rend());
    while (!ahead.empty()) {
      const std::size_t outer = ahead.back();
      ahead.pop_back();
      if (runsWrongWay(extents_[outer], false)) return std::nullopt;
      Region& region = found.emplace_back();
      region.outer = fromUnits(*extents_[outer].path);
      region.holes.reserve(children_[outer].size());
      for (const std::size_t hole : children_[outer]) {
        if (runsWrongWay(extents_[hole], true)) return std::nullopt;
        region.holes.push_back(fromUnits(*extents_[hole].path));
      }
      for (auto hole = children_[outer].rbegin(); hole != children_[outer].rend(); ++hole)
        ahead.insert(ahead.end(), children_[*hole].rbegin(), children_[*hole].rend());
    }
    return found;
  }

 private:
  /// The smallest outline that holds it. Outlines may touch: the first point that lies on neither side of
  /// the border decides.
  bool findParent(std::size_t of, const std::vector<std::size_t>& beside) {
    const Extent& inner = extents_[of];
    for (const std::size_t other : beside) {
      const Extent& outer = extents_[other];
      if (other == of || !mayHold(outer, inner)) continue;
      if (parents_[of] != kOutside && std::abs(outer.area) >= std::abs(extents_[parents_[of]].area)) continue;
      int where = kOnOutline;
      for (std::size_t i = 0; i < inner.path->size() && where == kOnOutline; ++i)
        where = whereIn(other, (*inner.path)[i]);
      if (where == kOnOutline) return false;
      if (where != 0) parents_[of] = other;
    }
    return true;
  }

  int whereIn(std::size_t outline, const ClipperLib::IntPoint& point) {
    const Extent& extent = extents_[outline];
    if (extent.path->size() < kManyPoints) return ClipperLib::PointInPolygon(point, *extent.path);
    return banded_.try_emplace(outline, extent).first->second.where(point);
  }

  std::vector<Extent> extents_;
  std::vector<std::size_t> parents_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::size_t> outermost_;
  std::map<std::size_t, BandedPath> banded_;  ///< outlines of many points that something may lie in
};

}  // namespace

std::optional<Regions> nestPaths(const ClipperLib::Paths& paths) {
  PathTree tree(paths);
  if (!tree.build()) return std::nullopt;
  return tree.regions();
}

Regions executed(ClipperLib::Clipper& clipper, ClipperLib::ClipType operation,
                 ClipperLib::PolyFillType rule) {
  ClipperLib::Paths paths;
  clipper.Execute(operation, paths, rule, rule);
  if (std::optional<Regions> nested = nestPaths(paths)) return std::move(*nested);
  ClipperLib::PolyTree tree;
  clipper.Execute(operation, tree, rule, rule);
  return fromTree(tree);
}

}  // namespace lamina
