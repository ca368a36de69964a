// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "arguments/setting_options.hpp"
#include "subcommand.hpp"

namespace lamina::cli {

/// A robot's program, and where its rest begins; one of line, layer and height.
struct RobotResume {
  std::string program;
  std::string output;
  std::string machine;  ///< name, profile or file; empty for that of the settings
  std::optional<std::uint64_t> line;
  std::string file;  ///< file of the line, if the program has several; empty for none
  std::optional<std::int32_t> layer;
  std::optional<double> height_mm;
  SettingOptions settings;
};

/// Writes the rest of a robot's program as a separate program, and reports the conditions to be met before it
/// runs.
/// @throws InvalidInput, InvalidConfig, InvalidProgram, Unreachable, FileError
void resumeRobot(const RobotResume& resume, OutputFormat format);

}  // namespace lamina::cli
