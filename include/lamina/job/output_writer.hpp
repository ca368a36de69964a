// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What becomes a file: a toolpath, where its part stands, and the axes that a program speaks of.
struct PlacedToolpath {
  const Toolpath& toolpath;
  ProgramFrame frame;
};

/// Writes a toolpath in one format.
using OutputWriter =
    std::function<void(const PlacedToolpath& placed, const ProgramSettings& settings, const TextSink& sink)>;

/// The suffixes that choose a writer, with their dot: .csv, .gcode.
std::vector<std::string> outputSuffixes();

/// The writer that the path's suffix chooses.
/// @throws InvalidInput if there is none, naming those there are
OutputWriter outputWriterFor(const std::string& path);

/// Writes the file whole or not at all.
/// @throws InvalidInput as above, or from the writer; FileError
void writeOutput(const std::string& path, const PlacedToolpath& placed, const ProgramSettings& settings);

}  // namespace lamina
