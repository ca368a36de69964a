// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace lamina {

/// Estimates how long a job still runs by what it has done since somebody has begun to look: as fast as so
/// far. Time in which it waits is left out by whoever counts its time.
class TimeLeft {
 public:
  /// @param fraction  of the job that is done, 0 to 1
  /// @param running_s  time that it has run, from any start
  void begin(double fraction, double running_s);

  /// [s]; nothing before one part in two hundred was seen.
  std::optional<double> at(double fraction, double running_s) const;

 private:
  double fraction_ = 0.0;
  double running_s_ = 0.0;
};

}  // namespace lamina
