// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lamina/job/job_settings.hpp"
#include "lamina/job/profiles/profile_library.hpp"

namespace lamina {

/// Sources of a job's settings, in ascending order of precedence: a later one overrides those before. Empty
/// names stand for no source.
struct SettingsSources {
  std::string like;  ///< program whose comments state its settings (`program.settings_in_file`)
  /// Name or file (.yaml) of a profile; a value of `machine.name`; a cell file (.yaml); a URDF (.urdf).
  std::string machine;
  std::string material;                ///< name or file (.yaml) of a profile
  std::string process;                 ///< name or file (.yaml) of a profile
  std::string config;                  ///< YAML file
  std::vector<SettingText> overrides;  ///< in order
};

/// The value that one source states for a setting.
struct SettingOrigin {
  /// Source: "built-in", "--machine", ..., "--set"; or the key of the machine's setting that it follows from.
  std::string layer;
  std::string place;  ///< "file:line"; empty if the source is no file
  std::string text;   ///< the value as text
};

/// Settings of a job, and where each was set.
struct LayeredSettings {
  JobSettings settings;
  /// By key, in ascending precedence; without keys that no source states.
  std::map<std::string, std::vector<SettingOrigin>> origins;

  /// All values stated for a key, in ascending precedence: the built-in value first, the effective value
  /// last.
  /// @throws InvalidConfig if there is no such setting
  std::vector<SettingOrigin> explain(const std::string& key) const;
};

/// Loads the settings of a job: the defaults, overridden by one source after the other, and then what follows
/// from the machine (`machineDefaults`) and what the mode leaves out (`leftOut`), where the keys of `config`
/// and `overrides` count as typed.
/// @throws FileError
/// @throws InvalidConfig as `ProfileLibrary::find` and `loadJobSettings`; if a profile has an unknown key or
///   an invalid value, naming file and line; if a material or process is not meant for the machine; if a
///   later source sets machine.name while machine.urdf of an earlier one would still hold
LayeredSettings loadLayered(const SettingsSources& sources, const ProfileLibrary& library);

/// Sets what the profiles of `sources.material` and `sources.process` state, the material's first.
/// `sources.machine` only names the machine for which the profiles must be meant, if it has a profile.
/// @throws as `loadLayered`
void applyProfiles(SettingsSchema& schema, const SettingsSources& sources, const ProfileLibrary& library);

/// Checks the settings as `validate(const JobSettings&)`. Messages end with the places where the settings
/// that they name were stated.
/// @throws InvalidConfig
void validate(const LayeredSettings& layered);

/// The same, and checks the settings against the format of a program to be written to `output`.
/// @throws InvalidConfig
void validate(const LayeredSettings& layered, const std::string& output);

}  // namespace lamina
