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

/// The protocol of Marlin 2, and of all firmware that takes numbered lines in order only and requests a
/// missing one again. A protocol that differs in part overrides that part. Commands are lines without number
/// and end of line. Instances are held by shared pointers, since jobs keep them.
class MarlinFirmware : public FirmwareProtocol, public std::enable_shared_from_this<MarlinFirmware> {
 public:
  bool isSpokenBy(std::string_view firmware_name) const override;
  std::string defectOf(std::string_view command, const StreamSettings& settings) const override;
  bool canResume() const override { return true; }
  bool canRevise() const override { return true; }
  std::unique_ptr<StreamJob> begin(StreamOrder order) const override;

  /// A command as it is sent: with number, checksum and end of line.
  virtual std::string framed(std::uint64_t number, std::string_view command) const;
  /// Parses a line of the firmware. Any line is accepted; an unknown one is Information.
  virtual FirmwareReply read(std::string_view line) const;

  /// The command that asks the firmware for its name (`FirmwareReply::firmware_name`) and changes nothing.
  virtual std::string identification() const;
  /// The command after which lines are numbered from `number` on.
  virtual std::string numberedFrom(std::uint64_t number) const;
  /// A command that changes nothing and is answered with the temperatures.
  virtual std::string harmless() const;
  /// A command that is answered when all motions have ended.
  virtual std::string endOfMotions() const;
  /// The command that makes the firmware report its position at that interval.
  virtual std::string reportPosition(int interval_s) const;
  /// The command that makes the firmware report its temperatures at that interval.
  virtual std::string reportTemperatures(int interval_s) const;
  /// Whether the firmware may be silent for long while it runs a command.
  virtual bool isBlocking(std::string_view command) const;

  /// The command for a change of the running job; none if the firmware has none.
  virtual std::optional<std::string> changed(const LiveChange& change) const;

  /// Commands, without number, that end waiting at once before a safe stop.
  virtual std::vector<std::string> interruption() const;
  /// Commands that end all motions.
  virtual std::vector<std::string> stop() const;
  /// Commands that turn all heaters off.
  virtual std::vector<std::string> heatersOff() const;
};

}  // namespace lamina
