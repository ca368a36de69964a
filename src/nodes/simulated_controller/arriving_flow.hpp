// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "lamina/deposition/growth_plant.hpp"

namespace lamina {

/// What of a flow that is asked for arrives: after the feeder's dead time, as its lag follows, times its
/// gain. A feeder without any of it gives what is asked for to the last bit.
class ArrivingFlow {
 public:
  /// @param plant  of which gain, dead time and lag count
  explicit ArrivingFlow(PlantSettings plant);

  /// The flow that arrives at a time while another is asked for, which holds until the next call.
  /// @param now_s  not before that of the call before
  double at(double now_s, double asked_mm3_s);

 private:
  struct Asked {
    double since_s = 0.0;
    double flow_mm3_s = 0.0;
  };

  PlantSettings plant_;
  std::deque<Asked> asked_;  ///< as far back as the dead time reaches
  double last_s_ = 0.0;
  double follows_mm3_s_ = 0.0;
};

}  // namespace lamina
