// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/approach.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// What an approach has to meet: its path, its timing, and the clearance of the links.
struct ApproachDemands {
  ApproachSettings way;  ///< lifts and speeds
  TimingSettings timing;
  ClearanceSettings clearance;
};

/// The approach to the start of a job on which no link collides with the bed or with another link. The lift
/// is the requested one or, if links then collide, the first without collision of 2, 4, 8, ... 64 times the
/// requested lift, at most 1 m. Material that already lies on the bed is not considered.
/// @throws Unreachable if links collide at every lift, naming what they collide with at the lowest; as
///   `approach`
/// @throws InvalidConfig if the requested lift is more than 1 m; Cancelled
Approach clearApproach(const JointValues& from, const JointValues& to, const KinematicModel& model,
                       const ApproachDemands& demands, Progress& progress);

}  // namespace lamina
