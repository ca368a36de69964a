// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The piece of a depositing path that a motion of the program deposits.
struct DepositedStretch {
  std::size_t layer = 0;
  std::size_t path = 0;  ///< number in the layer
  double from_mm = 0.0;  ///< distance of its beginning from the start of the path
  double to_mm = 0.0;
};

/// Follows the depositing motions of a program along its toolpath, in order. A motion belongs to the toolpath
/// if it starts where the one before ended, or at the start of one of the next paths.
class DepositCursor {
 public:
  DepositCursor(const Toolpath& toolpath, double tolerance_mm);

  /// The piece that a straight depositing motion deposits. Nothing if the motion is not on the toolpath, in
  /// which case the cursor does not move.
  std::optional<DepositedStretch> follow(const Point3& start, const Point3& end);

  /// The beginning of the next path that starts at a point; nothing if no path does.
  std::optional<DepositedStretch> startingAt(const Point3& point) const;
  /// Whether any part of a layer, or of one above it, is deposited.
  bool hasBegun(std::size_t layer) const;
  /// Whether all of the toolpath is deposited.
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
    double into_mm = 0.0;   ///< distance from the start of the motion
    double along_mm = 0.0;  ///< distance from the start of the path
  };
  bool isAt(const Place& place, const Point3& point) const;
  Point3 pointAt(const Place& place) const;
  std::optional<Place> placeAhead(const Place& from, const Point3& start, const Point3& end) const;

  double tolerance_mm_;
  std::vector<Run> runs_;
  Place place_;
  double last_length_mm_ = 0.0;  ///< length of the last run
};

}  // namespace lamina
