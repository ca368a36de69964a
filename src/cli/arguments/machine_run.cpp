// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "machine_run.hpp"

#include <algorithm>

#include "lamina/job/part/placement.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/kinematics/cartesian/machine_settings.hpp"
#include "profile_options.hpp"
#include "toolpath_input.hpp"

namespace lamina::cli {

JobSettings settingsOnMachine(const SettingOptions& given, const std::string& machine) {
  SettingOptions options = given;
  ProfileOptions profiles;
  const std::vector<std::string> names = kinematicModelNames();
  if (std::find(names.begin(), names.end(), machine) != names.end())
    options.assignments.push_back("machine.name=" + machine);
  else
    profiles.machine = machine;
  const LayeredSettings layered = layeredSettingsFrom(profiles, options);
  validate(layered);
  return layered.settings;
}

KinematicModelRun runOfInput(const KinematicModel& model, const std::string& input,
                             const JobSettings& settings, Progress& progress) {
  if (auto stated = readStatedMotion(input, settings.program, model))
    return runAsStated(model, std::move(*stated), settings.joints);
  ToolpathInput read = readInclinedToolpath(input, settings);
  // Programs state where on the bed they stand.
  const bool is_toolpath = !isPart(input) && !isProgramFile(input);
  if (is_toolpath && settings.placement == Placement::Centre)
    read.bed_from_part = placeDeposition(read.toolpath, buildSpaceOf(settings.machine));
  return runOn(model, std::move(read.toolpath), read.bed_from_part, settings.joints, progress);
}

}  // namespace lamina::cli
