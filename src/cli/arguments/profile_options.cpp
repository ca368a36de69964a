// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/profile_options.hpp"

namespace lamina::cli {

void addMachineOption(CLI::App& subcommand, ProfileOptions& options) {
  subcommand.add_option(
      "--machine", options.machine,
      "Profile of the machine (lamina profiles), machine of machine.name, or a file (.yaml, .urdf)");
}

void addProfileOptions(CLI::App& subcommand, ProfileOptions& options) {
  addMachineOption(subcommand, options);
  subcommand.add_option("--material", options.material, "Profile of the material, or its file (.yaml)");
  subcommand.add_option("--process", options.process, "Profile of the process, or its file (.yaml)");
  subcommand.add_option("--like", options.like,
                        "Program whose settings are repeated; those of profiles and files count before them");
}

LayeredSettings layeredSettingsFrom(const ProfileOptions& profiles, const SettingOptions& options) {
  return loadLayered({profiles.like, profiles.machine, profiles.material, profiles.process, options.config,
                      overridesFrom(options.assignments)},
                     ProfileLibrary(profileFolders()));
}

}  // namespace lamina::cli
