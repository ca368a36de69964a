// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "lamina/toolpath/process_signals.hpp"

namespace lamina {

/// Signals of the process at a time; linear from one entry to the next.
struct PlannedProcess {
  double time_s = 0.0;
  ProcessSignals signals;
};

/// A piece of the planned process.
struct ProcessChunk {
  std::vector<PlannedProcess> points;  ///< in order of time
  double valid_until_s = 0.0;          ///< time after which the chunk states nothing
};

/// The planned process over absolute time, as far as it is known. A chunk replaces, from its first point on,
/// what was planned before. Between the end of one chunk and the begin of the next nothing is known. A chunk
/// is valid for at most `kLongestHold` behind its last point, whatever it states: after that its values are
/// merely held, and their sender may be gone.
class ProcessPlan {
 public:
  static constexpr double kMeet = 1e-3;        ///< [s] chunks with at most this time between them adjoin
  static constexpr double kLongestHold = 0.5;  ///< [s] behind the last point of a chunk
  static constexpr std::size_t kMostPoints = 200000;  ///< number of points that are kept

  /// @throws InvalidInput if there is no point, times are not finite or not in order, a flow or level is
  ///   negative or infinite, a flow no number, or there are too many points; then nothing changes
  void accept(const ProcessChunk& chunk);

  /// The signals planned for a time; nothing if they are not known. In logarithmic time.
  std::optional<ProcessSignals> at(double time_s) const;

  /// End of the last chunk [s], as far as it is valid; -infinity if there is none.
  double validUntil() const { return valid_until_s_; }

  /// Drops all points before a time.
  void forget(double time_s);

 private:
  struct Point {
    double time_s = 0.0;
    std::optional<ProcessSignals> signals;  ///< nothing if the signals are unknown until the next point
  };
  std::deque<Point> points_;
  double valid_until_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace lamina
