// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "arguments/setting_options.hpp"
#include "subcommand.hpp"

namespace lamina::cli {

/// A robot's program, and from where its rest is to be written; one of line, layer and height.
struct RobotResume {
  std::string program;
  std::string output;
  std::string machine;  ///< name, profile or file; empty for that of the settings
  std::optional<std::uint64_t> line;
  std::string file;  ///< of the line, where the program has several; empty for none
  std::optional<std::int32_t> layer;
  std::optional<double> height_mm;
  SettingOptions settings;
};

/// Writes the rest of a robot's program as a program of its own, and says what has to be so before it runs.
/// @throws InvalidInput, InvalidConfig, InvalidProgram, Unreachable, FileError
void resumeRobot(const RobotResume& resume, OutputFormat format);

}  // namespace lamina::cli
