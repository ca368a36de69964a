// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// A share of what is planned over time: 1 at first, steady between changes, straight from one value to the
/// next while it changes.
class RampedShare {
 public:
  /// Leads to a share from a time on; what comes before that time stays.
  /// @param ramp_s  in which it would change by 1; 0 for at once
  void lead(double share, double from_s, double ramp_s);

  double at(double time_s) const;

 private:
  struct Corner {
    double time_s = 0.0;
    double share = 1.0;
  };
  std::vector<Corner> corners_;  ///< in order of time; of two at one time the later one holds from then on
};

}  // namespace lamina
