// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "machine_run.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "lamina/base/text.hpp"
#include "lamina/job/part/placement.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/planning/tools/tool_settings.hpp"
#include "profile_options.hpp"
#include "toolpath_input.hpp"

namespace lamina::cli {

namespace {

/// @throws InvalidConfig if a program in a robot's language is to be checked on the gantry, which nobody
/// chose
void requireRobot(const std::string& input, const MachineSettings& machine) {
  const std::string suffix = smallSuffix(input);
  constexpr std::array<std::string_view, 4> kOfRobots = {".src", ".script", ".ls", ".jbi"};
  const bool is_chosen = !machine.urdf.empty() || machine.name != MachineSettings().name;
  if (is_chosen || std::find(kOfRobots.begin(), kOfRobots.end(), suffix) == kOfRobots.end()) return;
  throw InvalidConfig(
      "'" + input + "' is the program of a robot, and the machine is " + machine.name +
      "; expected the robot: --machine with a name, a profile, a cell file (.yaml) or a description (.urdf)");
}

}  // namespace

void addMachineRun(CLI::App& subcommand, MachineRunArguments& arguments) {
  subcommand
      .add_option(
          "input", arguments.input,
          "Toolpath (.csv), program (.gcode, .mod, .src, .script, .ls, .jbi), mesh file or name of a part")
      ->required();
  subcommand.add_option(
      "--machine", arguments.machine,
      "Machine that runs it: a profile (lamina profiles), one of machine.name, or a file (.yaml, .urdf)");
}

JobSettings settingsOnMachine(const SettingOptions& given, const MachineRunArguments& run) {
  SettingOptions options = given;
  const std::string& machine = run.machine;
  ProfileOptions profiles;
  const std::vector<std::string> names = kinematicModelNames();
  if (std::find(names.begin(), names.end(), machine) != names.end())
    options.assignments.push_back("machine.name=" + machine);
  else
    profiles.machine = machine;
  const LayeredSettings layered = layeredSettingsFrom(profiles, options);
  validate(layered);
  requireRobot(run.input, layered.settings.machine);
  return layered.settings;
}

KinematicModelRun runOfInput(const CheckedMachine& machine, const std::string& input,
                             const JobSettings& settings, Progress& progress) {
  if (auto stated = readStatedMotion(input, settings.program, machine.model()))
    return runAsStated(machine.model(), std::move(*stated), settings.joints);
  ToolpathInput read = readInclinedToolpath(input, settings);
  // Programs state where on the bed they stand.
  const bool is_toolpath = !isPart(input) && !isProgramFile(input);
  if (is_toolpath && settings.placement == Placement::Centre)
    read.bed_from_part = placeDeposition(read.toolpath, buildSpaceOf(settings.machine));
  JointPathSettings joints = settings.joints;
  // A program was read with the offsets of its own header: by others its carriage would stand elsewhere.
  joints.tool_offsets_mm = isProgramFile(input) ? toolOffsetsIn(input) : toolOffsets(settings.planning.tools);
  return runOn(machine, std::move(read.toolpath), read.bed_from_part, joints, progress);
}

}  // namespace lamina::cli
