// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "file/driven_file.hpp"

#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/job/drivable_toolpath.hpp"

namespace lamina {
namespace {

Placement placementOf(const std::string& name) {
  if (name.empty() || name == "centre") return Placement::Centre;
  if (name == "as_is") return Placement::AsIs;
  throw InvalidInput("placement is '" + name + "'; expected centre or as_is");
}

}  // namespace

MachineToolpath toolpathOfFile(const lamina_msgs::DriveToolpathGoal& goal, const MachineSettings& machine) {
  const BuildSpace space = buildSpaceOf(machine);
  ToolpathOnBed read = readToolpathOnBed(goal.program, placementOf(goal.placement), space);
  MachineToolpath placed;
  placed.machine = space.name;
  placed.bed_from_part = read.bed_from_part;
  placed.id = toolpathId(read.toolpath);
  placed.toolpath = std::move(read.toolpath);
  return placed;
}

void DrivenFile::see(const DriveStatus& status) {
  if (driven_ != nullptr && status.state == PackmlState::Complete) return complete();
  if (driven_ != nullptr)
    count_.see(driven_->originalOf(status.heading_for), driven_->originalOf(status.handed_over_for));
}

void count(const std::optional<DrivenFile>& file, lamina_msgs::MachineState& message) {
  if (!file) return;
  message.lines_total = static_cast<std::uint32_t>(file->count().total());
  message.lines_sent = static_cast<std::uint32_t>(file->count().handedOver());
  message.lines_acknowledged = static_cast<std::uint32_t>(file->count().reached());
}

}  // namespace lamina
