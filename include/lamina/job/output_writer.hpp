// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "lamina/program/program_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What becomes a file: a toolpath and where its part stands on the bed.
struct PlacedToolpath {
  const Toolpath& toolpath;
  const Eigen::Isometry3d& bed_from_part;
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
