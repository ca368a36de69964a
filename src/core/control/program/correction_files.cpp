// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/correction_files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/program/csv/csv_writer.hpp"

namespace lamina {
namespace {

constexpr std::string_view kIdLine = "#TOOLPATH: ";
constexpr char kNoMapApplied[] = "none";

bool isMapFile(const std::string& name) {
  constexpr std::string_view kEnd = ".csv";
  for (const std::string_view begin : {std::string_view("correction_"), std::string_view("layer_")}) {
    if (name.size() <= begin.size() + kEnd.size() || name.compare(0, begin.size(), begin) != 0) continue;
    const std::string number = name.substr(begin.size(), name.size() - begin.size() - kEnd.size());
    const bool is_number = number.find_first_not_of("0123456789") == std::string::npos;
    if (is_number && name.compare(name.size() - kEnd.size(), kEnd.size(), kEnd) == 0) return true;
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

/// Digests of the maps that a record says were applied, by layer.
std::map<std::string, std::string> appliedDigests(const std::string& record) {
  const CsvTable table = readCsvTable(record);
  const std::size_t layer = columnOf(table, "layer");
  const std::size_t digest = columnOf(table, "digest");
  std::map<std::string, std::string> applied;
  for (const std::vector<std::string>& row : table.rows)
    if (row[digest] != kNoMapApplied) applied[row[layer]] = row[digest];
  return applied;
}

/// Only those that were applied are left; each must be there.
void keepApplied(std::vector<FiledMap>& maps, const std::string& record) {
  std::map<std::string, std::string> applied = appliedDigests(record);
  std::vector<FiledMap> kept;
  for (FiledMap& each : maps) {
    const auto found = applied.find(std::to_string(each.map.layer));
    if (found == applied.end()) continue;
    if (found->second != digestOf(each.map))
      throw InvalidInput(each.file + ": the map's digest is " + digestOf(each.map) + "; " + record +
                         " says that layer " + found->first + " was laid by " + found->second);
    applied.erase(found);
    kept.push_back(std::move(each));
  }
  if (!applied.empty())
    throw InvalidInput(record + ": layer " + applied.begin()->first + " was laid by map " +
                       applied.begin()->second + ", which is not in the folder");
  maps = std::move(kept);
}

void sortByLayer(std::vector<FiledMap>& maps) {
  std::stable_sort(maps.begin(), maps.end(),
                   [](const FiledMap& a, const FiledMap& b) { return a.map.layer < b.map.layer; });
  for (std::size_t i = 1; i < maps.size(); ++i)
    if (maps[i].map.layer == maps[i - 1].map.layer)
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
    maps.push_back({file, readCorrectionMap(readFile(file), file)});
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

std::string defectOf(const CorrectionMap& map, const ProgrammedToolpath& planned) {
  if (map.toolpath_id != planned.id)
    return "is of toolpath " + map.toolpath_id + "; expected toolpath " + planned.id;
  const std::string layer = "layer " + std::to_string(map.layer);
  const std::vector<ToolpathLayer>& layers = planned.toolpath.layers;
  if (map.layer >= layers.size())
    return "is of " + layer + "; the toolpath has " + std::to_string(layers.size());
  const double most_mm = layers[map.layer].height_mm;
  const std::size_t paths = layers[map.layer].paths.size();
  for (const PathCorrection& path : map.paths) {
    if (path.path >= paths)
      return "of " + layer + " is of path " + std::to_string(path.path) + "; the layer has " +
             std::to_string(paths);
    for (const PlaceCorrection& place : path.stations)
      if (std::abs(place.dz_mm) > most_mm)
        return "of " + layer + " moves the nozzle by " + std::to_string(place.dz_mm) +
               " mm; expected no more than the layer, " + std::to_string(most_mm) + " mm";
  }
  return {};
}

}  // namespace lamina
