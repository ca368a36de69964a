// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/output_writer.hpp"
#include "lamina/program/rapid/rapid_settings.hpp"

namespace lamina {

/// Whether the suffix is that of a module: .mod.
bool isRapidFile(const std::string& path);

/// Writes a program of one module.
/// @throws InvalidInput as `RapidProgram`; also if the program would speak other axes than those of the bed
void writeRapid(const PlacedToolpath& placed, const RapidSettings& settings, const TextSink& sink);

/// Writes main under the path and the other modules beside it, under their names; all files or none. The
/// module is named after the file where the settings name none.
/// @return names of the files, main first
/// @throws InvalidInput, InvalidConfig as above; FileError
std::vector<std::string> writeRapidFiles(const std::string& path, const PlacedToolpath& placed,
                                         RapidSettings settings);

}  // namespace lamina
