// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A purge at a change of tools within a layer.
struct Purge {
  std::uint32_t tool = 0;  ///< the tool that is changed to
  double volume_mm3 = 0.0;
};

/// A layer of the tower.
struct TowerLayer {
  double height_mm = 0.0;
  std::vector<Purge> purges;
};

/// Distance from the part if the tower has no position of its own [mm].
constexpr double kTowerBesidePart = 5.0;

/// A square tower of two walls, filled by the purges of tools. The first purge of a layer deposits the walls.
/// In a layer without purges the walls and a few lines are deposited, so that the tower keeps up with the
/// part.
class PrimeTower {
 public:
  /// @param layers  all layers; those above the last purge are not deposited
  /// @param part    box of the deposition, in the frame of the layers
  /// @throws InvalidConfig if the tower is too small, or stands on the part
  PrimeTower(std::vector<TowerLayer> layers, const PlanSettings& settings, const Box2& part);

  double side() const { return side_mm_; }
  /// One past the last layer in which a tool changes.
  std::size_t height() const { return height_; }
  bool purgesIn(std::size_t layer) const { return !layers_[layer].purges.empty(); }

  /// The paths of a purge in a layer; at most two.
  std::vector<Path> purge(std::size_t layer, std::size_t index, double z_mm) const;
  /// The paths of a layer without purges.
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
