// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/streaming/client/streamer.hpp"
#include "lamina/streaming/emulator/grbl/emulated_grbl.hpp"

namespace lamina::test {

/// A streamer and an emulated grbl joined by a wire, in simulated time; as `SimulatedLink`.
class GrblLink {
 public:
  GrblLink(const StreamableProgram& program, const StreamSettings& stream,
           const EmulatedGrblSettings& machine, std::vector<GrblFault> faults)
      : streamer(program, stream),
        grbl(machine, std::move(faults), [this](const std::string& line) { executed.push_back(line); }),
        random_(machine.seed) {}

  void start() {
    streamer.start(now);
    collect();
  }

  /// Runs until the job is over or the simulated time is up.
  void runUntil(double end_s) {
    while (now < end_s && !isFinal(streamer.status().state)) step();
  }
  void run(double most_s = 1e7) {
    start();
    runUntil(most_s);
  }

  /// Delivers what is on the wire, or lets time pass to the next deadline.
  void step() {
    if (to_machine_.empty() && to_host_.empty()) {
      now = std::min(std::max(now, std::min(streamer.nextDeadline(), grbl.nextDeadline())), now + 3600.0);
      streamer.elapse(now);
      grbl.elapse(now);
    } else {
      now += kPieceTime;
      if (!to_machine_.empty()) grbl.receive(takePiece(to_machine_), now);
      if (!to_host_.empty()) streamer.receive(takePiece(to_host_), now);
    }
    collect();
  }

  void collect() {
    to_machine_ += streamer.takeOutput();
    to_host_ += grbl.takeOutput();
    for (const PackmlState state : streamer.takeStateChanges()) states.push_back(state);
    if (!grbl.takeDisconnect()) return;
    to_machine_.clear();
    to_host_.clear();
    streamer.disconnect("the cable was pulled", now);
    streamer.reconnect(now);
    for (const PackmlState state : streamer.takeStateChanges()) states.push_back(state);
  }

  bool isComplete() const { return streamer.status().state == PackmlState::Complete; }
  const std::string& message() const { return streamer.status().failure.message; }

  double now = 0.0;
  std::vector<std::string> executed;
  std::vector<PackmlState> states;
  Streamer streamer;
  EmulatedGrbl grbl;

 private:
  static constexpr double kPieceTime = 1e-4;  // s

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
