// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/guard/machine_stop.hpp"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/streaming/firmware/grbl/grbl_firmware.hpp"
#include "lamina/streaming/transport/transport.hpp"
#include "streaming/firmware/marlin/stop_commands.hpp"
#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"
#include "streaming/job/used_outputs.hpp"

namespace lamina {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPoll{2};
constexpr milliseconds kLongestSending{1000};
constexpr milliseconds kLongestBusy{500};  // of a port whose process has ended
constexpr milliseconds kAnswers{100};      // to what has no number: none is taken for that of a line
constexpr milliseconds kSlowDown{1000};    // of grbl's axes before it is reset
constexpr milliseconds kReboot{3000};      // of a board that greets after it
constexpr double kLongestStop = 20.0;      // s
constexpr const char* kFeedHold = "!";
constexpr const char* kReset = "\x18";
constexpr const char* kReport = "M105\n";

using Protocol = std::shared_ptr<const FirmwareProtocol>;

/// Null for a name that is not known.
Protocol protocolOf(const std::string& name) {
  const auto names = firmwareProtocols().names();
  const bool is_known = std::find(names.begin(), names.end(), name) != names.end();
  return is_known ? firmwareProtocols().find(name) : nullptr;
}

bool isGrbl(const std::string& firmware) {
  return std::dynamic_pointer_cast<const GrblFirmware>(protocolOf(firmware)) != nullptr;
}

StreamSettings settingsFor(const MachinePulse& machine) {
  StreamSettings settings;
  settings.firmware = protocolOf(machine.firmware) ? machine.firmware : kAnyFirmware;
  settings.keep_heaters_on = machine.keeps_heaters_on;
  settings.journal.clear();
  return settings;
}

/// A beam may be on, whatever the program says.
UsedOutputs anyBeam() {
  UsedOutputs outputs;
  outputs.see("M3");
  return outputs;
}

/// What the program may have switched on; of one that cannot be read, nothing but the beam.
UsedOutputs outputsOf(const std::string& program) {
  UsedOutputs outputs = anyBeam();
  if (program.empty()) return outputs;
  try {
    ProgramCursor cursor = StreamableProgram::fromFile(program).open();
    while (const auto line = cursor.next()) outputs.see(line->command);
  } catch (const Error&) {
    return outputs;
  }
  return outputs;
}

void add(std::vector<std::string>& commands, const std::vector<std::string>& more) {
  commands.insert(commands.end(), more.begin(), more.end());
}

std::vector<std::string> pacedStop(const OkPacedFirmware& firmware, const UsedOutputs& outputs,
                                   const MachinePulse& machine) {
  std::vector<std::string> commands = outputs.beamOff();
  if (!machine.keeps_heaters_on) {
    add(commands, firmware.switchOff(""));
    add(commands, outputs.heatOff());
  }
  add(commands, outputs.airOff());
  return commands;
}

std::vector<std::string> stopCommandsOf(const MachinePulse& machine) {
  const UsedOutputs outputs = outputsOf(machine.program);
  const Protocol protocol = protocolOf(machine.firmware);
  if (const auto paced = std::dynamic_pointer_cast<const OkPacedFirmware>(protocol))
    return pacedStop(*paced, outputs, machine);
  const auto marlin = std::dynamic_pointer_cast<const MarlinFirmware>(protocol);
  return safeStop(marlin ? *marlin : MarlinFirmware(), outputs, settingsFor(machine));
}

/// The port, for what is sent without asking.
class OpenPort {
 public:
  /// A process is known to be dead before the kernel has closed all that it held open.
  explicit OpenPort(const MachinePort& port) {
    const auto give_up = std::chrono::steady_clock::now() + kLongestBusy;
    while (!isOpened(port, give_up)) std::this_thread::sleep_for(kPoll);
  }
  ~OpenPort() {
    try {
      link_->close();
      runFor(kPoll);
    } catch (const std::exception&) {
      // What had to be sent is sent; the port closes with the process.
    }
  }
  OpenPort(const OpenPort&) = delete;
  OpenPort& operator=(const OpenPort&) = delete;

  void send(const std::string& bytes) {
    link_->send(bytes);
    for (milliseconds waited{0}; link_->isSending() && waited < kLongestSending; waited += kPoll)
      runFor(kPoll);
  }
  /// @return whether that text has come in this time
  bool hears(const std::string& text, milliseconds longest) {
    for (milliseconds waited{0}; waited < longest; waited += kPoll) {
      if (!text.empty() && heard_.find(text) != std::string::npos) return true;
      runFor(kPoll);
    }
    return false;
  }

 private:
  /// @return false if it is not to be had yet
  bool isOpened(const MachinePort& port, std::chrono::steady_clock::time_point give_up) {
    try {
      link_ = makeTransport(context_, port.name, port.baud);
      link_->open({[this](std::string_view bytes) { heard_.append(bytes); }, [](const std::string&) {}});
      return true;
    } catch (const DeviceError&) {
      if (std::chrono::steady_clock::now() >= give_up) throw;
      return false;
    }
  }
  void runFor(milliseconds time) {
    context_.restart();
    context_.run_for(time);
  }

