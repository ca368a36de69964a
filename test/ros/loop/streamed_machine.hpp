// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "lamina/streaming/emulator/emulated_machine.hpp"

namespace lamina::test {

/// An emulated machine at a port, and what it has run of programs.
class StreamedMachine {
 public:
  StreamedMachine(double speed_up, const std::string& port, const std::vector<std::string>& faults = {}) {
    EmulatedSettings settings;
    settings.speed_up = speed_up;
    settings.fault_delay_s = 0.05;
    settings.fault_silence_s = 0.2;
    settings.nozzle_heating_c_s = 1000.0;
    std::vector<Fault> parsed;
    for (const std::string& fault : faults) parsed.push_back(faultFromText(fault));
    EmulatedObserver observer;
    observer.line = [this](const ExecutedLine& line) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (line.number && line.command.compare(0, 4, "M110") != 0) commands_.push_back(line.command);
    };
    machine_ = std::make_unique<EmulatedMachine>(settings, parsed, EmulatedPorts{port, {}}, observer);
  }
  std::vector<std::string> commands() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return commands_;
  }
  const EmulatedMachine& operator*() const { return *machine_; }
  const EmulatedMachine* operator->() const { return machine_.get(); }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> commands_;
  std::unique_ptr<EmulatedMachine> machine_;
};

}  // namespace lamina::test
