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
  double distance_mm = 0.0;  ///< from the queried point
};

/// A stretch of a loop, centred at a position.
struct LoopStretch {
  double middle_mm = 0.0;
  double reach_mm = 0.0;  ///< length of the stretch to either side
};

/// A closed line parameterized by arc length. Positions [mm] may be any number, as they are taken modulo the
/// length.
class Loop {
 public:
  /// @param points    at least three, no two neighbours the same
  /// @param width_mm  plan width of the bead on the motion to each point
  Loop(Polygon points, std::vector<double> width_mm);

  double length() const { return at_.back(); }
  const Box2& box() const { return box_; }
  const Polygon& points() const { return points_; }
  /// The position modulo the length, in [0, length).
  double wrapped(double position) const;
  Point2 pointAt(double position) const;
  double widthAt(double position) const;

  /// The place of the loop that is nearest to a point.
  LoopPlace nearest(const Point2& point) const;
  /// The place of a stretch that is nearest to a point.
  LoopPlace nearest(const Point2& point, const LoopStretch& stretch) const;
  /// Where a ray first meets a stretch; its distance is measured along the ray. `direction` has unit length.
  std::optional<LoopPlace> hit(const Point2& from, const Point2& direction, const LoopStretch& stretch) const;
  /// Whether the segment between two points crosses the loop; touching at the ends does not count.
  bool isCrossedBy(const Point2& from, const Point2& to) const;

  /// Index of the point at or before a position within [0, length).
  std::size_t edgeAt(double position) const;
  double positionOf(std::size_t point) const { return at_[point]; }
  /// Plan width on the edge that starts at this point.
  double edgeWidth(std::size_t point) const { return width_[point + 1 < points_.size() ? point + 1 : 0]; }
  std::size_t size() const { return points_.size(); }

 private:
  const Point2& endOf(std::size_t edge) const { return points_[edge + 1 < points_.size() ? edge + 1 : 0]; }
  template <class Visit>
  void visitEdges(const LoopStretch& stretch, const Visit& visit) const;

  Polygon points_;
  std::vector<double> width_;
  std::vector<double> at_;  ///< position of each point, and the length of the loop
  Box2 box_;
};

/// A piece of a loop that is cut out [mm along the loop], in the direction of the loop from one position to
/// the other.
struct LoopGap {
  std::size_t loop = 0;
  double from_mm = 0.0;  ///< within [0, length)
  double to_mm = 0.0;    ///< greater than `from_mm`, by less than the length

  double length() const { return to_mm - from_mm; }
};

/// Which ends of two gaps a link joins.
enum class LinkEnds {
  Alike,     ///< start with start, and end with end
  Opposite,  ///< the start of each gap with the end of the other
};

/// Loops that are cut open and joined by links. Joining two loops that are not connected yet makes one closed
/// line of them.
class LoopGraph {
 public:
  explicit LoopGraph(std::vector<Loop> loops);

  const std::vector<Loop>& loops() const { return loops_; }
  /// Number of the group of connected loops to which a loop belongs.
  std::size_t groupOf(std::size_t loop) const;
  /// Gaps made so far in a loop.
  const std::vector<LoopGap>& gapsOf(std::size_t loop) const { return gaps_[loop]; }
  /// Whether a gap keeps a distance from those made so far [mm].
  bool isFree(const LoopGap& gap, double margin_mm) const;

  /// Whether the segment between two points crosses a link made so far.
  bool isLinkCrossedBy(const Point2& from, const Point2& to) const;

  /// Cuts both gaps and joins them by two links.
  void join(const LoopGap& a, const LoopGap& b, LinkEnds ends);
  /// Cuts all gaps and links the start of each to the end of the next one. The end of the first gap and the
  /// start of the last one stay open.
  void chain(const std::vector<LoopGap>& gaps);

  /// One line for each group, in the order of first loops; closed, or open from its first open end.
  std::vector<FillPath> lines() const;

 private:
  struct End {
    std::size_t loop;
    std::size_t gap;
    int side;  ///< 0 for the start of the gap, 1 for its end
  };
  struct Joints {
    std::array<std::optional<End>, 2> to;  ///< what each side of a gap is linked to
  };
  class Walk;

  std::size_t cut(const LoopGap& gap);
  void joinEnds(const End& a, const End& b);
  Point2 pointOf(const End& end) const;
  void merge(std::size_t a, std::size_t b);

  std::vector<Loop> loops_;
  std::vector<std::vector<LoopGap>> gaps_;   ///< loop by loop
  std::vector<std::vector<Joints>> joints_;  ///< for each gap
  std::vector<std::array<Point2, 2>> links_;
  std::vector<std::size_t> group_;                 ///< lowest loop of the group, for each loop
  std::vector<std::vector<std::size_t>> members_;  ///< loops of each group; read far more often than merged
};

}  // namespace lamina
