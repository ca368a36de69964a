// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/output_writer.hpp"
#include "lamina/program/rapid/rapid_settings.hpp"

namespace lamina {

/// Whether the suffix is that of a RAPID module: .mod.
bool isRapidFile(const std::string& path);

/// Writes a RAPID program that is a single module.
/// @throws InvalidInput as `RapidProgram`; also if the machine's axes are not at right angles, as programs
///   for robots are in coordinates of the bed
void writeRapid(const PlacedToolpath& placed, const RapidSettings& settings, const TextSink& sink);

/// Writes a RAPID program in one or more modules: the module with `main` at the path and the other ones
/// beside it, each named after its module; all files or none. If the settings name no module, the first one
/// is named after the file.
/// @return names of the files, the file of `main` first
/// @throws InvalidInput as above; InvalidConfig if a module would be written over the file of `main`;
///   FileError
std::vector<std::string> writeRapidFiles(const std::string& path, const PlacedToolpath& placed,
                                         RapidSettings settings);

}  // namespace lamina
