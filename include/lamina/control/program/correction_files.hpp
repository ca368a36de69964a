// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath as a program for a machine has it.
struct ProgrammedToolpath {
  std::string id;     ///< of the toolpath as it was planned, which correction maps name
  Toolpath toolpath;  ///< in coordinates of the program
};

/// File beside correction maps that holds the toolpath they are of.
inline constexpr char kProgrammedToolpathFile[] = "toolpath.csv";
/// File beside correction maps that says which of them were applied.
inline constexpr char kAppliedMapsFile[] = "record.csv";

/// The toolpath as CSV under a line that states its id. Layers and paths keep their numbers, and numbers read
/// back to the same double.
std::string programmedToolpathCsv(const ProgrammedToolpath& planned);

/// @param source  names the text in errors
/// @throws InvalidProgram as `readCsv`; if the first line states no id
ProgrammedToolpath readProgrammedToolpath(std::string_view text, const std::string& source);

/// A map and the file that it was read from.
struct FiledMap {
  std::string file;
  CorrectionMap map;
  /// Line of the program, from 1, from which on it holds, where a record says so; else 0: it holds for its
  /// layer.
  std::size_t from_line = 0;
};

/// A row of the record of what was applied.
struct AppliedRow {
  std::size_t layer = 0;
  std::uint64_t sequence = 0;
  std::string digest;         ///< empty where the layer is laid as planned
  std::size_t from_line = 0;  ///< as of `FiledMap`
  bool is_later = false;      ///< it takes the place of the map that the layer began with
};

/// What a record is of.
struct RecordedJob {
  std::string program_sha256;  ///< of the program without corrections
  std::string toolpath_id;
  std::string job;  ///< that no other one is called
};

/// The record of a program that maps are applied to, as it stands in `kAppliedMapsFile`.
std::string appliedRecordCsv(const RecordedJob& of, const std::vector<AppliedRow>& rows);

/// What the record of a folder is of, texts that it does not state being empty; nothing without a record.
/// @throws FileError if it cannot be read
std::optional<RecordedJob> recordedJob(const std::string& folder);

/// The name beside it of the map that a row tells of: `layer_<layer>.csv`, and of what takes its place within
/// the layer `layer_<layer>_<sequence>.csv`.
std::string appliedMapFile(const AppliedRow& row);

/// The maps of a file, or of a folder as `lamina estimate` and the streamer write them:
/// `correction_<layer>.csv` and `layer_<layer>.csv`. Where the folder has a record of what was applied, it
/// says which of them count, and where. By layer and line, ascending.
/// @throws FileError if there is nothing to read
/// @throws InvalidInput naming the file: as `readCorrectionMap`; if two maps are of one layer and no record
///   says where each begins, a folder has none, or a map that was applied is missing or has another digest
///   than the record says
std::vector<FiledMap> readCorrectionFiles(const std::string& path);

/// Why a map cannot be of a program, as the rest of a sentence that begins with its name; empty if it can:
/// another toolpath, a layer or path that there is not, a shift of more than the layer's height.
std::string defectOf(const CorrectionMap& map, const std::string& toolpath_id, const Toolpath& toolpath);
std::string defectOf(const CorrectionMap& map, const ProgrammedToolpath& planned);

}  // namespace lamina
