// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lamina {

/// Detects a lump that is higher than the range in which points are assigned to cells. A height counts if
/// three neighbouring points in each of three profiles in a row reach it; single points, such as spray, and
/// single profiles do not count.
class LumpWatch {
 public:
  /// Adds a profile.
  /// @param heights_mm  of its points in their order; not finite where a point is missing
  void see(const std::vector<double>& heights_mm);
  /// Forgets all profiles.
  void reset() { *this = LumpWatch(); }

  /// Greatest height [mm] that has counted; `kNone` if there is none.
  double height() const { return height_mm_; }
  static constexpr double kNone = -1e9;

 private:
  /// Greatest counting heights of the two profiles before.
  std::array<double, 2> before_mm_ = {kNone, kNone};
  double height_mm_ = kNone;
};

}  // namespace lamina
