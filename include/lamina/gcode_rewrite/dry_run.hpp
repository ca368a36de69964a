// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/base/quotation.hpp"
#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What a dry run makes of a command that it does not know, such as a macro.
enum class UnknownCommand : std::uint8_t { LeaveOut, Refuse };

struct DryRunSettings {
  double speed = 1.0;           ///< of the programmed feeds
  std::string extrusion = "E";  ///< letters of extruder axes
  UnknownCommand unknown = UnknownCommand::LeaveOut;
};

/// Adds the keys dry.*.
void describe(SettingsSchema& schema, DryRunSettings& settings);

/// What was done to a program.
struct DryRunReport {
  std::size_t lines = 0;      ///< commands read
  std::size_t process = 0;    ///< commands and words of the process that were taken out
  std::size_t unknown = 0;    ///< commands left out because they are not known
  std::string first_unknown;  ///< the first of these, with its line
};

struct GcodeWordText;

/// Turns a program of G-code into one with the same motions and without the process: no word of an extruder,
/// no heater, no wait for one, no fan, laser, spindle, coolant, change of tool or retraction by the firmware.
/// What switches off stays, and what switches a laser or spindle on switches it off. Only commands that are
/// known to switch nothing on are kept; a macro of unknown effect is left out or refused. Modal feeds stay,
/// also those of motions of the extruder alone.
class DryRun {
 public:
  /// @throws InvalidConfig naming key, value and bound
  explicit DryRun(const DryRunSettings& settings);

  /// The line to be run instead; nothing if all of it was taken out. Comments stay.
  /// @throws InvalidProgram naming the line if a motion cannot be read, a G code is not known (which may
  ///   change how the next motions are read), S stands in a motion where it may be a homing one, or a command
  ///   is not known that is to be refused
  std::optional<std::string> line(std::string_view text);

  const DryRunReport& report() const { return report_; }

 private:
  struct Block;

  std::optional<std::string> command(std::string_view text);
  std::optional<std::string> coded(const Block& block);
  std::optional<std::string> motion(const Block& block);
  std::optional<std::string> keptWord(const GcodeWordText& word, const Block& block);
  std::optional<std::string> offset(const Block& block);
  std::optional<std::string> machineCommand(int code, const Block& block);
  std::optional<std::string> unknown(std::string_view text);
  std::string beamOff();
  std::optional<std::string> takenOut();
  std::string scaledFeed(const GcodeWordText& word) const;
  void requireReadable(const GcodeWordText& word, const Block& block) const;
  void requireNoHoming(const GcodeWordText& word, const Block& block) const;
  [[noreturn]] void refuse(const std::string& why, std::string_view text) const;

  DryRunSettings settings_;
  DryRunReport report_;
  Quotation quotation_;
  std::size_t number_ = 0;  ///< of the line
  std::string motion_;      ///< the last motion command that was kept: "G1"
  bool has_beam_ = false;   ///< the program switches a laser or spindle
};

/// In one sentence: "dry run: 12 commands and words of the process taken out".
std::string toText(const DryRunReport& report);

/// Writes a program as it is run dry, line by line, in constant memory.
/// @param dry  path of the file to write
/// @throws InvalidProgram as `DryRun::line`; FileError
DryRunReport writeDryRun(std::istream& program, const std::string& dry, const DryRunSettings& settings);

}  // namespace lamina
