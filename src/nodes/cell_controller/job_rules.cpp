// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job_rules.hpp"

#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/job/drivable_toolpath.hpp"
#include "lamina/job/program_check.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {
namespace {

/// Layers of a program, by what its comments say; 0 if they say nothing.
std::int32_t layersOf(const StreamableProgram& program) {
  ProgramCursor cursor = program.open();
  while (cursor.next()) {
  }
  return cursor.layer() + 1;
}

/// The driver has its own figures. What is refused by these, as drops and empty toolpaths are, no driver
/// takes.
TimingSettings ofAnyDriver() {
  TimingSettings timing;
  timing.trajectory.line_tolerance_mm = 10.0;
  timing.trajectory.line_tolerance_deg = 45.0;
  return timing;
}

KinematicModelRun checkedRun(ToolpathOnBed placed, const CheckedMachine& machine,
                             const DriveCheckSettings& settings, Progress& progress) {
  if (settings.clearance.need != ClearanceNeed::Never)
    return drivableRun(
        std::move(placed), machine, settings, [](const MachineCheck&) {}, progress);
  requireDrivable(placed.toolpath);
  return runOn(machine, std::move(placed.toolpath), placed.bed_from_part, settings.joints, progress);
}

std::int32_t checkedToolpath(const std::string& path, const CellControllerSettings& settings,
                             Progress& progress) {
  const auto model = kinematicModelOf(settings.machine);
  ToolpathOnBed placed = readToolpathOnBed(path, settings.placement, buildSpaceOf(settings.machine));
  const auto layers = static_cast<std::int32_t>(placed.toolpath.layers.size());
  KinematicModelRun run = checkedRun(std::move(placed), CheckedMachine(*model), settings.drive, progress);
  inTime(std::move(run), *model, ofAnyDriver());
  return layers;
}

std::int32_t checkedFile(const std::string& path, const CellControllerSettings& settings,
                         Progress& progress) {
  if (settings.executor == ExecutorKind::Driver) return checkedToolpath(path, settings, progress);
  requirePrintable(path, settings.machine);
  return layersOf(StreamableProgram::fromFile(path));
}

}  // namespace

std::int32_t checkedLayers(const std::string& path, const std::string& name,
                           const CellControllerSettings& settings, Progress& progress) {
  try {
    return checkedFile(path, settings, progress);
  } catch (const Error&) {
    Failure failure = currentFailure();
    for (std::size_t at = 0; (at = failure.message.find(path, at)) != std::string::npos; at += name.size())
      failure.message.replace(at, path.size(), name);
    throwFailure(failure);
  }
}

std::string jobSheet(const CellControllerSettings& settings) {
  std::string sheet = machineSheet(settings.machine);
  if (settings.executor == ExecutorKind::Stream) return sheet;
  return sheet + "executor: trajectory_driver\nplacement: " +
         (settings.placement == Placement::AsIs ? "as_is" : "centre") + '\n';
}

}  // namespace lamina
