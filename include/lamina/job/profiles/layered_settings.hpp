// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lamina/job/job_settings.hpp"
#include "lamina/job/profiles/profile_library.hpp"

namespace lamina {

/// Where the settings of a job come from, in the order in which they count: what comes later wins. Empty
/// names give nothing.
struct SettingsSources {
  std::string like;      ///< program that states its settings (`program.settings_in_file`)
  std::string machine;   ///< profile, or its file (.yaml); a machine of `machine.name`; a file (.urdf)
  std::string material;  ///< profile, or its file (.yaml)
  std::string process;   ///< profile, or its file (.yaml)
  std::string config;    ///< file (YAML)
  std::vector<SettingText> overrides;
};

/// What one source says of a setting.
struct SettingOrigin {
  std::string layer;  ///< "built-in", "--machine", ..., "--set"; the machine's key that it follows from
  std::string place;  ///< "file:line"; empty where there is no file
  std::string text;   ///< the value
};

/// Settings of a job, and where each was set.
struct LayeredSettings {
  JobSettings settings;
  std::map<std::string, std::vector<SettingOrigin>> origins;  ///< by key, without those that nobody has set

  /// Everything that was said of a key, the built-in value first: the last one counts.
  /// @throws InvalidConfig if there is no such setting
  std::vector<SettingOrigin> explain(const std::string& key) const;
};

/// The defaults with one source after the other on top, and what follows from the machine
/// (`machineDefaults`); typed is what `config` and `overrides` state.
/// @throws FileError; InvalidConfig as `ProfileLibrary::find`; if a key or value of a profile is none, naming
///   file and line; if a material or process is not meant for the machine; as `loadJobSettings`
LayeredSettings loadLayered(const SettingsSources& sources, const ProfileLibrary& library);

/// As `validate(JobSettings)`; messages end with the places of the settings that they name.
/// @throws InvalidConfig
void validate(const LayeredSettings& layered);

}  // namespace lamina
