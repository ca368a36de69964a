// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/base/registry.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

namespace lamina {

/// How a firmware is spoken to: the port through which `Streamer` reaches it. A firmware must number lines,
/// take them in order only, and ask for the one it lacks; what it says is read in Marlin's terms. Commands
/// are lines without number and end. Constant, and called from several threads at once.
class FirmwareProtocol {
 public:
  virtual ~FirmwareProtocol() = default;

  /// A command as it goes out: numbered, checked, with its end of line.
  virtual std::string framed(std::uint64_t number, std::string_view command) const = 0;
  /// What a line of the firmware means. Nothing is refused: an unknown line is Information.
  virtual MarlinReply read(std::string_view line) const = 0;

  /// Asks the firmware for its name (`MarlinReply::firmware_name`) and changes nothing.
  virtual std::string identification() const = 0;
  /// Whether a firmware of that name speaks this protocol.
  virtual bool isSpokenBy(std::string_view firmware_name) const = 0;
  /// Sets the number that lines count on from.
  virtual std::string numberedFrom(std::uint64_t number) const = 0;
  /// Changes nothing, and is answered with the temperatures.
  virtual std::string harmless() const = 0;
  /// Is answered when all motions have ended.
  virtual std::string endOfMotions() const = 0;
  /// Makes the firmware report its position every so many seconds.
  virtual std::string reportPosition(int interval_s) const = 0;
  /// Makes the firmware report its temperatures every so many seconds.
  virtual std::string reportTemperatures(int interval_s) const = 0;
  /// Whether the firmware may say nothing for long while it runs a command.
  virtual bool isBlocking(std::string_view command) const = 0;

  /// Ends waiting at once, without a number, in front of a safe stop.
  virtual std::vector<std::string> interruption() const = 0;
  /// Ends all motions.
  virtual std::vector<std::string> stop() const = 0;
  /// Turns all heaters off.
  virtual std::vector<std::string> heatersOff() const = 0;
};

/// All protocols, those of plug-ins too: "marlin". Whoever adds one calls
/// `firmwareProtocols().add("name", std::make_shared<...>())`; null pointers are not for use.
Registry<std::shared_ptr<const FirmwareProtocol>>& firmwareProtocols();

}  // namespace lamina
