// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "lamina/deposition/growth_plant.hpp"

namespace lamina {

/// The flow that arrives if a flow is requested: delayed by the feeder's dead time and lag, times its gain. A
/// feeder without these deviations delivers exactly the requested flow.
class ArrivingFlow {
 public:
  /// @param plant  its gain, dead time and lag are used
  explicit ArrivingFlow(PlantSettings plant);

  /// The flow that arrives at a time. The flow requested in this call holds until the next call.
  /// @param now_s  not before that of the previous call
  double at(double now_s, double asked_mm3_s);

 private:
  struct Asked {
    double since_s = 0.0;
    double flow_mm3_s = 0.0;
  };

  PlantSettings plant_;
  std::deque<Asked> asked_;  ///< requested flows within the dead time
  double last_s_ = 0.0;
  double follows_mm3_s_ = 0.0;
};

}  // namespace lamina
