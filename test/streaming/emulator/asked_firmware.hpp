// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lamina/streaming/emulator/emulated_firmware.hpp"

namespace lamina::test {

/// An emulated firmware that is spoken to, and what it ran.
class AskedFirmware : public testing::Test {
 protected:
  void make(const EmulatedSettings& settings, std::vector<Fault> faults = {}) {
    EmulatedObserver observer;
    observer.line = [this](const ExecutedLine& line) { lines_.push_back(line.command); };
    observer.motion = [this](const ExecutedMotion& motion) { motions_.push_back(motion); };
    firmware_ = std::make_unique<EmulatedFirmware>(settings, std::move(faults), observer);
    firmware_->elapse(0.0);
  }
  std::string ask(const std::string& text, double wall_s = 0.0) {
    firmware_->receive(text, wall_s);
    return firmware_->takeOutput();
  }
  /// Lets time pass from deadline to deadline.
  std::string wait(double until_s) {
    while (firmware_->nextDeadline() <= until_s) firmware_->elapse(firmware_->nextDeadline());
    firmware_->elapse(until_s);
    return firmware_->takeOutput();
  }

  std::unique_ptr<EmulatedFirmware> firmware_;
  std::vector<std::string> lines_;
  std::vector<ExecutedMotion> motions_;
};

}  // namespace lamina::test
