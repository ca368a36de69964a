// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lamina/streaming/job/streamable_program.hpp"
#include "ros/cell/unit_of_nodes.hpp"
#include "ros/loop/streamed_machine.hpp"
#include "ros/ros_home.hpp"

namespace lamina::test {

/// Motions within a square of 100 mm, all of the same extrusion.
inline std::string squareProgram(int motions, double extrusion_mm = 0.05) {
  const std::string extrusion = " E" + std::to_string(extrusion_mm) + "\n";
  std::string text = "M83\nG1 Z0.2 F6000\nG1 X50 Y50 F6000\n";
  for (int i = 0; i < motions; ++i)
    text += "G1 X" + std::to_string(50 + i % 100) + " Y" + std::to_string(50 + (i * 7) % 90) + extrusion;
  return text;
}

inline std::vector<std::string> commandsOf(const std::string& text) {
  std::vector<std::string> commands;
  ProgramCursor cursor = StreamableProgram::fromText("program", text).open();
  while (const auto line = cursor.next()) commands.push_back(line->command);
  return commands;
}

/// A cell in a namespace of its own: machine, streamer and controller, of which the nodes can be killed.
class CellOfNodes : public UnitOfNodes {
 public:
  /// @param parameters  of the controller
  /// @param owner_grace_s  of the streamer
  CellOfNodes(const std::string& name, double speed_up, std::vector<std::string> parameters = {},
              double owner_grace_s = 0.0)
      : UnitOfNodes(name, std::move(parameters)),
        owner_grace_s_(owner_grace_s),
        port_(inRosHome("cell_" + name)),
        machine(speed_up, port_) {
    startStreamer();
    startController();
  }
  ~CellOfNodes() {
    controller.reset();  // before what it commands
  }

  /// @param environment  variables as NAME=value
  void startStreamer(const std::vector<std::string>& environment = {}) {
    streamer =
        start(environment, LAMINA_STREAMER_NODE,
              {"_port:=" + port_, "_stream/journal:=" + progressFile(), "_stream/settle_s:=0.01",
               "_stream/probe_after_s:=0.3", "_executor/owner:=cell_controller",
               "_guard/socket:=" + guardSocket(), "_owner/grace_s:=" + std::to_string(owner_grace_s_)});
  }
  std::string guardSocket() const { return folder.path() + "/streamer.pulse"; }
  std::string progressFile() const { return folder.path() + "/progress"; }

 private:
  double owner_grace_s_;
  std::string port_;

 public:
  StreamedMachine machine;
  std::unique_ptr<NodeProcess> streamer;
};

}  // namespace lamina::test
