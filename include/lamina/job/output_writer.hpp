// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/registry.hpp"
#include "lamina/job/annotations/program_annotations.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A machine or robot and its joints at each waypoint of a toolpath.
struct ProgramJoints {
  const KinematicModel& model;
  const JointPath& path;
};

/// What becomes a file: a toolpath, where its part stands, the axes that a program speaks of, and the joints
/// that it states.
struct PlacedToolpath {
  const Toolpath& toolpath;
  ProgramFrame frame;
  std::optional<ProgramJoints> joints = std::nullopt;  ///< G-code then is five-axis G-code
};

/// Writes a toolpath in one format.
/// @throws InvalidInput, InvalidConfig if the format cannot express it, before the first piece is written
using OutputWriter =
    std::function<void(const PlacedToolpath& placed, const ProgramSettings& settings, const TextSink& sink)>;

/// Writes the file of that path, and others beside it, each whole or not at all.
/// @throws as `OutputWriter`; FileError
using FilesWriter = std::function<void(const std::string& path, const PlacedToolpath& placed,
                                       const ProgramSettings& settings)>;

/// A format of programs or toolpaths.
struct ProgramWriter {
  OutputWriter write;
  FilesWriter write_files;  ///< of a format that may take several files; empty if it takes one
};

/// All formats by their suffix with its dot, those of plug-ins too. Whoever adds one calls
/// `programWriters().add(".xyz", {...})`.
Registry<ProgramWriter>& programWriters();

/// The suffixes that choose a writer, with their dot: .csv, .gcode, those of robots (.mod, .src, ...), and
/// those of plug-ins.
std::vector<std::string> outputSuffixes();

/// The writer that the path's suffix chooses.
/// @throws InvalidInput if there is none, naming those there are
OutputWriter outputWriterFor(const std::string& path);

/// Writes the file whole or not at all; a program in modules has a file for each (`writeRapidFiles`).
/// @throws InvalidInput as above, or from the writer; FileError
void writeOutput(const std::string& path, const PlacedToolpath& placed, const ProgramSettings& settings);

/// The same with comments round it, of a format that takes one file.
void writeOutput(const std::string& path, const PlacedToolpath& placed, const ProgramSettings& settings,
                 const ProgramAnnotations& annotations);

}  // namespace lamina
