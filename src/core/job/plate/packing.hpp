// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "job/plate/arrangement.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Footprints on a bed, packed one after the other (`arranged`).
class Packing {
 public:
  static constexpr int kDirections = 16;
  /// How far a footprint reaches in each of the directions, every 22.5 deg from x [mm].
  using Reach = std::array<double, kDirections>;

  Packing(const Box2& bed, double spacing_mm) : bed_(bed), spacing_mm_(spacing_mm) {}

  /// @param hull  convex
  void addFixed(const Polygon& hull, const Point2& at);

  /// Place of the next one, which stands there from then on; none if there is no room.
  std::optional<PlatePlace> placed(const Polygon& hull);

 private:
  struct Standing {
    Reach reach{};
    Point2 at = Point2::Zero();
  };

  std::optional<Point2> lowestLeft(const Reach& reach) const;
  std::vector<double> levels(const Reach& reach, double low, double high) const;
  std::optional<double> leftmost(const Reach& reach, double y, double low, double high) const;
  Reach keptClear(const Standing& standing, const Reach& reach) const;

  Box2 bed_;
  double spacing_mm_;
  std::vector<Standing> standing_;
};

}  // namespace lamina
