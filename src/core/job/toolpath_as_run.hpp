// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/job/kinematic_model_run.hpp"

namespace lamina {

/// A toolpath and joints whose nozzle is turned about the tool axis as they turn it.
struct ToolpathAsRun {
  Toolpath toolpath;
  JointPath joints;
};

/// The divided toolpath of a run that has no faults, with the orientations that the joints bring about, their
/// signs such that they keep from waypoint to waypoint. A closed path at whose end the nozzle is turned
/// another way than at its beginning becomes an open one that ends where it began.
ToolpathAsRun toolpathAsRun(KinematicModelRun run, const KinematicModel& model);

}  // namespace lamina
