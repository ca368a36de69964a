// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A change of tools within a layer, and what is laid for it.
struct Purge {
  std::uint32_t tool = 0;  ///< that is taken
  double volume_mm3 = 0.0;
};

/// What a layer of the tower is asked for.
struct TowerLayer {
  double height_mm = 0.0;
  std::vector<Purge> purges;
};

constexpr double kTowerBesidePart = 5.0;  ///< mm, where it has no place of its own

/// A square tower of two walls, filled by what tools lay into it when they are taken: as much as is asked
/// for, of which the first of a layer lays the walls. Where no tool changes, walls and a few lines keep it as
/// high as the part.
class PrimeTower {
 public:
  /// @param layers  all of the tower, of which those above the last purge are not laid
  /// @param part    box of what is deposited, in the frame of the layers
  /// @throws InvalidConfig if it is too small, or stands on the part
  PrimeTower(std::vector<TowerLayer> layers, const PlanSettings& settings, const Box2& part);

  double side() const { return side_mm_; }
  /// One past the last layer in which a tool changes.
  std::size_t height() const { return height_; }
  bool purgesIn(std::size_t layer) const { return !layers_[layer].purges.empty(); }

  /// What a purge of a layer lays: two paths at most.
  std::vector<Path> purge(std::size_t layer, std::size_t index, double z_mm) const;
  /// What is laid in a layer without purges.
  std::vector<Path> keep(std::size_t layer, std::uint32_t tool, double z_mm) const;

 private:
  struct Measures;
  Measures measuresAt(std::size_t layer, double side_mm) const;
  void fit();
  void place(const Box2& part);
  std::vector<Point2> walls(std::size_t layer) const;
  std::vector<Point2> lines(std::size_t layer, double spacing) const;
  Path path(const std::vector<Point2>& points, std::size_t layer, std::uint32_t tool, double z_mm) const;

  std::vector<TowerLayer> layers_;
  PlanSettings settings_;
  std::size_t height_ = 0;
  double side_mm_ = 0.0;
  Point2 middle_ = Point2::Zero();
};

}  // namespace lamina
