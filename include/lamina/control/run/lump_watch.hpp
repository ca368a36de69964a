// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lamina {

/// Notices what stands higher than any cell is looked for: three neighbouring points of a profile, in three
/// profiles in a row. Single returns, as of spray, and single profiles are none.
class LumpWatch {
 public:
  /// Heights of a profile's points in their order [mm]; those that are not finite stand for none.
  void see(const std::vector<double>& heights_mm);
  /// Nothing is seen yet.
  void reset() { *this = LumpWatch(); }

  /// The greatest height that is believed [mm]; `kNone` without any.
  double height() const { return height_mm_; }
  static constexpr double kNone = -1e9;

 private:
  std::array<double, 2> before_mm_ = {kNone, kNone};  ///< of the two profiles before
  double height_mm_ = kNone;
};

}  // namespace lamina
