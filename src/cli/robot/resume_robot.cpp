// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/resume_robot.hpp"

#include <Eigen/Geometry>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "arguments/machine_run.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/program/rapid/rapid_texts.hpp"
#include "lamina/program/remaining_motion.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "lamina/program/robot/robot_writer.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina::cli {
namespace {

WaypointIndex startOf(const RobotResume& resume, const StatedMotion& motion) {
  if (resume.line) return waypointAtLine(motion, {static_cast<std::size_t>(*resume.line), resume.file});
  if (resume.height_mm) return waypointAtHeight(motion, *resume.height_mm);
  if (!resume.layer)
    throw InvalidInput("where to go on is not given; expected --from-line, --from-layer or --from-height");
  if (*resume.layer < 0)
    throw InvalidInput("--from-layer is " + std::to_string(*resume.layer) + "; expected 0 or more");
  return waypointOfLayer(motion, static_cast<std::size_t>(*resume.layer));
}

void requireSameLanguage(const RobotResume& resume) {
  const std::string suffix = std::filesystem::path(resume.program).extension().string();
  if (std::filesystem::path(resume.output).extension() != suffix)
    throw InvalidInput("the program is " + resume.program + ", the output '" + resume.output +
                       "'; expected a file for the rest with the suffix " + suffix);
  requireApart({resume.output}, {resume.program, resume.settings.config});
}

StatedEquipment equipmentOfRapid(const StatedMotion& rest, const KinematicModel& model,
                                 const RapidSettings& settings) {
  const RobotMotion robot{model, rest.joints};
  const RapidProgram program(rest.toolpath, Eigen::Isometry3d::Identity(), settings, &robot);
  return readEquippedRapid(RapidTexts(program).modules(), "rest").equipment;
}

StatedEquipment equipmentInLanguage(const RobotResume& resume, const StatedMotion& rest,
                                    const KinematicModel& model, const RobotProgramSettings& settings) {
  const RobotMotion robot{model, rest.joints};
  const std::string name = std::filesystem::path(resume.output).stem().string();
  const RobotProgramRequest request{*robotLanguageOf(resume.output), name, settings};
  return readEquippedRobotProgram(robotProgram(rest.toolpath, Eigen::Isometry3d::Identity(), request, &robot),
                                  name)
      .equipment;
}

/// The process and the bed of the program are those that the settings write; external axes are of the joints.
void requireOwnEquipment(const RobotResume& resume, const StatedMotion& rest, const KinematicModel& model,
                         const ProgramSettings& settings) {
  const bool is_rapid = isRapidFile(resume.program);
  const StatedEquipment read = is_rapid ? readEquippedRapidFile(resume.program).equipment
                                        : readEquippedRobotProgramFile(resume.program).equipment;
  StatedEquipment written = is_rapid ? equipmentOfRapid(rest, model, settings.rapid)
                                     : equipmentInLanguage(resume, rest, model, settings.robot);
  written.external = read.external;
  written.moves_external = read.moves_external;
  requireSameEquipment(read, written, resume.program, is_rapid ? "rapid.*" : "robot_program.*");
}

std::vector<std::string> write(const RobotResume& resume, const StatedMotion& rest,
                               const KinematicModel& model, const ProgramSettings& settings) {
  const PlacedToolpath placed{rest.toolpath, ProgramFrame(Eigen::Isometry3d::Identity()),
                              ProgramJoints{model, rest.joints}};
  if (isRapidFile(resume.output)) return writeRapidFiles(resume.output, placed, rapidWithLoad(settings));
  return writeRobotFiles(resume.output, placed, settings.robot).files;
}

std::vector<std::string> conditions(const WaypointIndex& from, const StatedMotion& rest) {
  const Path& first = rest.toolpath.layers.front().paths.front();
  char point[96];
  std::snprintf(point, sizeof point, "%.3f %.3f %.3f", first.points.front().x(), first.points.front().y(),
                first.points.front().z());
  return {"the part stands on the bed where it stood, and ends at " + toText(from),
          "the way is free for the move of the joints with which the rest begins, away from the part",
          "tool, frame of the bed and load on the controller are those of the program",
          "the process is ready, and starts at " + std::string(point) + " mm over the bed",
          "lamina check finds nothing in the rest"};
}

void print(const RobotResume& resume, const std::vector<std::string>& files,
           const std::pair<WaypointIndex, std::vector<std::string>>& from, OutputFormat format) {
  const auto& [at, to_check] = from;
  if (format == OutputFormat::Json) {
    const nlohmann::ordered_json json = {{"from_layer", at.layer},
                                         {"from_path", at.path},
                                         {"from_waypoint", at.waypoint},
                                         {"files", files},
                                         {"to_check", to_check}};
    std::printf("%s\n", json.dump().c_str());
    return;
  }
  std::printf("%s: from %s of %s. Run it only if:\n", resume.output.c_str(), toText(at).c_str(),
              resume.program.c_str());
  for (const std::string& each : to_check) std::printf("- %s\n", each.c_str());
}

}  // namespace

void resumeRobot(const RobotResume& resume, OutputFormat format) {
  requireSameLanguage(resume);
  const JobSettings settings = settingsOnMachine(resume.settings, {resume.program, resume.machine});
  const auto model = kinematicModelOf(settings.machine);
  const auto motion = readStatedMotion(resume.program, settings.program, *model);
  if (!motion)
    throw InvalidConfig("'" + resume.program + "' is the program of a robot, and '" + model->name() +
                        "' is no arm with six joints; expected the robot: --machine");
  const WaypointIndex from = startOf(resume, *motion);
  const StatedMotion rest = remainingMotion(*motion, from);
  requireOwnEquipment(resume, rest, *model, settings.program);
  const std::vector<std::string> files = write(resume, rest, *model, settings.program);
  print(resume, files, {from, conditions(from, rest)}, format);
}

}  // namespace lamina::cli
