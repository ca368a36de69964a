// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "calibrate/calibrated_cell.hpp"

#include <chrono>
#include <filesystem>

#include "arguments/profile_options.hpp"
#include "lamina/base/child_process.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/base/text.hpp"
#include "lamina/base/utc_time.hpp"

namespace lamina::cli {
namespace {

bool isBag(const std::string& path) { return std::filesystem::path(path).extension() == ".bag"; }

SensorRecording recordingOfBag(const std::string& bag) {
  const ScratchFolder folder;
  const ProgramEnd end =
      runProgram({{siblingProgram("lamina-bag-tables"), bag, "-o", folder.path()}, "", 3600.0}, NoProgress());
  if (end.exit_code != 0)
    throw InvalidInput(end.errors.empty() ? "lamina-bag-tables failed on '" + bag + "'"
                                          : std::string(trimmed(end.errors)));
  return readRecording(folder.path());
}

void requireMachine(const MachineSettings& found, const MachineSettings& named, const std::string& typed) {
  if (found.name == named.name && found.urdf == named.urdf) return;
  throw InvalidConfig("the settings name the machine '" + (found.urdf.empty() ? found.name : found.urdf) +
                      "', and --machine is '" + typed + "'; expected one of them, or the same");
}

}  // namespace

void addCalibratedMachine(CLI::App& subcommand, CalibrateArguments& arguments) {
  subcommand.add_option("--machine", arguments.machine,
                        "Machine that is calibrated: a profile (lamina profiles), one of machine.name, or a "
                        "file (.yaml, .urdf)");
  addSettingOptions(subcommand, arguments.settings, "Settings (YAML) of calibration, machine and program");
}

void addCalibrateOptions(CLI::App& subcommand, CalibrateArguments& arguments) {
  subcommand
      .add_option("recording", arguments.recording,
                  "Folder with poses.csv and profiles.csv, or a bag with tf and profile")
      ->required();
  subcommand.add_option("-o,--output", arguments.cell,
                        "Calibration file (YAML) to write; what it holds already is used, and stays");
  subcommand.add_option("--sensor", arguments.sensor, "Name or serial number of the sensor");
  addCalibratedMachine(subcommand, arguments);
}

CalibrateSettings calibrateSettingsFrom(const CalibrateArguments& arguments) {
  CalibrateSettings settings;
  MachineSettings named;
  if (!arguments.machine.empty()) {
    ProfileOptions profiles;
    profiles.machine = arguments.machine;
    const JobSettings of_machine = layeredSettingsFrom(profiles, {}).settings;
    settings.machine = named = of_machine.machine;
    settings.program = of_machine.program;
  }
  SettingsSchema schema;
  describe(schema, settings.machine, "Machine that is calibrated.");
  describe(schema, settings.calibration);
  describe(schema, settings.flow_trial);
  describe(schema, settings.program);
  applySettings(schema, arguments.settings.config, overridesFrom(arguments.settings.assignments));
  if (!arguments.machine.empty()) requireMachine(settings.machine, named, arguments.machine);
  return settings;
}

SensorRecording recordingFrom(const std::string& path) {
  return isBag(path) ? recordingOfBag(path) : readRecording(path);
}

Calibration cellSoFar(const CalibrateArguments& arguments, const MachineSettings& machine) {
  Calibration cell;
  const std::string name = buildSpaceOf(machine).name;
  cell.machine = name;
  if (!arguments.cell.empty() && std::filesystem::exists(arguments.cell))
    cell = readCalibration(arguments.cell);
  requireCalibrationOf(cell, name);
  if (!arguments.sensor.empty()) cell.sensor = arguments.sensor;
  return cell;
}

Eigen::Isometry3d knownSensorPose(const Calibration& cell, const MachineSettings& machine) {
  if (cell.pose) return cell.pose->nozzle_from_sensor;
  const BuildSpace space = buildSpaceOf(machine);
  if (!space.tip_from_sensor)
    throw InvalidConfig("machine '" + space.name + "' has no sensor; expected a link 'sensor' in its URDF");
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();
  bed_from_nozzle.linear() = space.bed_from_nozzle;
  return bed_from_nozzle.inverse() * *space.tip_from_sensor;
}

CalibrationOrigin foundNow(const std::string& method) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {method, utcText(std::chrono::duration_cast<std::chrono::seconds>(now).count())};
}

void keepCell(const CalibrateArguments& arguments, const Calibration& cell) {
  if (!arguments.cell.empty()) writeCalibration(arguments.cell, cell);
}

}  // namespace lamina::cli
