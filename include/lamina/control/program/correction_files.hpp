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

/// A toolpath in the coordinates of a machine's program.
struct ProgrammedToolpath {
  std::string id;     ///< of the planned toolpath, as correction maps name it
  Toolpath toolpath;  ///< in coordinates of the program
};

/// Name of the file, beside correction maps, with the toolpath to which they belong.
inline constexpr char kProgrammedToolpathFile[] = "toolpath.csv";
/// Name of the file, beside correction maps, that records which of them were applied.
inline constexpr char kAppliedMapsFile[] = "record.csv";

/// The toolpath as CSV, after a first line that states its id. Layers and paths keep their numbers; values
/// read back to the same bits.
std::string programmedToolpathCsv(const ProgrammedToolpath& planned);

/// Reads a toolpath from text that `programmedToolpathCsv` wrote.
/// @param source  names the text in errors
/// @throws InvalidProgram as `readCsv`; if the first line states no id
ProgrammedToolpath readProgrammedToolpath(std::string_view text, const std::string& source);

/// A map and the file from which it was read.
struct FiledMap {
  std::string file;
  CorrectionMap map;
  /// First line of the program, from 1, for which the map is valid, as the record says. 0 if there is no
  /// record, or it states no lines: the map is then valid for its whole layer.
  std::size_t from_line = 0;
};

/// A row of the record of applied maps.
struct AppliedRow {
  std::size_t layer = 0;
  std::uint64_t sequence = 0;
  std::string digest;         ///< digest of the map; empty if the layer is deposited as planned
  std::size_t from_line = 0;  ///< as in `FiledMap`
  bool is_later = false;      ///< whether the map replaces the one with which the layer began
};

/// The job to which a record belongs.
struct RecordedJob {
  std::string program_sha256;  ///< of the program without corrections
  std::string toolpath_id;
  std::string job;  ///< unique name
};

/// The content of `kAppliedMapsFile` for a job.
std::string appliedRecordCsv(const RecordedJob& of, const std::vector<AppliedRow>& rows);

/// The job to which the record in a folder belongs; members that the record does not state are empty. None if
/// there is no record.
/// @throws FileError if the record cannot be read
std::optional<RecordedJob> recordedJob(const std::string& folder);

/// Name of the file, beside the record, with the map of a row: `layer_<layer>.csv`, or
/// `layer_<layer>_<sequence>.csv` if the map replaces another one within the layer.
std::string appliedMapFile(const AppliedRow& row);

/// Reads one map from a file, or all maps from a folder, named as `lamina estimate` and the streamer write
/// them: `correction_<layer>.csv` and `layer_<layer>.csv`, with `_<sequence>` after the layer if the layer
/// has several maps. If the folder has a record, only the maps that it names are read, each with its first
/// line. The result ascends by layer and line.
/// @throws FileError if there is nothing to read at the path
/// @throws InvalidInput naming the file: as `readCorrectionMap`; if a folder has neither map nor record; if
///   two maps are of one layer and no record says where each begins; if a map that was applied is missing, or
///   its digest is not the recorded one
std::vector<FiledMap> readCorrectionFiles(const std::string& path);

/// The reason why a map cannot belong to a toolpath: another toolpath, a missing layer or path, or a shift of
/// more than the layer's height. It is the rest of a sentence that begins with "the map"; empty if there is
/// no such reason.
std::string defectOf(const CorrectionMap& map, const std::string& toolpath_id, const Toolpath& toolpath);
std::string defectOf(const CorrectionMap& map, const ProgrammedToolpath& planned);

}  // namespace lamina
