// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/streaming/client/streamer.hpp"
#include "lamina/streaming/emulator/emulated_firmware.hpp"

namespace lamina::test {

/// A streamer and an emulated firmware joined by a wire, in simulated time: nothing sleeps, and the same seed
/// gives the same run. The wire delivers pieces of random length, so that lines arrive cut anywhere.
class SimulatedLink {
 public:
  SimulatedLink(const StreamableProgram& program, const StreamSettings& stream,
                const EmulatedSettings& machine, std::vector<Fault> faults, std::uint64_t seed = 1)
      : streamer(program, stream), firmware(machine, std::move(faults), observer()), random_(seed) {}

  void start() {
    streamer.start(now);
    collect();
  }

  /// Runs until the job is over or the simulated time is up.
  void runUntil(double end_s) {
    while (now < end_s && !isFinal(streamer.status().state)) step();
  }
  void run(double most_s = 1e6) {
    start();
    runUntil(most_s);
  }

  /// Delivers what is on the wire, or lets time pass to the next deadline.
  void step() {
    if (to_machine_.empty() && to_host_.empty()) {
      now = std::min(std::max(now, std::min(streamer.nextDeadline(), firmware.nextDeadline())), now + 3600.0);
      streamer.elapse(now);
      firmware.elapse(now);
    } else {
      now += kPieceTime;
      if (!to_machine_.empty()) firmware.receive(takePiece(to_machine_), now);
      if (!to_host_.empty()) streamer.receive(takePiece(to_host_), now);
    }
    collect();
  }

  void collect() {
    to_machine_ += streamer.takeOutput();
    to_host_ += firmware.takeOutput();
    for (const PackmlState state : streamer.takeStateChanges()) states.push_back(state);
    if (!firmware.takeDisconnect()) return;
    to_machine_.clear();
    to_host_.clear();
    streamer.disconnect("the cable was pulled", now);
    for (const PackmlState state : streamer.takeStateChanges()) states.push_back(state);
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

  double now = 0.0;
  std::vector<ExecutedLine> executed;
  std::vector<ExecutedMotion> motions;
  std::vector<PackmlState> states;
  Streamer streamer;
  EmulatedFirmware firmware;

 private:
  static constexpr double kPieceTime = 1e-4;  // s

  EmulatedObserver observer() {
    return {[this](const ExecutedLine& line) { executed.push_back(line); },
            [this](const ExecutedMotion& motion) { motions.push_back(motion); }};
  }

  std::string takePiece(std::string& wire) {
    const std::size_t size = std::min<std::size_t>(wire.size(), 1 + random_.below(60));
    std::string piece = wire.substr(0, size);
    wire.erase(0, size);
    return piece;
  }

  Random random_;
  std::string to_machine_;
  std::string to_host_;
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
