// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lamina {

/// Detects a lump that stands higher than the range in which cells are searched for. It takes three
/// neighbouring points in each of three profiles in a row; single returns, as of spray, and single profiles
/// do not count.
class LumpWatch {
 public:
  /// Takes a profile by the heights of its points in their order [mm]; not finite where a point is missing.
  void see(const std::vector<double>& heights_mm);
  /// Forgets all profiles.
  void reset() { *this = LumpWatch(); }

  /// Greatest height of a lump [mm]; `kNone` if none was detected.
  double height() const { return height_mm_; }
  static constexpr double kNone = -1e9;

 private:
  std::array<double, 2> before_mm_ = {kNone, kNone};  ///< of the two profiles before
  double height_mm_ = kNone;
};

}  // namespace lamina
