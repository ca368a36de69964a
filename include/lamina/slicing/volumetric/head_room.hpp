// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A piece of a head round its tool axis.
struct HeadStage {
  double from_mm = 0.0;  ///< from the nozzle tip, against the tool axis
  double to_mm = 0.0;
  double radius_mm = 0.0;
};

/// Where a head fits over a part that grows, and the bed.
class HeadRoom {
 public:
  /// Growth at which a place of the part is deposited [mm]; infinite where nothing ever is.
  class Growth {
   public:
    virtual ~Growth() = default;
    virtual double at(const Point3& place) const = 0;
  };

  /// @param stages  none: the head is clear everywhere
  HeadRoom(std::shared_ptr<const Growth> growth, const std::vector<HeadStage>& stages, double bed_mm);

  /// Whether the head clears the bed and what is deposited before a growth, by points on its hull at most 4
  /// mm apart. What lies within 3 mm of the tip is not looked at.
  /// @param axis  against the tool axis, of unit length
  bool isClear(const Point3& tip, const Point3& axis, double growth_mm) const;

 private:
  std::shared_ptr<const Growth> growth_;
  std::vector<HeadStage> stages_;
  std::vector<Point3> hull_;  // tip at 0, z against the tool axis
  double bed_mm_;
};

}  // namespace lamina
