// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

namespace lamina {

/// How long a job still takes.
struct LeftEstimate {
  double seconds = 0.0;
  double least_s = 0.0;
  double most_s = 0.0;
};

/// Estimates what is left of a job from how fast its lines went: over all of it, and over the last five
/// minutes. The estimate lies between the two, its uncertainty spans both and a tenth more, and
/// half of it in the first seconds. Programs whose layers take longer and longer are estimated too short at
/// first.
class TimeLeft {
 public:
  /// @param job  0 for none: another job begins anew
  /// @param fraction  of its lines, 0 to 1
  void observe(double now_s, long long job, double fraction);
  /// The unit does not run: this time does not count.
  void pause(double now_s);

  /// Nothing before 1 % or 5 s of running.
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
