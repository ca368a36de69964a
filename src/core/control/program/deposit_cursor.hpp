// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A piece of a depositing path that a motion of the program lays.
struct LaidStretch {
  std::size_t layer = 0;
  std::size_t path = 0;  ///< of the layer
  double from_mm = 0.0;  ///< along it
  double to_mm = 0.0;
};

/// Follows the depositing motions of a program along its toolpath, in order. A motion starts where the one
/// before ended, or at the start of one of the paths that come next; else it is none of the toolpath.
class DepositCursor {
 public:
  DepositCursor(const Toolpath& toolpath, double tolerance_mm);

  /// Where a straight motion that deposits lies; nothing if it is off the toolpath, which leaves the cursor.
  std::optional<LaidStretch> follow(const Point3& start, const Point3& end);

  /// The start of one of the paths that come next, if the point is there.
  std::optional<LaidStretch> startingAt(const Point3& point) const;
  /// Whether some of a layer, or of one above, is laid.
  bool hasBegun(std::size_t layer) const;
  /// Whether all of the toolpath is laid.
  bool isAtEnd() const;

 private:
  struct Run {
    const Path* path;
    std::size_t layer;
    std::size_t index;
  };
  struct Place {
    std::size_t run = 0;
    std::size_t motion = 0;
    double into_mm = 0.0;   ///< the motion
    double along_mm = 0.0;  ///< the path
  };
  bool isAt(const Place& place, const Point3& point) const;
  Point3 pointAt(const Place& place) const;
  std::optional<Place> placeAhead(const Place& from, const Point3& start, const Point3& end) const;

  double tolerance_mm_;
  std::vector<Run> runs_;
  Place place_;
  double last_length_mm_ = 0.0;  ///< of the last run
};

}  // namespace lamina
