// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/correction_files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/program/csv/csv_writer.hpp"

namespace lamina {
namespace {

constexpr std::string_view kIdLine = "#TOOLPATH: ";
constexpr char kNoMapApplied[] = "none";
constexpr std::string_view kProgramLine = "# program_sha256 ";
constexpr std::string_view kToolpathLine = "# toolpath ";
constexpr std::string_view kJobLine = "# job ";
constexpr char kFromLine[] = "from_line";

bool isNumber(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// `<layer>` and `<layer>_<sequence>`.
bool namesMap(std::string_view text) {
  const std::size_t split = text.find('_');
  return isNumber(text.substr(0, split)) &&
         (split == std::string_view::npos || isNumber(text.substr(split + 1)));
}

bool isMapFile(const std::string& name) {
  constexpr std::string_view kEnd = ".csv";
  for (const std::string_view begin : {std::string_view("correction_"), std::string_view("layer_")}) {
    if (name.size() <= begin.size() + kEnd.size() || name.compare(0, begin.size(), begin) != 0) continue;
    const std::string number = name.substr(begin.size(), name.size() - begin.size() - kEnd.size());
    if (namesMap(number) && name.compare(name.size() - kEnd.size(), kEnd.size(), kEnd) == 0) return true;
  }
  return false;
}

std::vector<std::string> mapFilesIn(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code failure;
  for (std::filesystem::directory_iterator each(folder, failure), end; !failure && each != end;
       each.increment(failure))
    if (isMapFile(each->path().filename().string())) files.push_back(each->path().string());
  if (failure) throw FileError("cannot read the folder " + folder + ": " + failure.message());
  std::sort(files.begin(), files.end());
  return files;
}

/// What stands behind these words at the beginning of a line; empty if none begins with them.
std::string statedBehind(std::string_view words, std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.substr(0, words.size()) == words) return std::string(line.substr(words.size()));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return {};
}

std::size_t countOf(const std::string& text, const std::string& record, std::size_t line) {
  constexpr std::size_t kMostDigits = 18;
  if (isNumber(text) && text.size() <= kMostDigits) return std::stoull(text);
  throw InvalidInput(record + ", line " + std::to_string(line) + ": '" + text +
                     "' stands for a layer, sequence or line; expected a whole number");
}

/// The maps that a record says were applied. Records of before layers had several maps state no lines.
std::vector<AppliedRow> appliedRows(const std::string& record) {
  const CsvTable table = readCsvTable(record);
  const std::size_t layer = columnOf(table, "layer");
  const std::size_t sequence = columnOf(table, "sequence");
  const std::size_t digest = columnOf(table, "digest");
  const bool has_lines =
      std::find(table.columns.begin(), table.columns.end(), kFromLine) != table.columns.end();
  std::vector<AppliedRow> applied;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& row = table.rows[i];
    const auto count = [&](std::size_t column) { return countOf(row[column], record, table.lines[i]); };
    if (row[digest] == kNoMapApplied) continue;
    applied.push_back({count(layer), count(sequence), row[digest],
                       has_lines ? count(columnOf(table, kFromLine)) : std::size_t{0}, false});
  }
  return applied;
}

/// The map that a row names, among those of the folder.
FiledMap appliedMap(const AppliedRow& row, const std::vector<FiledMap>& maps, const std::string& record) {
  const FiledMap* of_layer = nullptr;
  for (const FiledMap& each : maps) {
    if (each.map.layer != row.layer) continue;
    if (digestOf(each.map) == row.digest) return {each.file, each.map, row.from_line};
    if (of_layer == nullptr) of_layer = &each;
  }
  const std::string deposited_by = "layer " + std::to_string(row.layer) + " was deposited by ";
  if (of_layer != nullptr && of_layer->map.sequence == row.sequence)
    throw InvalidInput(of_layer->file + ": the map's digest is " + digestOf(of_layer->map) + "; " + record +
                       " says that " + deposited_by + row.digest);
  throw InvalidInput(record + ": " + deposited_by + "map " + row.digest + ", which is not in the folder");
}

/// Only those that were applied are left; each must be there.
void keepApplied(std::vector<FiledMap>& maps, const std::string& record) {
  std::vector<FiledMap> kept;
  for (const AppliedRow& row : appliedRows(record)) kept.push_back(appliedMap(row, maps, record));
  maps = std::move(kept);
}

void sortByLayer(std::vector<FiledMap>& maps) {
  const auto place = [](const FiledMap& each) { return std::make_pair(each.map.layer, each.from_line); };
  std::stable_sort(maps.begin(), maps.end(),
                   [&](const FiledMap& a, const FiledMap& b) { return place(a) < place(b); });
  for (std::size_t i = 1; i < maps.size(); ++i)
    if (place(maps[i]) == place(maps[i - 1]))
      throw InvalidInput(maps[i].file + ": the map is of layer " + std::to_string(maps[i].map.layer) +
                         ", as that of " + maps[i - 1].file + "; expected one map per layer");
}

}  // namespace

