// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/streaming/job/firmware_protocol.hpp"

namespace lamina {

/// Marlin 2, and all firmware that numbers lines, takes them in order only, and asks for the one it lacks.
/// One that speaks nearly so overrides what differs. Commands are lines without number and end. Held by
/// shared pointer, since jobs keep it.
class MarlinFirmware : public FirmwareProtocol, public std::enable_shared_from_this<MarlinFirmware> {
 public:
  bool isSpokenBy(std::string_view firmware_name) const override;
  std::string defectOf(std::string_view command, const StreamSettings& settings) const override;
  bool canResume() const override { return true; }
  bool canRevise() const override { return true; }
  std::unique_ptr<StreamJob> begin(StreamOrder order) const override;

  /// A command as it goes out: numbered, checked, with its end of line.
  virtual std::string framed(std::uint64_t number, std::string_view command) const;
  /// What a line of the firmware means. Nothing is refused: an unknown line is Information.
  virtual FirmwareReply read(std::string_view line) const;

  /// Asks the firmware for its name (`FirmwareReply::firmware_name`) and changes nothing.
  virtual std::string identification() const;
  /// Sets the number that lines count on from.
  virtual std::string numberedFrom(std::uint64_t number) const;
  /// Changes nothing, and is answered with the temperatures.
  virtual std::string harmless() const;
  /// Is answered when all motions have ended.
  virtual std::string endOfMotions() const;
  /// Makes the firmware report its position every so many seconds.
  virtual std::string reportPosition(int interval_s) const;
  /// Makes the firmware report its temperatures every so many seconds.
  virtual std::string reportTemperatures(int interval_s) const;
  /// Whether the firmware may say nothing for long while it runs a command.
  virtual bool isBlocking(std::string_view command) const;

  /// Changes how it prints; nothing if it cannot.
  virtual std::optional<std::string> changed(const LiveChange& change) const;

  /// Ends waiting at once, without a number, in front of a safe stop.
  virtual std::vector<std::string> interruption() const;
  /// Ends all motions.
  virtual std::vector<std::string> stop() const;
  /// Turns all heaters off.
  virtual std::vector<std::string> heatersOff() const;
};

}  // namespace lamina
