// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "lamina/streaming/emulator/emulated_firmware.hpp"
#include "streaming/emulator/simulated_wire.hpp"

namespace lamina::test {

/// A streamer and an emulated Marlin joined by a wire.
class SimulatedLink : public SimulatedWire<EmulatedFirmware> {
 public:
  SimulatedLink(const StreamableProgram& program, const StreamSettings& stream,
                const EmulatedSettings& machine, std::vector<Fault> faults, std::uint64_t seed = 1)
      : SimulatedWire(program, stream, seed, machine, std::move(faults),
                      EmulatedObserver{[this](const ExecutedLine& line) { executed.push_back(line); },
                                       [this](const ExecutedMotion& motion) { motions.push_back(motion); }}) {
  }

  SimulatedLink(StreamOrder order, const EmulatedSettings& machine, std::vector<Fault> faults,
                std::uint64_t seed = 1)
      : SimulatedWire(std::move(order), seed, machine, std::move(faults),
                      EmulatedObserver{[this](const ExecutedLine& line) { executed.push_back(line); },
                                       [this](const ExecutedMotion& motion) { motions.push_back(motion); }}) {
  }

  /// Commands of the numbered lines that were run.
  std::vector<std::string> numberedCommands() const {
    std::vector<std::string> commands;
    for (const ExecutedLine& line : executed) {
      if (line.number && line.command.compare(0, 4, "M110") != 0) commands.push_back(line.command);
    }
    return commands;
  }

  /// Commands of motion that were run without a number: tails of damaged lines.
  std::vector<std::string> fragments() const {
    std::vector<std::string> commands;
    for (const ExecutedLine& line : executed) {
      if (!line.number && line.command.compare(0, 1, "G") == 0) commands.push_back(line.command);
    }
    return commands;
  }

  std::vector<ExecutedLine> executed;
  std::vector<ExecutedMotion> motions;
};

/// A program of `lines` motions on a spiral, each different from every other, extruding.
inline std::string spiralProgram(int lines) {
  std::string text = "; a spiral\nG90\nM82\nG92 E0\nG1 F6000\n";
  for (int i = 0; i < lines - 4; ++i) {
    if (i % 100 == 0) text += ";LAYER:" + std::to_string(i / 100) + "\n";
    text += "G1 X" + std::to_string(100 + (i % 97)) + "." + std::to_string(i % 10) + " Y" +
            std::to_string(i % 89) + " E" + std::to_string(0.01 * i) + "\n";
  }
  return text;
}

/// The commands of a program as they must arrive.
inline std::vector<std::string> commandsOf(const StreamableProgram& program) {
  std::vector<std::string> commands;
  ProgramCursor cursor = program.open();
  while (auto line = cursor.next()) commands.push_back(line->command);
  return commands;
}

}  // namespace lamina::test
