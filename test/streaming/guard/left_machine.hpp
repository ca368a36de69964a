// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "lamina/base/clock.hpp"
#include "lamina/streaming/emulator/emulated_machine.hpp"
#include "lamina/streaming/guard/machine_pulse.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {

inline std::string inTemporary(const std::string& name) {
  static const ScratchFolder folder;
  return folder.file(name);
}

/// Waits until it is so, or for far longer than it should take.
template <class Condition>
bool comesTrue(Condition condition) {
  const SteadyClock clock;
  for (const double until_s = clock.now() + 120.0; clock.now() < until_s;) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return false;
}

/// An emulated machine that somebody has left hot, and what it has run.
class LeftMachine {
 public:
  explicit LeftMachine(const std::string& name, EmulatedSettings settings = {}) {
    settings.speed_up = 0.0;
    EmulatedObserver observer;
    observer.line = [this](const ExecutedLine& line) {
      const std::lock_guard<std::mutex> lock(mutex_);
      ran_ += line.command + '\n';
    };
    machine_ = std::make_unique<EmulatedMachine>(settings, std::vector<Fault>{},
                                                 EmulatedPorts{inTemporary(name), {}}, observer);
  }

  /// Sets nozzle and bed to 200 and 60, as whoever has the port does.
  /// @param first  commands that are run before
  void heat(const std::string& first = "") const {
    const int port = ::open(machine_->pty().c_str(), O_RDWR | O_NOCTTY);
    ASSERT_GE(port, 0);
    const std::string heat = first + "M104 S200\nM140 S60\n";
    ASSERT_EQ(::write(port, heat.data(), heat.size()), static_cast<ssize_t>(heat.size()));
    EXPECT_TRUE(
        comesTrue([this] { return machine_->nozzleTarget() == 200.0 && machine_->bedTarget() == 60.0; }));
    ::close(port);
  }

  MachinePulse pulse() const { return {true, {machine_->pty(), 115200}, "marlin", "", false}; }
  std::string ran() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ran_;
  }
  const EmulatedMachine* operator->() const { return machine_.get(); }

 private:
  mutable std::mutex mutex_;
  std::string ran_;
  std::unique_ptr<EmulatedMachine> machine_;
};

}  // namespace lamina::test
