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

/// How a dry run treats a command that it does not know, such as a macro.
enum class UnknownCommand : std::uint8_t { LeaveOut, Refuse };

/// Settings of a dry run.
struct DryRunSettings {
  double speed = 1.0;           ///< factor on the programmed feeds
  std::string extrusion = "E";  ///< letters of extruder axes
  UnknownCommand unknown = UnknownCommand::LeaveOut;
};

/// Adds the keys dry.*.
void describe(SettingsSchema& schema, DryRunSettings& settings);

/// What was changed in a program.
struct DryRunReport {
  std::size_t lines = 0;      ///< number of commands read
  std::size_t process = 0;    ///< number of commands and words of the process that were removed
  std::size_t unknown = 0;    ///< number of commands removed because they are not known
  std::string first_unknown;  ///< the first of these, with its line
};

struct GcodeWordText;

/// Turns a G-code program into one with the same motions but without the process. Extruder words are removed,
/// and so are commands for heaters (with their waits), fans, lasers, spindles, coolant, tool changes and
/// firmware retraction. G and M codes that switch something off stay, but not `M103` and `M127`; codes that
/// switch a laser or spindle on are replaced by a code that switches it off. Only commands that are known to
/// switch nothing on are kept; a macro of unknown effect is removed or refused. Feed words stay, also those
/// of extruder-only motions, because feeds are modal.
class DryRun {
 public:
  /// @throws InvalidConfig naming key, value and bound if a setting is out of bounds
  explicit DryRun(const DryRunSettings& settings);

  /// The line to be run instead of a line of the program; nothing if all of it was removed. Comments after a
  /// semicolon stay.
  /// @param text  next line of the program; lines must be passed in order
  /// @throws InvalidProgram naming the line if a motion cannot be read; if a G code is not known, as it may
  ///   change how later motions are read; if a motion has an S that may make it a homing motion; or if an
  ///   unknown command is to be refused
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
  std::size_t number_ = 0;  ///< number of the line
  std::string motion_;      ///< last motion command that was kept: "G1"
  bool has_beam_ = false;   ///< whether the program switches a laser or spindle
};

/// The report in one sentence: "dry run: 12 commands and words of the process taken out".
std::string toText(const DryRunReport& report);

/// Writes the dry run of a program to a file, line by line, in constant memory.
/// @param dry  path of the file
/// @throws InvalidProgram as `DryRun::line`; FileError if the file cannot be written
DryRunReport writeDryRun(std::istream& program, const std::string& dry, const DryRunSettings& settings);

}  // namespace lamina
