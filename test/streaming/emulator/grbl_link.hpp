// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lamina/streaming/emulator/grbl/emulated_grbl.hpp"
#include "streaming/emulator/simulated_wire.hpp"

namespace lamina::test {

/// Of a job on a grbl whose link changes no byte.
inline StreamSettings reliableGrbl() {
  StreamSettings settings;
  settings.firmware = "grbl";
  settings.link = LinkKind::Reliable;
  return settings;
}

/// A streamer and an emulated grbl joined by a wire. A cable that was pulled is plugged in again.
class GrblLink : public SimulatedWire<EmulatedGrbl> {
 public:
  GrblLink(const StreamableProgram& program, const StreamSettings& stream,
           const EmulatedGrblSettings& machine, std::vector<GrblFault> faults)
      : SimulatedWire(program, stream, machine.seed, machine, std::move(faults),
                      [this](const std::string& line) { executed.push_back(line); }) {}

  bool isComplete() const { return streamer.status().state == PackmlState::Complete; }
  const std::string& message() const { return streamer.status().failure.message; }

  std::vector<std::string> executed;

 private:
  void onDisconnect() override { streamer.reconnect(now); }
};

/// A program of `lines` short motions, none like another, from a place that is set to one that is known.
inline std::string millProgram(int lines) {
  std::string text = "G21\nG90\nG1 F6000\n";
  for (int i = 0; i < lines - 3; ++i) {
    if (i % 100 == 0) text += ";LAYER:" + std::to_string(i / 100) + "\n";
    text += "G1 X" + std::to_string(10 + (i % 97)) + "." + std::to_string(i % 10) + " Y" +
            std::to_string(i % 89) + " Z" + std::to_string(i % 7) + "\n";
  }
  return text;
}

}  // namespace lamina::test
