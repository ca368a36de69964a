// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/layered_settings.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "job/annotations/words_of_dialect.hpp"
#include "job/profiles/profile_suggestion.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/profiles/machine_defaults.hpp"
#include "lamina/job/profiles/stated_settings.hpp"
#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {
namespace {

std::string placeOf(const std::string& path, int line) { return path + ":" + std::to_string(line); }

bool isOneOf(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Sets settings, one source after the other, and notes where each came from.
class LayeredLoad {
 public:
  explicit LayeredLoad(LayeredSettings& layered) : layered_(layered) { describe(schema_, layered.settings); }

  void set(const SettingText& setting, const std::string& layer, const std::string& place) {
    schema_.set(setting.key, setting.text);
    const Setting* const known = schema_.find(setting.key);
    layered_.origins[known->key].push_back({layer, place, known->get()});
  }

  void setPlaced(const PlacedSetting& placed, const std::string& layer, const std::string& path) {
    const std::string place = placeOf(path, placed.line);
    try {
      set(placed.setting, layer, place);
    } catch (const InvalidConfig& error) {
      throw InvalidConfig(place + ": " + error.what());
    }
  }

  void setProfiles(const std::vector<Profile>& chain, const std::string& layer) {
    for (const Profile& profile : chain)
      for (const PlacedSetting& placed : profile.settings) setPlaced(placed, layer, profile.path);
  }

  void setConfig(const std::string& path) {
    applySettings(schema_, path, {});
    for (const PlacedSetting& placed : placedSettingsFromYaml(readFile(path, kMostSettingsBytes), path))
      setPlaced(placed, "--config", path);
  }

  /// What nobody has stated follows from the machine, and stands where that is said of it.
  void setMachineDefaults() {
    const StatedKeys stated = statedKeys();
    for (const MachineDefault& each : machineDefaults(layered_.settings, stated))
      set(each.setting, each.follows, placeOfKey(each.follows));
  }

  /// What nobody has typed gives way to the slicing mode.
  void leaveOutByMode() {
    GivingWay& giving_way = layered_.settings.giving_way;
    giving_way.keys = keysGivingWay(statedKeys().typed);
    const std::vector<SettingText> left_out = leftOut(layered_.settings);
    giving_way.notes = withoutLeftOut(layered_.settings).giving_way.notes;
    for (const SettingText& each : left_out) set(each, kMode, placeOfKey(kMode));
  }

 private:
  static constexpr const char* kMode = "slicing.mode";

  StatedKeys statedKeys() const {
    StatedKeys stated;
    for (const auto& [key, said] : layered_.origins) {
      stated.anywhere.insert(key);
      if (said.back().layer == "--config" || said.back().layer == "--set") stated.typed.insert(key);
    }
    return stated;
  }

  std::string placeOfKey(const std::string& key) const {
    const auto found = layered_.origins.find(key);
    return found == layered_.origins.end() ? "" : found->second.back().place;
  }

  LayeredSettings& layered_;
  SettingsSchema schema_;
};

/// The profiles of a machine; none if it has none.
std::vector<Profile> loadMachine(LayeredLoad& load, const std::string& machine,
                                 const ProfileLibrary& library) {
  if (machine.empty()) return {};
  const bool is_profile = library.has(ProfileKind::Machine, machine);
  if (!is_profile && isOneOf(kinematicModelNames(), machine)) {
    load.set({"machine.name", machine}, "--machine", "");
    return {};
  }
  if (std::filesystem::path(machine).extension() == ".urdf" || (!is_profile && holdsCell(machine))) {
    load.set({"machine.urdf", machine}, "--machine", "");
    return {};
  }
  if (!is_profile && std::filesystem::path(machine).extension() != ".yaml") {
    const std::string suggested = profileSuggestion(library.names(ProfileKind::Machine), machine);
    throw InvalidConfig("there is no machine '" + machine + "'; expected a profile, one of " +
                        listed(library.names(ProfileKind::Machine)) + "; a machine, one of " +
                        listed(kinematicModelNames()) +
                        "; or a file: a profile or a cell (.yaml), a description (.urdf)" + suggested);
  }
  std::vector<Profile> chain = library.find(ProfileKind::Machine, machine);
  load.setProfiles(chain, "--machine");
  return chain;
}

/// A machine fits if the profile is for it, or for one that it inherits from.
void requireForMachine(const Profile& profile, const std::vector<Profile>& machine) {
  if (profile.for_machines.empty() || machine.empty()) return;
  const bool fits = std::any_of(machine.begin(), machine.end(), [&](const Profile& each) {
    return isOneOf(profile.for_machines, each.name);
  });
  if (!fits)
    throw InvalidConfig(profile.path + ": " + toString(profile.kind) + " '" + profile.name + "' is for " +
                        listed(profile.for_machines) + ", not for '" + machine.back().name + "'");
}

void loadProfile(LayeredLoad& load, ProfileKind kind, const std::string& name, const ProfileLibrary& library,
                 const std::vector<Profile>& machine) {
  if (name.empty()) return;
  const std::vector<Profile> chain = library.find(kind, name);
  for (const Profile& profile : chain) requireForMachine(profile, machine);
  load.setProfiles(chain, "--" + std::string(toString(kind)));
}

/// Sets what a source states at a place.
void setPlacedIn(SettingsSchema& schema, const PlacedSetting& placed, const std::string& path) {
  try {
    schema.set(placed.setting.key, placed.setting.text);
  } catch (const InvalidConfig& error) {
    throw InvalidConfig(placeOf(path, placed.line) + ": " + error.what());
  }
}

/// Whether the key stands in the text as a word.
bool names(const std::string& text, const std::string& key) {
  const auto isPart = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
  };
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const std::size_t end = at + key.size();
    if ((at == 0 || !isPart(text[at - 1])) && (end == text.size() || !isPart(text[end]))) return true;
  }
  return false;
}

