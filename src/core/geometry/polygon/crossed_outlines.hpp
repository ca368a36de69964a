// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Intersection and difference of two areas by splicing their outlines where they cross. This takes far less
/// work than a sweep, which must also handle outlines that touch, coincide or meet in a point.
class CrossedOutlines {
 public:
  /// @param a, b  outlines do not cross themselves or others of their region; both must outlive the object
  CrossedOutlines(const Regions& a, const Regions& b);

  /// The intersection of the two areas. Nothing if outlines of one are close to those of the other without
  /// plainly crossing them, or if regions of one area meet. Corners lie within 1e-5 mm of the exact ones;
  /// narrower pieces are left out.
  std::optional<Regions> common() const;
  /// `a` without `b`; nothing as for `common`.
  std::optional<Regions> rest() const;

 private:
  struct Outline {
    const Polygon* points = nullptr;
    std::uint32_t first = 0;  ///< index of its first edge among all edges of its area
    std::uint32_t region = 0;
    bool is_hole = false;
    Box2 box;
    bool is_crossed = false;
  };
  struct Edge {
    const Polygon* points = nullptr;
    std::uint32_t outline = 0;
    std::uint32_t from = 0;  ///< point of the outline at which it begins
    const Point2& begin() const { return (*points)[from]; }
    const Point2& end() const { return (*points)[from + 1 < points->size() ? from + 1 : 0]; }
  };
  /// One of the two areas.
  struct Area {
    std::vector<Outline> outlines;
    std::vector<Edge> edges;
    Box2 box;
    std::vector<std::uint32_t> next;      ///< for each crossing the next one along its outline
    std::vector<std::uint32_t> previous;  ///< for each crossing the previous one along its outline
    bool encloses(const Point2& point) const;
  };
  struct Crossing {
    std::array<std::uint32_t, 2> edge;  ///< indices of the edges of a and b
    std::array<double, 2> along;        ///< position on either edge, 0 to 1
    Point2 at;
    bool enters = false;  ///< whether the outline of a enters b there
  };
  struct SweptEdge {
    double low_y = 0.0, high_y = 0.0, low_x = 0.0, high_x = 0.0;
    std::uint32_t edge = 0;
    std::uint32_t side = 0;
  };

  static Area areaOf(const Regions& regions);
  std::vector<SweptEdge> sweptEdges() const;
  bool findCrossings();
  static bool mayMeet(const Outline& a, const Outline& b);
  static bool mayOverlapItself(const Area& area);
  bool meet(const SweptEdge& a, const SweptEdge& b);
  bool linkCrossings(std::size_t side);
  void walk(std::size_t side, std::uint32_t from, std::uint32_t to, Polygon& outline) const;
  void walkBack(std::size_t side, std::uint32_t from, std::uint32_t to, Polygon& outline) const;
  std::optional<std::vector<Polygon>> spliced(bool takes_common) const;
  std::optional<Regions> combined(bool takes_common) const;

  std::array<Area, 2> areas_;
  std::vector<Crossing> crossings_;
  bool is_clear_;
};

}  // namespace lamina
