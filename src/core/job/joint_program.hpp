// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// A toolpath with the joint values of the machine along it, for programs that state joints.
struct JointProgram {
  std::unique_ptr<KinematicModel> model;
  Toolpath toolpath;            ///< with waypoints inserted as `runOn` does; for an arm as in `toolpathAsRun`
  JointPath joints;             ///< joint path of the toolpath
  std::optional<RunTime> time;  ///< of the run within the limits of the joints; nothing if a limit is unknown
  /// Whether targets in RAPID have to state configurations, whatever `rapid.configuration` is.
  bool needs_configurations = false;
};

/// How the joints of a job's program are planned: `joints.*`, with the rotation about the tool axis held
/// where an arm's program states no joints.
JointPathSettings jointsOf(const SliceJob& job, const KinematicModel& model);

/// Whether a job whose layers are not plane is refused if the machine cannot run them: `clearance.need` asks
/// for it.
bool isRefusedUnlessClear(const SliceJob& job);

/// What may keep a machine from running into something, for people, to follow what it would run into:
/// "; try another machine (machine.name), ...".
/// @param mode  in which the job was sliced
std::string remediesFor(const SliceJob& job, const std::string& mode);

/// Note on a job whose nozzle turns: that collisions of the machine were not checked, and how to check them.
/// Empty if the job is checked before it is written, nothing is written, or `clearance.need` is `never`.
/// @param mode  in which the job was sliced
std::string noteOnUnchecked(const SliceJob& job, const std::string& mode);

/// Adds a note to a part whose time is that of the nozzle's tip alone, though the joints of its machine may
/// need longer: it names the command that tells this time. Machines with linear axes alone get no note.
void addNoteOnTipTime(SlicedPart& sliced, const SliceJob& job, const BuildSpace& space);

/// Refuses a job that asks for G-code of a robot.
/// @throws InvalidInput
void requireProgramFor(const SliceJob& job, const BuildSpace& space);

/// Whether the job writes five-axis G-code: the head or the table can change the tool axis, and either the
/// toolpath tilts the nozzle from its direction in the head at rest, or `five_axis.use` asks for it.
bool writesFiveAxis(const SliceJob& job, const BuildSpace& space, const SlicedPart& sliced);

/// Plans the joints of a five-axis machine that writes five-axis G-code, or of an arm that writes RAPID;
/// nothing for all other jobs. The program of an arm states joints if `rapid.configuration` asks for them or
/// the arm has external axes; its targets then turn about the tool axis as the joints do. Otherwise the
/// joints are planned for the targets of the toolpath, and the targets are written unchanged. By poses alone
/// an arm takes the joints nearest to those before; if it would not get through, the targets state joints
/// too. Where a collision is found, the tool axis is raised (`clearance.raise_tool_axis`), which changes the
/// toolpath in `sliced` and is noted in its summary. What `clearance.need` requires is checked.
/// @param progress  stages "joints" and "clearance"
/// @throws Unreachable if the machine cannot run the toolpath, with the first waypoint and the number of
///   them; if it collides, with what to try (`requireClear`)
/// @throws InvalidConfig if `joints.external` or `joints.rail` is not held, but the dialect of the program
///   cannot state external axes
std::optional<JointProgram> planJointProgram(const SliceJob& job, const BuildSpace& space, SlicedPart& sliced,
                                             Progress& progress);

}  // namespace lamina
