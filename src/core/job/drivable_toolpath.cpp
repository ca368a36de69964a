// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/drivable_toolpath.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "lamina/toolpath/process_levels.hpp"
#include "lamina/toolpath/process_support.hpp"

namespace lamina {
namespace {

constexpr char kBy[] = "joint trajectories";
constexpr char kInclined[] = "#LAYER_FRAME:";  // begins the file if layers are inclined
constexpr std::size_t kShownBytes = 40;        // of a line that begins no toolpath

bool beginsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

/// The reader would name the column that is missing; who queues a program wants to know that it is none.
void requireToolpath(std::string_view text) {
  if (beginsWith(text, kCsvHeader) || beginsWith(text, kInclined)) return;
  std::string line(text.substr(0, std::min(text.find_first_of("\r\n"), kShownBytes)));
  for (char& c : line)
    if (c < ' ' || c > '~') c = '?';
  throw InvalidProgram(
      "line 1 is '" + line +
      "'; expected the header of a toolpath, as `lamina slice part.stl -o part.csv` writes it");
}

constexpr const char* kEachItsOwn[] = {"clearance.need", "clearance.report"};
constexpr const char* kClearance = "clearance.";
constexpr const char* kBetween = ": ";  // key and value

std::map<std::string, std::string> valuesIn(const std::string& sheet) {
  std::map<std::string, std::string> values;
  std::istringstream lines(sheet);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(kBetween);
    if (at != std::string::npos) values.emplace(line.substr(0, at), line.substr(at + 2));
  }
  return values;
}

std::string shownValue(const std::map<std::string, std::string>& values, const std::string& key) {
  const auto found = values.find(key);
  return found == values.end() ? "not known" : "'" + found->second + "'";
}

}  // namespace

ToolpathOnBed readToolpathOnBed(const std::string& path, Placement placement, const BuildSpace& space) {
  const std::string text = readTextFile(path);
  requireToolpath(text);
  ToolpathOnBed placed;
  placed.toolpath = readCsv(text, std::filesystem::path(path).stem().string());
  if (placement == Placement::Centre) placed.bed_from_part = placeDeposition(placed.toolpath, space);
  return placed;
}

void requireDrivable(const Toolpath& toolpath) {
  requireSupported(toolpath, {ProcessElement::Fan, ProcessElement::Dwell, ProcessElement::Value}, kBy);
  requireLevels(toolpath, kBy);
}

KinematicModelRun drivableRun(ToolpathOnBed placed, const CheckedMachine& machine,
                              const DriveCheckSettings& settings,
                              const std::function<void(const MachineCheck&)>& found, Progress& progress) {
  requireDrivable(placed.toolpath);
  KinematicModelRun run =
      runOn(machine, std::move(placed.toolpath), placed.bed_from_part, settings.joints, progress);
  const MachineCheck check = checkRun(run, machine, settings.clearance, progress);
  found(check);
  requireClear(check, machine.model());
  return run;
}

std::string driveSettingsSheet(const DriveCheckSettings& settings) {
  DriveCheckSettings copy = settings;
  SettingsSchema schema;
  describe(schema, copy.joints);
  if (copy.clearance.need != ClearanceNeed::Never) describe(schema, copy.clearance);
  std::map<std::string, std::string> values;
  for (const Setting& setting : schema.settings())
    if (std::find(std::begin(kEachItsOwn), std::end(kEachItsOwn), setting.key) == std::end(kEachItsOwn))
      values.emplace(setting.key, setting.get());
  std::string sheet;
  for (const auto& [key, value] : values) sheet.append(key).append(kBetween).append(value).append("\n");
  return sheet;
}

void requireSameDriveSettings(const DriveCheckSettings& unit, const std::string& sheet) {
  const std::map<std::string, std::string> own = valuesIn(driveSettingsSheet(unit));
  const std::map<std::string, std::string> driver = valuesIn(sheet);
  std::set<std::string> keys;
  for (const auto* side : {&own, &driver})
    for (const auto& [key, value] : *side) keys.insert(key);
  std::string differing;
  for (const std::string& key : keys) {
    // Who does not check for collisions does not use these.
    if (beginsWith(key, kClearance) && (own.count(key) == 0 || driver.count(key) == 0)) continue;
    const std::string here = shownValue(own, key);
    const std::string there = shownValue(driver, key);
    if (here != there) differing += key + " is " + here + " for the unit and " + there + " for its driver; ";
  }
  if (differing.empty()) return;
  throw InvalidConfig(differing + "expected them alike: jobs are checked by what they are driven by");
}

}  // namespace lamina
