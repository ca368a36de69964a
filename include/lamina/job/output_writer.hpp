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

/// A machine or robot, and its joint values at each waypoint of a toolpath.
struct ProgramJoints {
  const KinematicModel& model;
  const JointPath& path;
};

/// A toolpath to be written to a file: with its part's pose on the bed, the axes in which the program is
/// written, and the joint values, if the format may state them.
struct PlacedToolpath {
  const Toolpath& toolpath;
  ProgramFrame frame;
  std::optional<ProgramJoints> joints = std::nullopt;  ///< if they are given, G-code is five-axis G-code
};

/// Writes a toolpath in one format.
/// @throws InvalidInput, InvalidConfig if the format cannot express it, before the first piece is written
using OutputWriter =
    std::function<void(const PlacedToolpath& placed, const ProgramSettings& settings, const TextSink& sink)>;

/// Writes the file at the path, and further files beside it, each whole or not at all.
/// @throws as `OutputWriter`; FileError
using FilesWriter = std::function<void(const std::string& path, const PlacedToolpath& placed,
                                       const ProgramSettings& settings)>;

/// A format of programs or toolpaths.
struct ProgramWriter {
  OutputWriter write;
  FilesWriter write_files;  ///< writer of a format that may need several files; empty otherwise
};

/// All formats by their suffix with its dot, those of plug-ins included. A plug-in adds one by
/// `programWriters().add(".xyz", {...})`.
Registry<ProgramWriter>& programWriters();

/// All suffixes for which there is a writer, with their dot: .csv, .gcode, those of robots (.mod, .src, ...),
/// and those of plug-ins.
std::vector<std::string> outputSuffixes();

/// The writer for the suffix of the path.
/// @throws InvalidInput if there is none, naming the suffixes that have one
OutputWriter outputWriterFor(const std::string& path);

/// Writes a toolpath to a file, whole or not at all; a program in several modules has one file per module
/// (`writeRapidFiles`).
/// @throws InvalidInput as above, or from the writer; FileError
void writeOutput(const std::string& path, const PlacedToolpath& placed, const ProgramSettings& settings);

/// Writes a toolpath as above, with annotations as comments. Formats that may need several files ignore the
/// annotations.
void writeOutput(const std::string& path, const PlacedToolpath& placed, const ProgramSettings& settings,
                 const ProgramAnnotations& annotations);

}  // namespace lamina
