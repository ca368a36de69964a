// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lamina {

/// How late something was, over and over. Memory does not grow: times are counted in tenths of a millisecond
/// up to a tenth of a second, and beyond it as more.
class Lateness {
 public:
  static constexpr double kLate = 0.01;     ///< s: reported
  static constexpr double kTooLate = 0.05;  ///< s: nothing is in step any more

  /// @param late_s  negative counts as 0
  void add(double late_s);

  std::uint64_t count() const { return count_; }
  std::uint64_t late() const { return late_; }         ///< by more than `kLate`
  std::uint64_t tooLate() const { return too_late_; }  ///< by more than `kTooLate`
  double worst() const { return worst_s_; }            ///< [s]
  /// The time that a share of all is not above, rounded up to a tenth of a millisecond [s]; the worst where
  /// that lies beyond what is counted, 0 if there is none.
  double percentile(double share) const;

 private:
  static constexpr double kStep = 1e-4;
  std::array<std::uint64_t, 1001> counts_{};  ///< the last: more
  std::uint64_t count_ = 0;
  std::uint64_t late_ = 0;
  std::uint64_t too_late_ = 0;
  double worst_s_ = 0.0;
};

}  // namespace lamina
