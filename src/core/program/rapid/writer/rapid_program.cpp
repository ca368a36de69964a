// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/rapid/writer/rapid_program.hpp"

#include <optional>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "program/rapid/writer/rapid_lines.hpp"
#include "program/rapid/writer/rapid_module.hpp"
#include "program/rapid/writer/rapid_notes.hpp"

namespace lamina {
namespace {

constexpr std::size_t kPiece = 1U << 16;  // bytes handed on at once

double riseOf(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part) {
  return (bed_from_part.linear() * layerNormal(toolpath)).dot(bed_from_part.translation());
}

}  // namespace

class RapidProgram::State {
 public:
  State(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part, const RapidSettings& settings,
        const RobotMotion* robot)
      : toolpath_(toolpath),
        settings_(checkedRapidSettings(settings)),
        rise_mm_(riseOf(toolpath, bed_from_part)),
        plan_(planRapid(toolpath, settings_)),
        speeds_(plan_.paths, settings_),
        lines_(plan_, speeds_, bed_from_part, settings_) {
    if (robot != nullptr) {
      stations_.emplace(toolpath, bed_from_part, robot->arm, robot->joints);
      lines_.setRobot(robot->arm, *stations_);
      // Refuses what is no arm before anything is written.
      if (settings_.configuration == RapidConfiguration::Joints)
        abbConfiguration(robot->arm, stations_->begin(0));
    } else if (settings_.configuration == RapidConfiguration::Joints) {
      throw InvalidConfig(
          "rapid.configuration is joints, but no joints are known; expected fixed, or a machine that is an "
          "arm");
    }
    nameModules();
    head_.part_name = toolpath.part_name;
    const Eigen::Quaterniond bed_from_part_turn(bed_from_part.linear());
    StatedFrame told;
    told.bed_from_layers = bed_from_part_turn * toolpath.part_from_layers;
    head_.frame_comments = frameComments(told);
    head_.orientation = bed_from_part_turn * plan_.paths.front().path->orientation.at(0);
  }

  const std::vector<std::string>& names() const { return names_; }

  void write(std::size_t module, const TextSink& sink) const {
    if (module == 0) sink(rapidHead(head_, speeds_, settings_));
    const bool is_single = plan_.chunks.size() == 1;
    if (module > 0) sink("MODULE " + names_[module] + "\n");
    if (is_single || module > 0) writeChunk(is_single ? 0 : module - 1, sink);
    sink("ENDMODULE\n");
  }

 private:
  void nameModules() {
    const auto numbered = [](const std::string& name, std::size_t i) {
      return name + "_" + std::to_string(i + 1);
    };
    names_.push_back(settings_.module);
    for (std::size_t i = 0; i < plan_.chunks.size(); ++i)
      head_.procedures.push_back(numbered(settings_.procedure, i));
    if (plan_.chunks.size() == 1) return;
    for (std::size_t i = 0; i < plan_.chunks.size(); ++i) {
      names_.push_back(numbered(settings_.module, i));
      head_.modules.push_back(names_.back());
    }
  }

  void writeChunk(std::size_t index, const TextSink& sink) const {
    const RapidChunk& chunk = plan_.chunks[index];
    std::string text;
    appendRapidNotes(toolpath_, plan_, chunk, rise_mm_, text);
    text += "  PROC " + head_.procedures[index] + "()\n";
    RapidPlace place = chunk.begin;
    for (std::size_t left = chunk.points; left > 0; --left) {
      lines_.append(place, text);
      if (++place.move == plan_.paths[place.path].moveCount()) place = {place.path + 1, 0};
      if (text.size() < kPiece) continue;
      sink(text);
      text.clear();
    }
    sink(text += "  ENDPROC\n");
  }

  const Toolpath& toolpath_;
  RapidSettings settings_;
  double rise_mm_;
  RapidPlan plan_;
  RapidSpeeds speeds_;
  RapidLines lines_;
  std::optional<ProgramStations> stations_;
  RapidHead head_;
  std::vector<std::string> names_;
};

RapidProgram::RapidProgram(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                           const RapidSettings& settings, const RobotMotion* robot)
    : state_(std::make_unique<State>(toolpath, bed_from_part, settings, robot)) {}
RapidProgram::~RapidProgram() = default;
RapidProgram::RapidProgram(RapidProgram&&) noexcept = default;
RapidProgram& RapidProgram::operator=(RapidProgram&&) noexcept = default;

const std::vector<std::string>& RapidProgram::moduleNames() const { return state_->names(); }
void RapidProgram::write(std::size_t module, const TextSink& sink) const { state_->write(module, sink); }

void writeRapid(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                const RapidSettings& settings, const TextSink& sink, const RobotMotion* robot) {
  const RapidProgram program(toolpath, bed_from_part, settings, robot);
  if (program.moduleNames().size() > 1)
    throw InvalidConfig("rapid.max_points is " + std::to_string(settings.max_points) + ", which gives " +
                        std::to_string(program.moduleNames().size()) +
                        " modules; expected a place for each, or a larger number");
  program.write(0, sink);
}

}  // namespace lamina
