// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/modifiers/modifier.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string_view>

#include "base/strict_yaml.hpp"
#include "job/file_beside.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/job/modifiers/slicer_settings.hpp"

namespace lamina {
namespace {

/// Groups that end with a point, and single keys.
constexpr std::array<std::string_view, 22> kRegionSettings = {"bead.flow",
                                                              "bridges.",
                                                              "contour.",
                                                              "feed.",
                                                              "hilbert.",
                                                              "hybrid.",
                                                              "infill.",
                                                              "perimeters.",
                                                              "raster.",
                                                              "skins.",
                                                              "smoothing.",
                                                              "supports.angle_deg",
                                                              "supports.density",
                                                              "supports.interface_density",
                                                              "supports.raster_angle_deg",
                                                              "supports.under_bridges",
                                                              "supports.use",
                                                              "supports.walls",
                                                              "tool.infill",
                                                              "tool.skin",
                                                              "tool.walls",
                                                              "walls.count"};
/// Walls are one thing all round an island.
constexpr std::array<std::string_view, 3> kLayerSettings = {"overhangs.", "seam.", "walls.order"};
/// Of what is deposited beside the part, whatever region it passes.
constexpr std::array<std::string_view, 3> kAidSettings = {"feed.skirt_mm_s", "feed.support_mm_s",
                                                          "feed.support_interface_mm_s"};

template <std::size_t count>
bool stands(const std::string& key, const std::array<std::string_view, count>& entries) {
  return std::any_of(entries.begin(), entries.end(), [&](std::string_view entry) {
    return entry.back() == '.' ? key.compare(0, entry.size(), entry) == 0 : key == entry;
  });
}

/// Groups as "feed.*".
template <std::size_t count>
std::string listed(const std::array<std::string_view, count>& entries) {
  std::string names;
  for (const std::string_view entry : entries)
    names += (names.empty() ? "" : ", ") + std::string(entry) + (entry.back() == '.' ? "*" : "");
  return names;
}

void requireRegionSettings(const StrictYaml& yaml, const Modifier& modifier) {
  for (const SettingText& setting : modifier.settings) {
    const bool is_of_layers = stands(setting.key, kLayerSettings);
    if (is_of_layers && !modifier.heights_mm)
      yaml.refuse("'" + setting.key + "' holds for whole layers only; expected from_mm and to_mm");
    if ((!is_of_layers && !stands(setting.key, kRegionSettings)) || stands(setting.key, kAidSettings))
      yaml.refuse("'" + setting.key + "' cannot be set for a region; expected flow, tool or one of " +
                  listed(kRegionSettings) + ", but for " + listed(kAidSettings) +
                  "; over a range of heights also " + listed(kLayerSettings));
  }
}

/// What `tool` and `flow` stand for.
std::vector<SettingText> writtenOut(const std::vector<SettingText>& settings) {
  std::vector<SettingText> all;
  for (const SettingText& setting : settings) {
    if (setting.key == "tool")
      for (const char* const key : {"tool.walls", "tool.infill", "tool.skin"})
        all.push_back({key, setting.text});
    else
      all.push_back({setting.key == "flow" ? "bead.flow" : setting.key, setting.text});
  }
  return all;
}

ModifierKind kindFrom(const StrictYaml& yaml) {
  const std::string name = yaml.text();
  if (name == "settings") return ModifierKind::Settings;
  if (name == "negative") return ModifierKind::Negative;
  if (name == "support_blocker") return ModifierKind::SupportBlocker;
  if (name == "support_enforcer") return ModifierKind::SupportEnforcer;
  if (name == "seam_here") return ModifierKind::SeamHere;
  yaml.refuse("kind is '" + name +
              "'; expected settings, negative, support_blocker, support_enforcer or seam_here");
}

Box3 boxFrom(const StrictYaml& yaml) {
  const std::vector<StrictYaml> corners = yaml.pieces();
  Box3 box;
  for (const StrictYaml& corner : corners) {
    const std::vector<double> numbers = corner.numbers();
    if (numbers.size() != 3) corner.refuse("expected three numbers, [x, y, z]");
    box.include({numbers[0], numbers[1], numbers[2]});
  }
  if (corners.size() != 2 || !(box.size().minCoeff() > 0.0))
    yaml.refuse("expected two corners of a box, [[x, y, z], [x, y, z]], that differ in x, y and z");
  return box;
}

void requireOneRegion(const StrictYaml& yaml, const Modifier& modifier) {
  const int regions = static_cast<int>(!modifier.mesh.empty()) + static_cast<int>(modifier.box.has_value()) +
                      static_cast<int>(modifier.heights_mm.has_value());
  if (regions != 1) yaml.refuse("expected one of mesh, box_mm, and from_mm with to_mm");
  if (modifier.heights_mm && !(modifier.heights_mm->first < modifier.heights_mm->second))
    yaml.refuse("from_mm is " + numberText(modifier.heights_mm->first) + " and to_mm " +
                numberText(modifier.heights_mm->second) + "; expected the former below the latter");
  if (modifier.kind == ModifierKind::Settings && modifier.settings.empty())
    yaml.refuse("expected 'settings', or a kind of negative, support_blocker, support_enforcer or seam_here");
  if (modifier.kind != ModifierKind::Settings && !modifier.settings.empty())
    yaml.refuse("expected no settings: only a modifier of kind 'settings' has them");
}

Modifier modifierFrom(const StrictYaml& yaml, const std::string& folder) {
  Modifier modifier;
  const auto heights = [&modifier]() -> std::pair<double, double>& {
    if (!modifier.heights_mm)
      modifier.heights_mm.emplace(-std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::infinity());
    return *modifier.heights_mm;
  };
  for (const auto& [key, value] : yaml.entries({"mesh", "box_mm", "from_mm", "to_mm", "kind", "settings"})) {
    if (key == "mesh") modifier.mesh = fileBeside(folder, value.text());
    if (key == "box_mm") modifier.box = boxFrom(value);
    if (key == "from_mm") heights().first = value.number();
    if (key == "to_mm") heights().second = value.number();
    if (key == "kind") modifier.kind = kindFrom(value);
    if (key == "settings") modifier.settings = writtenOut(value.settings());
  }
  requireOneRegion(yaml, modifier);
  requireRegionSettings(yaml, modifier);
  return modifier;
}

ModifierKind kindOf(VolumeKind kind) {
  switch (kind) {
    case VolumeKind::Modifier:
    case VolumeKind::Object:
    case VolumeKind::Material:
    case VolumeKind::Heights:
      break;
    case VolumeKind::Negative:
      return ModifierKind::Negative;
    case VolumeKind::SupportBlocker:
      return ModifierKind::SupportBlocker;
    case VolumeKind::SupportEnforcer:
      return ModifierKind::SupportEnforcer;
  }
  return ModifierKind::Settings;
}

bool liesBesideOthers(const std::string& strategy) {
  const InfillStrategy fill = infillStrategy(strategy);
  return fill.deposit == Deposit::Bead && fill.link == LayerLink::Travel;
}

/// What slicers state of every object and piece of it: without what the part has anyway, unless a modifier
/// before says something else.
std::vector<SettingText> onlyOthers(const std::vector<SettingText>& settings, const JobSettings& of_part,
                                    const std::vector<Modifier>& before) {
  JobSettings usual = of_part;
  SettingsSchema schema;
  describe(schema, usual);
  std::vector<SettingText> others;
  for (const SettingText& setting : settings) {
    const std::string of_part_text = schema.find(setting.key)->get();
    schema.set(setting.key, setting.text);
    const bool is_set_before = std::any_of(before.begin(), before.end(), [&](const Modifier& modifier) {
      return std::any_of(modifier.settings.begin(), modifier.settings.end(),
                         [&](const SettingText& other) { return other.key == setting.key; });
    });
    if (is_set_before || schema.find(setting.key)->get() != of_part_text) others.push_back(setting);
    schema.set(setting.key, of_part_text);
  }
  return others;
}

bool isSoundMesh(const Mesh& mesh) {
  try {
    requireSound(mesh);
    return true;
  } catch (const InvalidMesh&) {
    return false;
  }
}

/// Pieces of the part are counted by themselves, and what is no part of it.
std::string nameOf(const MeshVolume& volume, const std::vector<MeshVolume>& all) {
  if (!volume.of.empty()) return volume.of;
  const bool is_piece = volume.kind == VolumeKind::Material;
  const auto before = std::count_if(all.data(), &volume, [&](const MeshVolume& other) {
    return other.of.empty() && (other.kind == VolumeKind::Material) == is_piece;
  });
  return (is_piece ? "piece " : "volume ") + std::to_string(before);
}

/// What of a volume's settings holds here, and what is to be reported of the rest.
struct VolumeSettings {
  std::vector<SettingText> settings;
  std::vector<std::string> notes;
};

VolumeSettings settingsOf(const MeshVolume& volume, const std::string& place, const JobSettings& of_part,
                          const std::vector<Modifier>& before) {
  TranslatedSettings translation = translated(volume.settings, of_part);
  VolumeSettings found;
  found.settings = volume.kind == VolumeKind::Modifier ? std::move(translation.settings)
                                                       : onlyOthers(translation.settings, of_part, before);
  const std::string& strategy = of_part.planning.infill.strategy;
  const auto leaveOut = [&](const std::string& why) {
    if (!found.settings.empty()) found.notes.push_back(place + ": its settings are left out: " + why);
    found.settings.clear();
  };
  if (!liesBesideOthers(strategy)) {
    leaveOut("infill.strategy '" + strategy + "' cannot lie beside others");
    return found;
  }
  if (!translation.left_out.empty())
    found.notes.push_back(place + ": settings of another slicer that no region has here are left out: " +
                          lamina::listed(translation.left_out));
  // The part is repaired as a whole, and not its pieces.
  if (volume.kind == VolumeKind::Material && !isSoundMesh(volume.mesh))
    leaveOut("its own surface is not closed");
  return found;
}

}  // namespace

std::vector<Modifier> readModifiers(const std::string& yaml, const std::string& source_name,
                                    const std::string& folder) {
  std::vector<Modifier> modifiers;
  try {
    const StrictYaml document(YAML::Load(yaml), source_name, "");
    for (const auto& [key, value] : document.entries({"modifiers"}))
      for (const StrictYaml& piece : value.pieces()) {
        modifiers.push_back(modifierFrom(piece, folder));
        modifiers.back().place = source_name + ", modifier " + std::to_string(modifiers.size() - 1);
      }
  } catch (const YAML::Exception& error) {
    throw InvalidConfig(source_name + ":" + std::to_string(error.mark.line + 1) + ": " + error.msg);
  }
  return modifiers;
}

VolumeModifiers modifiersOf(const std::vector<MeshVolume>& volumes, const JobSettings& of_part) {
  VolumeModifiers found;
  for (const MeshVolume& volume : volumes) {
    Modifier modifier;
    modifier.kind = kindOf(volume.kind);
    modifier.place = nameOf(volume, volumes) + " of the part's file";
    if (modifier.kind == ModifierKind::Settings) {
      VolumeSettings own = settingsOf(volume, modifier.place, of_part, found.modifiers);
      found.notes.insert(found.notes.end(), own.notes.begin(), own.notes.end());
      if (own.settings.empty()) continue;
      modifier.settings = std::move(own.settings);
    }
    modifier.volume = volume.mesh;
    found.modifiers.push_back(std::move(modifier));
  }
  return found;
}

std::vector<Modifier> readModifiersFile(const std::string& path) {
  return readModifiers(readFile(path, kMostSettingsBytes), path,
                       std::filesystem::path(path).parent_path().string());
}

}  // namespace lamina