/// Where a layer stands in the order in which they count.
std::size_t rankOf(const SettingOrigin& said) {
  constexpr std::array<const char*, 6> kLayers = {"--like",    "--machine", "--material",
                                                  "--process", "--config",  "--set"};
  return static_cast<std::size_t>(std::find(kLayers.begin(), kLayers.end(), said.layer) - kLayers.begin());
}

/// @throws InvalidConfig if a machine is named where a description that was stated before it would count
void requireOneMachine(const LayeredSettings& layered) {
  const auto name = layered.origins.find("machine.name");
  const auto description = layered.origins.find("machine.urdf");
  if (name == layered.origins.end() || description == layered.origins.end()) return;
  const SettingOrigin& described = description->second.back();
  const SettingOrigin& named = name->second.back();
  if (described.text.empty() || rankOf(named) <= rankOf(described)) return;
  throw InvalidConfig("machine.name is " + named.text + " by " + named.layer +
                      ", but machine.urdf, which counts, is " + described.text + " by " + described.layer +
                      "; expected one machine, as by --machine " + named.text);
}

}  // namespace

std::vector<SettingOrigin> LayeredSettings::explain(const std::string& key) const {
  JobSettings defaults;
  SettingsSchema schema;
  describe(schema, defaults);
  const Setting* const setting = schema.find(key);
  if (setting == nullptr) schema.set(key, "");
  std::vector<SettingOrigin> said = {{"built-in", "", setting->get()}};
  const auto found = origins.find(setting->key);
  if (found != origins.end()) said.insert(said.end(), found->second.begin(), found->second.end());
  return said;
}

LayeredSettings loadLayered(const SettingsSources& sources, const ProfileLibrary& library) {
  LayeredSettings layered;
  LayeredLoad load(layered);
  if (!sources.like.empty())
    for (const PlacedSetting& placed : statedSettings(sources.like))
      load.setPlaced(placed, "--like", sources.like);
  const std::vector<Profile> machine = loadMachine(load, sources.machine, library);
  loadProfile(load, ProfileKind::Material, sources.material, library, machine);
  loadProfile(load, ProfileKind::Process, sources.process, library, machine);
  if (!sources.config.empty()) load.setConfig(sources.config);
  for (const SettingText& setting : sources.overrides) load.set(setting, "--set", "");
  layered.settings.program.is_diameter_given = givesFilamentDiameter(sources.overrides);
  requireOneMachine(layered);
  load.setMachineDefaults();
  load.leaveOutByMode();
  return layered;
}

void applyProfiles(SettingsSchema& schema, const SettingsSources& sources, const ProfileLibrary& library) {
  const std::vector<Profile> machine = library.has(ProfileKind::Machine, sources.machine)
                                           ? library.find(ProfileKind::Machine, sources.machine)
                                           : std::vector<Profile>();
  for (const auto& [kind, name] : {std::pair(ProfileKind::Material, sources.material),
                                   std::pair(ProfileKind::Process, sources.process)}) {
    if (name.empty()) continue;
    for (const Profile& profile : library.find(kind, name)) {
      requireForMachine(profile, machine);
      for (const PlacedSetting& placed : profile.settings) setPlacedIn(schema, placed, profile.path);
    }
  }
}

void validate(const LayeredSettings& layered) { validate(layered, ""); }

void validate(const LayeredSettings& layered, const std::string& output) {
  try {
    validate(layered.settings);
    requireWordsOfDialect(output, layered.settings);
  } catch (const InvalidConfig& error) {
    std::string message = error.what();
    std::vector<std::string> places;
    for (const auto& [key, said] : layered.origins)
      if (!said.back().place.empty() && names(message, key))
        places.push_back(key + " at " + said.back().place);
    throw InvalidConfig(places.empty() ? message : message + " (" + listed(places) + ")");
  }
}

}  // namespace lamina
