// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/streaming/session/streamer.hpp"

namespace lamina::test {

/// A streamer and an emulated firmware joined by a wire, in simulated time: nothing sleeps, and the same seed
/// gives the same run. The wire delivers pieces of random length, so that lines arrive cut anywhere.
template <class Firmware>
class SimulatedWire {
 public:
  template <class... Parts>
  SimulatedWire(const StreamableProgram& program, const StreamSettings& stream, std::uint64_t seed,
                Parts&&... of_firmware)
      : streamer(program, stream), firmware(std::forward<Parts>(of_firmware)...), random_(seed) {}
  template <class... Parts>
  SimulatedWire(StreamOrder order, std::uint64_t seed, Parts&&... of_firmware)
      : streamer(std::move(order)), firmware(std::forward<Parts>(of_firmware)...), random_(seed) {}
  virtual ~SimulatedWire() = default;

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
    noteStates();
    if (!firmware.takeDisconnect()) return;
    to_machine_.clear();
    to_host_.clear();
    streamer.disconnect("the cable was pulled", now);
    onDisconnect();
    noteStates();
  }

  double now = 0.0;
  std::vector<PackmlState> states;
  Streamer streamer;
  Firmware firmware;

 protected:
  /// What a person does with the cable.
  virtual void onDisconnect() {}

 private:
  static constexpr double kPieceTime = 1e-4;  // s

  void noteStates() {
    for (const PackmlState state : streamer.takeStateChanges()) states.push_back(state);
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

}  // namespace lamina::test
