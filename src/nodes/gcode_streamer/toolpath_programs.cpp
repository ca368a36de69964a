// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "toolpath_programs.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {

ToolpathPrograms::ToolpathPrograms(const CartesianMachine& machine, const GcodeStreamerSettings& settings)
    : machine_(machine), settings_(settings) {}

StreamableProgram ToolpathPrograms::written(const MachineToolpath& placed,
                                            const ProgramSettings& settings) const {
  requireRunsOn(placed, machine_);
  std::string text;
  ProgramFrame frame(placed.bed_from_part);
  frame.program_from_bed = programFromBed(machine_);
  writeInDialect(placed.toolpath, frame, settings, [&](std::string_view piece) { text += piece; });
  return StreamableProgram::fromText("toolpath " + placed.id, std::move(text), settings_.stream);
}

StreamableProgram ToolpathPrograms::programOf(const MachineToolpath& placed) const {
  return written(placed, settings_.program);
}

PlannedProgram ToolpathPrograms::programOf(const MachineToolpath& plan, const LayerCorrector& present,
                                           std::size_t layer) const {
  const StreamableProgram program =
      written(plan, settingsToGoOn(settings_.program, present.toolpath(), layer));
  StreamCorrectionSettings corrections = settings_.corrections;
  if (!corrections.folder.empty()) corrections.folder += "/" + plan.id;
  PlannedProgram planned{program,
                         std::make_shared<LayerCorrector>(
                             program, ProgrammedToolpath{plan.id, placed(plan.toolpath, plan.bed_from_part)},
                             corrections, FirstMap::Awaited)};
  planned.corrector->beginRecord();
  return planned;
}

std::shared_ptr<CorrectedStream> ToolpathPrograms::corrected(const StreamableProgram& program,
                                                             const MachineToolpath& planned) const {
  const Eigen::Affine3d program_from_bed = programFromBed(machine_);
  if (!program_from_bed.isApprox(Eigen::Affine3d::Identity()))
    throw InvalidConfig(
        "corrections.use is set for " + machine_.name +
        ", whose programs are in values of its axes; expected a machine whose programs are in "
        "coordinates of the bed");
  return std::make_shared<CorrectedStream>(
      std::make_shared<LayerCorrector>(
          program, ProgrammedToolpath{planned.id, placed(planned.toolpath, planned.bed_from_part)},
          settings_.corrections),
      settings_.corrections.follows_plans ? CorrectedStream::Plans::Followed
                                          : CorrectedStream::Plans::Refused);
}

}  // namespace lamina
