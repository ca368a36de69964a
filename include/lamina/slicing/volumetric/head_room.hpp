// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A stage of a print head: a cylinder about the tool axis.
struct HeadStage {
  double from_mm = 0.0;  ///< distance of its lower face from the nozzle tip, against the tool axis
  double to_mm = 0.0;    ///< distance of its upper face from the nozzle tip
  double radius_mm = 0.0;
};

/// Collision check of a print head against the bed, and against the material deposited so far.
class HeadRoom {
 public:
  /// The order of deposition: the growth [mm] at which the material at a point is deposited. Growth increases
  /// as the part is printed. It is infinite where no material is deposited.
  class Growth {
   public:
    virtual ~Growth() = default;
    /// @param place  [mm, part frame]
    virtual double at(const Point3& place) const = 0;
    /// A lower bound of the growth within `kAroundMm` of a place; minus infinity if a bound costs as much as
    /// the growth at the places themselves.
    virtual double leastAround(const Point3& place) const;
  };
  static constexpr double kAroundMm = 8.0;

  /// @param stages  stages of the head; without stages there are no collisions
  /// @param bed_mm  z of the bed [part frame]
  HeadRoom(std::shared_ptr<const Growth> growth, const std::vector<HeadStage>& stages, double bed_mm);

  /// Whether the head collides neither with the bed nor with material deposited before a given growth.
  /// Collisions with material are tested at points of the head's hull that are at most 4 mm apart, and only
  /// between 3 and 120 mm from the tip along the axis.
  /// @param tip   nozzle tip [mm, part frame]
  /// @param axis  opposite of the tool axis, of unit length
  bool isClear(const Point3& tip, const Point3& axis, double growth_mm) const;

 private:
  /// Points of the hull within `kAroundMm` of their middle.
  struct Patch {
    Point3 middle;
    std::vector<Point3> points;
  };
  static void addPatches(std::vector<Point3> points, std::vector<Patch>& patches);

  std::shared_ptr<const Growth> growth_;
  std::vector<HeadStage> stages_;
  std::vector<Patch> hull_;  // tip at 0, z against the tool axis
  double bed_mm_;
};

}  // namespace lamina
