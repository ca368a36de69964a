// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// A toolpath with the joints that run it, for programs that state them.
struct JointProgram {
  std::unique_ptr<KinematicModel> model;
  Toolpath toolpath;            ///< divided as `runOn` does; of an arm as in `toolpathAsRun`
  JointPath joints;             ///< of it
  std::optional<RunTime> time;  ///< within the limits of the joints; nothing where it cannot be known
};

/// @throws InvalidInput if the job asks for G-code of a robot
void requireProgramFor(const SliceJob& job, const BuildSpace& space);

/// Whether the job writes five-axis G-code: head or table can turn the tool axis, and the toolpath tilts the
/// nozzle off how the head at rest holds it, or `five_axis.use` says so.
bool writesFiveAxis(const SliceJob& job, const BuildSpace& space, const SlicedPart& sliced);

/// Leads the joints of a five-axis machine where it writes five-axis G-code, and those of an arm where it
/// writes RAPID. An arm's program reports joints where `rapid.configuration` asks for them or the arm has
/// external axes: its targets then turn about the tool axis as the joints do. Otherwise the arm is led
/// through the very targets of the toolpath, which are written as they are.
///
/// Where it would run into something the tool axis is raised (`clearance.raise_tool_axis`), which changes the
/// part's toolpath and is noted in its summary; what `clearance.need` asks for is checked.
///
/// @param progress  stages "joints" and "clearance"
/// @throws Unreachable if the machine cannot run it: the first waypoint, and how many; InvalidConfig if
///   `joints.external` is to follow, but the variant of the program cannot report external axes
std::optional<JointProgram> planJointProgram(const SliceJob& job, const BuildSpace& space, SlicedPart& sliced,
                                             Progress& progress);

}  // namespace lamina
