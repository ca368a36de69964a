// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <string>

#include "lamina/base/random.hpp"
#include "lamina/streaming/session/streamer.hpp"
#include "streaming/emulator/ok_paced/emulated_paced_firmware.hpp"

namespace lamina::test {

/// A streamer and firmware paced by ok, joined by a wire in simulated time that flips bits and loses bytes.
class PacedLink {
 public:
  PacedLink(Streamer& streamer, EmulatedPacedFirmware& firmware, double noise = 0.0, std::uint64_t seed = 1)
      : streamer_(streamer), firmware_(firmware), noise_(noise), random_(seed) {
    if (noise_ > 0.0) next_fault_ = gap();
  }

  /// Until the job is over, or `is_enough` says so.
  void run(const std::function<bool()>& is_enough = [] { return false; }) {
    if (streamer_.status().state == PackmlState::Idle) streamer_.start(now);
    while (!isFinal(streamer_.status().state) && !is_enough()) step();
  }

  void step() {
    const std::string down = streamer_.takeOutput();
    const std::string up = firmware_.takeOutput();
    if (down.empty() && up.empty()) {
      now = std::max(now, std::min(streamer_.nextDeadline(), firmware_.nextDeadline()));
      streamer_.elapse(now);
      firmware_.elapse(now);
    } else {
      now += 1e-4;
      if (!down.empty()) firmware_.receive(noisy(down), now);
      if (!up.empty()) streamer_.receive(noisy(up), now);
    }
    if (firmware_.takeDisconnect()) streamer_.disconnect("the cable was pulled", now);
  }

  double now = 0.0;

 private:
  std::uint64_t gap() { return random_.below(static_cast<std::uint64_t>(2.0 / noise_)); }

  std::string noisy(std::string bytes) {
    if (noise_ == 0.0) return bytes;
    std::size_t at = 0;
    while (bytes.size() - at > next_fault_) {
      at += next_fault_;
      if (random_.below(4) == 0) {
        bytes.erase(at, 1);
      } else {
        bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << random_.below(8)));
        ++at;
      }
      next_fault_ = gap();
    }
    next_fault_ -= bytes.size() - at;
    return bytes;
  }

  Streamer& streamer_;
  EmulatedPacedFirmware& firmware_;
  double noise_;
  Random random_;
  std::uint64_t next_fault_ = 0;
};

}  // namespace lamina::test
