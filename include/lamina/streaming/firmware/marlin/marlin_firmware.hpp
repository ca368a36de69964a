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

/// The protocol of Marlin 2, and of all firmware that accepts numbered lines in ascending order only and asks
/// for a missing line to be sent again. A protocol that differs derives from it and overrides the functions
/// concerned. A command is a line without number, checksum and line feed. Instances must be held by shared
/// pointers, since jobs share their ownership.
class MarlinFirmware : public FirmwareProtocol, public std::enable_shared_from_this<MarlinFirmware> {
 public:
  bool isSpokenBy(std::string_view firmware_name) const override;
  std::string defectOf(std::string_view command, const StreamSettings& settings) const override;
  bool canResume() const override { return true; }
  bool canRevise() const override { return true; }
  std::unique_ptr<StreamJob> begin(StreamOrder order) const override;

  /// The bytes that are sent for a command: with number, checksum and line feed.
  virtual std::string framed(std::uint64_t number, std::string_view command) const;
  /// Parses a line of the firmware; an unknown one is Information.
  virtual FirmwareReply read(std::string_view line) const;

  /// The command that asks the firmware for its name (`FirmwareReply::firmware_name`) and changes nothing.
  virtual std::string identification() const;
  /// The command after which the firmware expects `number` as the number of the next line.
  virtual std::string numberedFrom(std::uint64_t number) const;
  /// A command that changes nothing and is answered by the temperatures.
  virtual std::string harmless() const;
  /// A command that is answered when all motions have ended.
  virtual std::string endOfMotions() const;
  /// The command that makes the firmware report its position periodically; 0 for never.
  virtual std::string reportPosition(int interval_s) const;
  /// The command that makes the firmware report its temperatures periodically; 0 for never.
  virtual std::string reportTemperatures(int interval_s) const;
  /// Whether the firmware may send nothing for a long time while it runs a command, such as heating.
  virtual bool isBlocking(std::string_view command) const;

  /// The command that makes a change of the running job; nothing if the firmware has none for it.
  virtual std::optional<std::string> changed(const LiveChange& change) const;

  /// Commands, sent without number before a safe stop, that make the firmware stop waiting, for example for a
  /// temperature.
  virtual std::vector<std::string> interruption() const;
  /// Commands that end all motions.
  virtual std::vector<std::string> stop() const;
  /// Commands that turn all heaters off.
  virtual std::vector<std::string> heatersOff() const;
};

}  // namespace lamina
