// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// A place on a loop.
struct LoopPlace {
  double position_mm = 0.0;  ///< along the loop, from its first point
  double distance_mm = 0.0;  ///< of what was asked for
};

/// A stretch of a loop around a place.
struct LoopStretch {
  double middle_mm = 0.0;
  double reach_mm = 0.0;  ///< to either side
};

/// A closed line measured by arc length. Positions along it [mm] may be any number: they go round.
class Loop {
 public:
  /// @param points    at least three, no two neighbours the same
  /// @param width_mm  plan width on the way to each point
  Loop(Polygon points, std::vector<double> width_mm);

  double length() const { return at_.back(); }
  const Box2& box() const { return box_; }
  const Polygon& points() const { return points_; }
  /// Within [0, length).
  double wrapped(double position) const;
  Point2 pointAt(double position) const;
  double widthAt(double position) const;

  /// The nearest place to a point.
  LoopPlace nearest(const Point2& point) const;
  /// The nearest place to a point on a stretch.
  LoopPlace nearest(const Point2& point, const LoopStretch& stretch) const;
  /// Where a ray first hits a stretch; the distance along it, which has unit length.
  std::optional<LoopPlace> hit(const Point2& from, const Point2& direction, const LoopStretch& stretch) const;
  /// Whether the open line from one point to the other crosses the loop; touching at its ends does not count.
  bool isCrossedBy(const Point2& from, const Point2& to) const;

  /// Index of the point at or before a position within [0, length).
  std::size_t edgeAt(double position) const;
  double positionOf(std::size_t point) const { return at_[point]; }
  /// Plan width on the edge that starts at that point.
  double edgeWidth(std::size_t point) const { return width_[point + 1 < points_.size() ? point + 1 : 0]; }
  std::size_t size() const { return points_.size(); }

 private:
  const Point2& endOf(std::size_t edge) const { return points_[edge + 1 < points_.size() ? edge + 1 : 0]; }
  template <class Visit>
  void visitEdges(const LoopStretch& stretch, const Visit& visit) const;

  Polygon points_;
  std::vector<double> width_;
  std::vector<double> at_;  ///< of each point, and the length
  Box2 box_;
};

/// A piece of a loop to be taken out [mm along it]: from one position forward to the other.
struct LoopGap {
  std::size_t loop = 0;
  double from_mm = 0.0;  ///< within [0, length)
  double to_mm = 0.0;    ///< greater than `from_mm`, by less than the length

  double length() const { return to_mm - from_mm; }
};

/// Which ends of two gaps a link joins.
enum class LinkEnds {
  Alike,     ///< both starts, and both ends
  Opposite,  ///< the start of each to the end of the other
};

/// Rings that are cut open and joined by links. Joining two that hang together through no others makes one
/// closed line of both.
class LoopGraph {
 public:
  explicit LoopGraph(std::vector<Loop> loops);

  const std::vector<Loop>& loops() const { return loops_; }
  /// Rings with the same number hang together.
  std::size_t groupOf(std::size_t loop) const;
  /// Gaps made so far in a loop.
  const std::vector<LoopGap>& gapsOf(std::size_t loop) const { return gaps_[loop]; }
  /// Whether a gap keeps a margin from those made so far [mm].
  bool isFree(const LoopGap& gap, double margin_mm) const;

  /// Whether the line from one point to the other crosses a link made so far.
  bool isLinkCrossedBy(const Point2& from, const Point2& to) const;

  /// Cuts both and joins them by two links.
  void join(const LoopGap& a, const LoopGap& b, LinkEnds ends);
  /// Cuts each loop and leads from the start of each gap to the end of the next one: the first gap's end and
  /// the last one's start stay open.
  void chain(const std::vector<LoopGap>& gaps);

  /// One line for each group, in the order of their first loops: closed, or open from the first open end.
  std::vector<FillPath> lines() const;

 private:
  struct End {
    std::size_t loop;
    std::size_t gap;
    int side;  ///< 0 is where the gap starts
  };
  struct Joints {
    std::array<std::optional<End>, 2> to;  ///< of each side
  };
  class Walk;

  std::size_t cut(const LoopGap& gap);
  void joinEnds(const End& a, const End& b);
  Point2 pointOf(const End& end) const;
  void merge(std::size_t a, std::size_t b);

  std::vector<Loop> loops_;
  std::vector<std::vector<LoopGap>> gaps_;   ///< loop by loop
  std::vector<std::vector<Joints>> joints_;  ///< of each gap
  std::vector<std::array<Point2, 2>> links_;
  std::vector<std::size_t> parent_;  ///< union-find
};

}  // namespace lamina