std::string programmedToolpathCsv(const ProgrammedToolpath& planned) {
  std::string text = std::string(kIdLine) + planned.id + "\n";
  writeCsv(planned.toolpath, [&](std::string_view piece) { text += piece; });
  return text;
}

ProgrammedToolpath readProgrammedToolpath(std::string_view text, const std::string& source) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view first = text.substr(0, end);
  if (first.substr(0, kIdLine.size()) != kIdLine || first.size() == kIdLine.size())
    throw InvalidProgram(source + " states no toolpath in its first line; expected '" + std::string(kIdLine) +
                         "' and an id, as stands in " + kProgrammedToolpathFile + " beside correction maps");
  return {std::string(first.substr(kIdLine.size())),
          readCsv(text.substr(std::min(end + 1, text.size())), source)};
}

std::vector<FiledMap> readCorrectionFiles(const std::string& path) {
  const bool is_folder = std::filesystem::is_directory(path);
  std::vector<FiledMap> maps;
  for (const std::string& file : is_folder ? mapFilesIn(path) : std::vector<std::string>{path})
    maps.push_back({file, readCorrectionMap(readTextFile(file), file)});
  const std::string record = path + "/" + kAppliedMapsFile;
  if (is_folder && std::filesystem::exists(record)) {
    keepApplied(maps, record);
  } else if (maps.empty()) {
    throw InvalidInput(path +
                       " holds no correction maps; expected correction_<layer>.csv or layer_<layer>.csv");
  }
  sortByLayer(maps);
  return maps;
}

std::string appliedRecordCsv(const RecordedJob& of, const std::vector<AppliedRow>& rows) {
  const auto line = [](std::string_view name, const std::string& value) {
    return std::string(name) + value + "\n";
  };
  std::string text = line(kProgramLine, of.program_sha256) + line(kToolpathLine, of.toolpath_id) +
                     line(kJobLine, of.job) + "layer,sequence,digest," + kFromLine + "\n";
  for (const AppliedRow& row : rows)
    text += std::to_string(row.layer) + "," + std::to_string(row.sequence) + "," +
            (row.digest.empty() ? kNoMapApplied : row.digest) + "," + std::to_string(row.from_line) + "\n";
  return text;
}

std::optional<RecordedJob> recordedJob(const std::string& folder) {
  const std::string record = folder + "/" + kAppliedMapsFile;
  if (!std::filesystem::exists(record)) return std::nullopt;
  const std::string text = readTextFile(record);
  return RecordedJob{statedBehind(kProgramLine, text), statedBehind(kToolpathLine, text),
                     statedBehind(kJobLine, text)};
}

std::string appliedMapFile(const AppliedRow& row) {
  return "layer_" + std::to_string(row.layer) + (row.is_later ? "_" + std::to_string(row.sequence) : "") +
         ".csv";
}

std::string defectOf(const CorrectionMap& map, const ProgrammedToolpath& planned) {
  return defectOf(map, planned.id, planned.toolpath);
}

std::string defectOf(const CorrectionMap& map, const std::string& toolpath_id, const Toolpath& toolpath) {
  if (map.toolpath_id != toolpath_id)
    return "is of toolpath " + map.toolpath_id + "; expected toolpath " + toolpath_id;
  const std::string layer = "layer " + std::to_string(map.layer);
  const std::vector<ToolpathLayer>& layers = toolpath.layers;
  if (map.layer >= layers.size())
    return "is of " + layer + "; the toolpath has " + std::to_string(layers.size());
  const double most_mm = layers[map.layer].height_mm;
  const std::size_t paths = layers[map.layer].paths.size();
  for (const PathCorrection& path : map.paths) {
    if (path.path >= paths)
      return "of " + layer + " is of path " + std::to_string(path.path) + "; the layer has " +
             std::to_string(paths);
    for (const PointCorrection& place : path.stations)
      if (std::abs(place.dz_mm) > most_mm)
        return "of " + layer + " moves the nozzle by " + numberText(place.dz_mm) +
               " mm; expected no more than the layer, " + numberText(most_mm) + " mm";
  }
  return {};
}

}  // namespace lamina
