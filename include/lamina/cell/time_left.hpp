// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

namespace lamina {

/// The time that a job still takes, and its bounds.
struct LeftEstimate {
  double seconds = 0.0;
  double least_s = 0.0;
  double most_s = 0.0;
};

/// Estimates the rest of a job from the rate at which its lines were executed: over the whole job, and over
/// the last five minutes. The estimate is the mean of both. Its bounds are the lesser of the two less 10 %
/// and the greater plus 10 %; in the first seconds up to 50 %. If layers take longer and longer, the first
/// estimates are too short.
class TimeLeft {
 public:
  /// States the progress of a job that runs.
  /// @param job       number of the job; a change of number restarts the estimate; 0 for none
  /// @param fraction  share of its lines that are done, 0 to 1
  void observe(double now_s, long long job, double fraction);
  /// States that the unit does not run: this time does not count.
  void pause(double now_s);

  /// The estimate; nothing before 1 % of the job and 5 s of running, or if there was no progress lately.
  std::optional<LeftEstimate> estimate() const;

 private:
  struct Sample {
    double running_s = 0.0;
    double fraction = 0.0;
  };
  long long job_ = 0;
  std::optional<double> last_s_;
  double running_s_ = 0.0;
  double first_fraction_ = 0.0;
  std::deque<Sample> recent_;
};

}  // namespace lamina
