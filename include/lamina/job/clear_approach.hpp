// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/approach.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// All that an approach is asked.
struct ApproachDemands {
  ApproachSettings way;
  TimingSettings timing;
  ClearanceSettings clearance;
};

/// The approach on which no link runs into the bed or another link: with the lift that is asked, or the first
/// that is clear of twice, four times, ... up to 64 times that and 1 m. Of material that is on the bed
/// already it knows nothing.
/// @throws Unreachable if there is none, naming what the first way runs into; as `approach`; Cancelled
Approach clearApproach(const JointValues& from, const JointValues& to, const KinematicModel& model,
                       const ApproachDemands& demands, Progress& progress);

}  // namespace lamina
