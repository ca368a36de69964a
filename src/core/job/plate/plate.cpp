// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/plate/plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/strict_yaml.hpp"
#include "job/file_beside.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"

namespace lamina {
namespace {

constexpr int kMostCopies = 1000;

/// Groups that end with a point, and single keys.
constexpr std::array<std::string_view, 26> kPartSettings = {
    "adaptive.",       "bead.",
    "bridges.",        "brim.",
    "compensation.",   "contour.",
    "feed.",           "hilbert.",
    "hybrid.",         "infill.",
    "overhangs.",      "part.modifiers",
    "perimeters.",     "planning.",
    "raster.",         "seam.",
    "skins.",          "slicing.first_layer_height_mm",
    "slicing.heights", "slicing.layer_height_mm",
    "smoothing.",      "supports.",
    "tool.",           "vase.",
    "voids.",          "walls."};

bool allows(std::string_view entry, const std::string& key) {
  return entry.back() == '.' ? key.compare(0, entry.size(), entry) == 0 : key == entry;
}

Point3 point3From(const StrictYaml& yaml) {
  const std::vector<double> numbers = yaml.numbers();
  if (numbers.size() != 3) yaml.refuse("expected three numbers, [x, y, z]");
  return {numbers[0], numbers[1], numbers[2]};
}

Point2 point2From(const StrictYaml& yaml) {
  const std::vector<double> numbers = yaml.numbers();
  if (numbers.size() != 2) yaml.refuse("expected two numbers, [x, y]");
  return {numbers[0], numbers[1]};
}

void requireOneLine(const StrictYaml& yaml, const std::string& name) {
  if (name.empty() ||
      std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }))
    yaml.refuse("expected a name of one line");
}

PlatePart partFrom(const StrictYaml& yaml, const std::string& folder) {
  PlatePart part;
  for (const auto& [key, value] :
       yaml.entries({"file", "name", "at_mm", "turn_deg", "scale", "copies", "settings", "modifiers"})) {
    if (key == "file") part.file = fileBeside(folder, value.text());
    if (key == "name") {
      part.name = value.text();
      requireOneLine(value, part.name);
    }
    if (key == "at_mm") part.at_mm = point2From(value);
    if (key == "turn_deg") part.turn_deg = point3From(value);
    if (key == "scale") {
      part.scale = value.number();
      if (!(part.scale > 0.0)) value.refuse("expected a factor above 0");
    }
    if (key == "copies") part.copies = value.whole(1, kMostCopies);
    if (key == "settings")
      for (SettingText& setting : value.settings()) part.settings.push_back(std::move(setting));
    if (key == "modifiers") part.settings.push_back({"part.modifiers", fileBeside(folder, value.text())});
  }
  if (part.file.empty()) yaml.refuse("expected the key 'file'");
  if (part.at_mm && part.copies > 1) yaml.refuse("copies have one place, at_mm; expected parts of their own");
  for (const SettingText& setting : part.settings) requirePartSetting(setting, part.file);
  return part;
}

Plate plateFrom(const StrictYaml& yaml, const std::string& folder) {
  Plate plate;
  for (const auto& [key, value] : yaml.entries({"parts", "arrange", "spacing_mm", "order", "labels"})) {
    if (key != "parts") {
      plate.settings.push_back({"plate." + key, value.text()});
      continue;
    }
    for (const StrictYaml& piece : value.pieces()) plate.parts.push_back(partFrom(piece, folder));
  }
  if (plate.parts.empty()) yaml.refuse("expected at least one part in 'parts'");
  return plate;
}

}  // namespace

Plate readPlate(const std::string& yaml, const std::string& source_name, const std::string& folder) {
  try {
    const StrictYaml document(YAML::Load(yaml), source_name, "");
    for (const auto& [key, value] : document.entries({"plate"})) return plateFrom(value, folder);
    document.refuse("expected the key 'plate'");
  } catch (const YAML::Exception& error) {
    throw InvalidConfig(source_name + ":" + std::to_string(error.mark.line + 1) + ": " + error.msg);
  }
}

Plate readPlateFile(const std::string& path) {
  return readPlate(readFile(path, kMostSettingsBytes), path,
                   std::filesystem::path(path).parent_path().string());
}

Plate plateOf(const std::vector<std::string>& files) {
  Plate plate;
  for (const std::string& file : files) {
    plate.parts.emplace_back();
    plate.parts.back().file = file;
  }
  return plate;
}

void requirePartSetting(const SettingText& setting, const std::string& part) {
  if (std::any_of(kPartSettings.begin(), kPartSettings.end(),
                  [&](std::string_view entry) { return allows(entry, setting.key); }))
    return;
  std::string names;
  for (const std::string_view entry : kPartSettings)
    names += (names.empty() ? "" : ", ") + std::string(entry) + (entry.back() == '.' ? "*" : "");
  throw InvalidConfig("part '" + part + "' of the plate has the setting '" + setting.key +
                      "'; a part may have " + names + " for itself");
}

Eigen::Quaterniond rotationOfDegrees(const Point3& turn_deg) {
  const Point3 angles = turn_deg * kDegree;
  return Eigen::AngleAxisd(angles.z(), Point3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Point3::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Point3::UnitX());
}

Eigen::Affine3d standing(const Mesh& mesh, const Eigen::Quaterniond& turn, double scale) {
  Eigen::Affine3d part_from_file = Eigen::Affine3d::Identity();
  part_from_file.linear() = scale * turn.toRotationMatrix();
  Box3 box;
  for (const Point3& vertex : mesh.vertices) box.include(part_from_file * vertex);
  part_from_file.translation() = -Point3(box.centre().x(), box.centre().y(), box.low.z());
  return part_from_file;
}

Mesh transformed(Mesh mesh, const Eigen::Affine3d& by) {
  for (Point3& vertex : mesh.vertices) vertex = by * vertex;
  return mesh;
}

}  // namespace lamina
