// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/passages/passage_check.hpp"

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/passages/run_passages.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/job/run_settings.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/program/rapid/rapid_texts.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "lamina/program/robot/robot_writer.hpp"

namespace lamina {
namespace {

StatedMotion rapidMotionAsWritten(const PlacedToolpath& placed, const RapidSettings& settings) {
  const RobotMotion robot{placed.joints->model, placed.joints->path};
  const RapidProgram program(placed.toolpath, placed.frame.bed_from_part, settings, &robot);
  return readRapidMotion(RapidTexts(program).modules(), placed.toolpath.part_name, robot.arm);
}

/// Nothing if the program is not read back, as with a tool other than that of the arm's description.
std::optional<StatedMotion> motionAsWritten(const std::string& output, const PlacedToolpath& placed,
                                            const ProgramSettings& program) {
  const RobotMotion robot{placed.joints->model, placed.joints->path};
  const std::string name = std::filesystem::path(output).stem().string();
  std::vector<RobotFile> files;
  if (!isRapidFile(output))
    files = robotProgram(placed.toolpath, placed.frame.bed_from_part,
                         {*robotLanguageOf(output), name, program.robot}, &robot);
  try {
    if (isRapidFile(output)) return rapidMotionAsWritten(placed, program.rapid);
    return readRobotMotion(files, placed.toolpath.part_name, robot.arm);
  } catch (const InvalidProgram&) {
    return std::nullopt;
  }
}

void requireClearPassages(const KinematicModelRun& run, const KinematicModel& model,
                          const std::string& output, const ClearanceSettings& settings) {
  const CheckedMachine machine(model);
  const MachineCheck check = checkPassages(run, machine, settings);
  try {
    requireClear(check, model);
  } catch (const Unreachable& refusal) {
    const std::string key = isRapidFile(output) ? "rapid.approach_mm" : "robot_program.approach_mm";
    throw Unreachable(std::string(refusal.what()) + "; try another way back from the part (" + key +
                      "), or another place of it (placement)");
  }
}

}  // namespace

double clearPassageTime(const std::string& output, const PlacedToolpath& placed,
                        const ProgramSettings& program, const JobSettings& settings) {
  if (!placed.joints || !isSixAxisArm(placed.joints->model)) return 0.0;
  std::optional<StatedMotion> motion = motionAsWritten(output, placed, program);
  if (!motion) return 0.0;
  const KinematicModel& model = placed.joints->model;
  const KinematicModelRun run = passagesAsStated(model, *std::move(motion), settings.joints);
  if (settings.clearance.need != ClearanceNeed::Never)
    requireClearPassages(run, model, output, settings.clearance);
  return passageTime(run.passages, model, runSettings(settings).timing);
}

}  // namespace lamina