  boost::asio::io_context context_;
  std::unique_ptr<Transport> link_;
  std::string heard_;
};

/// A reset discards all lines, and switches spindle, laser and coolant off.
MachineStopReport resetGrbl(OpenPort& port) {
  port.hears("", kSlowDown);
  port.send(kReset);
  // Grbl 1.1, grblHAL and FluidNC end their greetings alike.
  if (port.hears("for help]", kReboot)) return {true, "it was slowed down and reset"};
  return {false, "it did not greet after a reset"};
}

/// The last report of temperatures, from the session's thread.
class LastReport {
 public:
  ReplyListener listener() {
    return [this](const FirmwareReply& reply) {
      if (!reply.temperatures) return;
      const std::lock_guard<std::mutex> lock(mutex_);
      last_ = reply;
    };
  }
  /// Nothing without a report.
  std::optional<FirmwareReply> last() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return last_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<FirmwareReply> last_;
};

/// Of all heaters that report one.
double highestTarget(const ReportedTemperatures& last) {
  return std::max(
      {last.highest_target_c, last.nozzle_target_c.value_or(0.0), last.bed_target_c.value_or(0.0)});
}

std::string programOf(const std::vector<std::string>& commands) {
  std::string text;
  for (const std::string& command : commands) text += command + '\n';
  return text + kReport;
}

/// Commands for heaters that the machine reports as still on: of a job without a file nothing is known.
std::vector<std::string> heatersOffBy(const std::string& report, const MachinePulse& machine) {
  const auto paced = std::dynamic_pointer_cast<const OkPacedFirmware>(protocolOf(machine.firmware));
  return paced ? paced->switchOff(report) : reportedHeatersOff(report);
}

/// Sends commands, each of which the machine takes by its number.
/// @return the last report of temperatures, if there is one
/// @throws DeviceError if it does not take them
std::optional<FirmwareReply> reportAfter(const std::vector<std::string>& commands,
                                         const MachinePulse& machine) {
  LastReport report;
  const StreamSettings settings = settingsFor(machine);
  const auto program = StreamableProgram::fromText("safe stop", programOf(commands), settings);
  SessionOptions options;
  options.heard = report.listener();
  const StreamSession session(program, settings, machine.port, {}, options);
  if (!session.waitFor(kLongestStop))
    throw DeviceError("it has not confirmed the stop within " +
                      std::to_string(static_cast<int>(kLongestStop)) + " s");
  const StreamStatus status = session.status();
  if (status.state != PackmlState::Complete) throw DeviceError(status.failure.message);
  return report.last();
}

/// The machine reports what it still heats.
/// @throws DeviceError if it does not take the stop
MachineStopReport confirmed(const MachinePulse& machine) {
  std::optional<FirmwareReply> last = reportAfter(stopCommandsOf(machine), machine);
  if (machine.keeps_heaters_on) return {true, "it is at rest, its heaters as they were"};
  if (last && highestTarget(*last->temperatures) > 0.0)
    last = reportAfter(heatersOffBy(last->text, machine), machine);
  if (!last) return {false, "it has taken the stop, and reports no temperatures"};
  const double target_c = highestTarget(*last->temperatures);
  if (target_c > 0.0)
    return {false, "it still heats to " + std::to_string(static_cast<int>(target_c)) + " C"};
  return {true, "it is at rest, its heaters are off"};
}

}  // namespace

std::string urgentStopOf(const MachinePulse& machine) {
  if (isGrbl(machine.firmware)) return kFeedHold;
  const Protocol protocol = protocolOf(machine.firmware);
  // A program of a gigabyte takes long to be read, and its disk may not answer at all.
  if (const auto paced = std::dynamic_pointer_cast<const OkPacedFirmware>(protocol)) {
    std::string text;
    for (const std::string& command : pacedStop(*paced, anyBeam(), machine)) text += command + '\n';
    return text;
  }
  const auto marlin = std::dynamic_pointer_cast<const MarlinFirmware>(protocol);
  return urgentStop(marlin ? *marlin : MarlinFirmware(), anyBeam(), settingsFor(machine));
}

MachineStopReport stopMachine(const MachinePulse& machine, const std::function<void()>& begun) {
  bool has_begun = false;
  const auto told = [&has_begun](MachineStopReport report) {
    report.has_begun = has_begun;
    return report;
  };
  try {
    {
      OpenPort port(machine.port);
      has_begun = true;
      port.send(urgentStopOf(machine));
      if (begun) begun();
      if (isGrbl(machine.firmware)) return told(resetGrbl(port));
      port.hears("", kAnswers);
    }
    return told(confirmed(machine));
  } catch (const Error& error) {
    return told({false, error.what(), false});
  }
}

}  // namespace lamina
