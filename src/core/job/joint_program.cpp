// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/joint_program.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include "job/toolpath_as_run.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"

namespace lamina {
namespace {

constexpr double kHeldToolAxis = 0.01 * M_PI / 180.0;  // rad: as a program of linear axes holds it

bool isGcode(const SliceJob& job) { return std::filesystem::path(job.output).extension() == ".gcode"; }

bool hasExternalAxis(const KinematicModel& arm) { return arm.joints().size() > 6; }

bool tellsJoints(const RapidSettings& settings, const KinematicModel& arm) {
  return settings.variant == RapidVariant::Powder5Axes &&
         (settings.configuration == RapidConfiguration::Joints || hasExternalAxis(arm));
}

/// Offsets from one point report neither how the tool is turned nor where external axes stand.
void requireTold(const JointPathSettings& joints, const RapidSettings& settings, const KinematicModel& arm) {
  if (settings.variant == RapidVariant::Powder5Axes || !hasExternalAxis(arm)) return;
  if (joints.external == ExternalChoice::Follow)
    throw InvalidConfig(std::string("joints.external is follow with rapid.variant ") +
                        toString(settings.variant) + ", which reports external axes at one point only; " +
                        "expected held, or powder_5_axes");
}

KinematicModelRun runnable(const KinematicModel& model, const SlicedPart& sliced,
                           const JointPathSettings& settings, Progress& progress) {
  KinematicModelRun run = runOn(model, sliced.toolpath, sliced.bed_from_part, settings, progress);
  requireRunnable(run, model);
  return run;
}

JointProgram planMachine(std::unique_ptr<KinematicModel> machine, const SliceJob& job,
                         const SlicedPart& sliced, Progress& progress) {
  KinematicModelRun run = runnable(*machine, sliced, job.settings.joints, progress);
  return {std::move(machine), std::move(run.divided.toolpath), std::move(run.path)};
}

std::optional<JointProgram> planArm(std::unique_ptr<KinematicModel> arm, const SliceJob& job,
                                    const SlicedPart& sliced, Progress& progress) {
  const RapidSettings& rapid = job.settings.program.rapid;
  JointPathSettings settings = job.settings.joints;
  requireTold(settings, rapid, *arm);
  const bool is_told = tellsJoints(rapid, *arm);
  if (!is_told) settings.yaw = YawChoice::Held;
  KinematicModelRun run = runnable(*arm, sliced, settings, progress);
  if (!is_told) return std::nullopt;
  ToolpathAsRun as_run = toolpathAsRun(std::move(run), *arm);
  return JointProgram{std::move(arm), std::move(as_run.toolpath), std::move(as_run.joints)};
}

}  // namespace

void requireProgramFor(const SliceJob& job, const CartesianMachine& machine) {
  if (!isGcode(job) || machine.rotary_joints.empty()) return;
  if (kinematicModelFromUrdf(machine.urdf)->toolAxisSpin() == ToolAxisSpin::Given)
    throw InvalidInput("output '" + job.output + "' is G-code, but the machine '" + machine.name +
                       "' is a robot without axes x, y and z; expected .mod or .csv");
}

bool writesFiveAxis(const SliceJob& job, const CartesianMachine& machine, const SlicedPart& sliced) {
  if (!isGcode(job) || machine.rotary_joints.empty()) return false;
  return job.settings.program.five_axis.use == FiveAxisUse::Always ||
         greatestToolAxisTurn(sliced.toolpath, sliced.bed_from_part, machine) > kHeldToolAxis;
}

std::optional<JointProgram> planJointProgram(const SliceJob& job, const CartesianMachine& machine,
                                             const SlicedPart& sliced, Progress& progress) {
  if (writesFiveAxis(job, machine, sliced))
    return planMachine(kinematicModelFromUrdf(machine.urdf), job, sliced, progress);
  if (!isRapidFile(job.output) || machine.rotary_joints.empty()) return std::nullopt;
  std::unique_ptr<KinematicModel> model = kinematicModelFromUrdf(machine.urdf);
  if (!isSixAxisArm(*model)) return std::nullopt;
  return planArm(std::move(model), job, sliced, progress);
}

}  // namespace lamina
