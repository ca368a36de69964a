// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lamina {

/// Statistics of repeated delays, in a fixed amount of memory: delays are counted in steps of a tenth of a
/// millisecond up to a tenth of a second; longer ones are counted together.
class Lateness {
 public:
  static constexpr double kLate = 0.01;  ///< [s] delays above this are reported
  /// [s] With delays above this, the process is no longer in step with the motion.
  static constexpr double kTooLate = 0.05;

  /// @param late_s  negative counts as 0
  void add(double late_s);

  std::uint64_t count() const { return count_; }
  std::uint64_t late() const { return late_; }         ///< number of delays above `kLate`
  std::uint64_t tooLate() const { return too_late_; }  ///< number of delays above `kTooLate`
  double worst() const { return worst_s_; }            ///< the greatest delay [s]
  /// The delay that a share of all delays does not exceed [s], rounded up to a tenth of a millisecond. The
  /// greatest delay if that is above a tenth of a second; 0 if there is none.
  double percentile(double share) const;

 private:
  static constexpr double kStep = 1e-4;
  /// Number of delays by step; the last entry counts all longer ones.
  std::array<std::uint64_t, 1001> counts_{};
  std::uint64_t count_ = 0;
  std::uint64_t late_ = 0;
  std::uint64_t too_late_ = 0;
  double worst_s_ = 0.0;
};

}  // namespace lamina
