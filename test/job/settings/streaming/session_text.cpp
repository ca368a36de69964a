// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings/streaming/session_text.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>

#include "lamina/base/error.hpp"
#include "lamina/startup/startup_session.hpp"
#include "lamina/streaming/emulator/emulated_machine.hpp"
#include "lamina/streaming/session/stream_session.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

EmulatedSettings hastyMachine() {
  EmulatedSettings settings;
  settings.speed_up = 1000.0;
  return settings;
}

/// An emulated machine at a pseudo-terminal, and what it has run.
class PluggedIn {
 public:
  explicit PluggedIn(const EmulatedSettings& settings, std::vector<Fault> faults = {})
      : machine_(settings, std::move(faults), {port(), {}},
                 {[this](const ExecutedLine& line) {
                    const std::lock_guard<std::mutex> lock(mutex_);
                    commands_.push_back(line.command);
                  },
                  {}}) {}
  std::string port() const { return folder_.file("machine"); }
  std::vector<std::string> commands() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return commands_;
  }

 private:
  ScratchFolder folder_;
  mutable std::mutex mutex_;
  std::vector<std::string> commands_;
  EmulatedMachine machine_;
};

bool waitFor(double seconds, const std::function<bool()>& is_true) {
  for (int i = 0; i < 200 * seconds && !is_true(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return is_true();
}

StartupSettings sessionWith(const SettingTexts& set, const std::string& sequence) {
  auto settings = settingsWith<StartupSettings>(set);
  settings.sequence = sequence;
  return settings;
}

}  // namespace

std::string lastAfterAbort(const SettingTexts& set) {
  PluggedIn machine(hastyMachine());
  StartupSession session(sessionWith(set, "heat_bed"), {}, {machine.port(), 115200}, {});
  session.run(StartupStep::HeatBed);
  const auto isHeating = [&] {
    const auto commands = machine.commands();
    return std::any_of(commands.begin(), commands.end(),
                       [](const std::string& command) { return command.rfind("M140 S", 0) == 0; });
  };
  if (!waitFor(20.0, isHeating)) return "never heated";
  session.abort();
  if (!waitFor(20.0, [&] { return !session.isBusy(); })) return "never stopped";
  std::string last;
  for (const std::string& command : machine.commands())
    if (command != "M400" && command != "M105" && command.rfind("M110", 0) != 0 && command != "M155 S0")
      last = command;
  return last;
}

std::string looksInASecond(const SettingTexts& set) {
  PluggedIn machine(hastyMachine());
  StartupSession session(sessionWith(set, "home_x"), {}, {machine.port(), 115200}, {});
  session.run(StartupStep::HomeX);
  if (!waitFor(20.0, [&] { return session.steps()[0].state == StartupState::Done && !session.isBusy(); }))
    return "never homed";
  const std::size_t before = machine.commands().size();
  const auto looks = [&] {
    const auto commands = machine.commands();
    return std::count(commands.begin() + static_cast<std::ptrdiff_t>(before), commands.end(), "M105") > 2;
  };
  return waitFor(1.0, looks) ? "often" : "seldom";
}

std::string driedInASecond(const SettingTexts& set) {
  auto settings = sessionWith(set, "dry_pellets");
  settings.check_interval_s = 0.02;
  PluggedIn machine(hastyMachine());
  StartupSession session(settings, {}, {machine.port(), 115200}, {});
  session.confirm(StartupStep::DryPellets);
  return waitFor(1.0, [&] { return session.steps()[0].state == StartupState::Done; }) ? "dry" : "wet";
}

std::string unplugged(const SettingTexts& set) {
  auto emulated = settingsWith<EmulatedSettings>(set);
  emulated.speed_up = 0.0;
  PluggedIn machine(emulated, {{FaultKind::Disconnect, 0.0, {2}}});
  StreamSettings stream;
  stream.safe_stop_timeout_s = 0.5;
  StreamSession session(StreamableProgram::fromText("job", "G1 X1\nG1 X2\nG1 X3\n"), stream,
                        {machine.port(), 115200}, {});
  if (!session.waitFor(20.0)) return "never over";
  return session.status().failure.message;
}

}  // namespace lamina::test
