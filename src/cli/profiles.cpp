// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "lamina/job/profiles/profile_library.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

constexpr std::array<ProfileKind, 3> kProfileKinds = {ProfileKind::Machine, ProfileKind::Material,
                                                      ProfileKind::Process};

void listProfiles(OutputFormat format) {
  const ProfileLibrary library(profileFolders());
  nlohmann::ordered_json json;
  for (const ProfileKind kind : kProfileKinds) {
    nlohmann::ordered_json& entries = json[toString(kind)] = nlohmann::ordered_json::array();
    for (const std::string& name : library.names(kind)) {
      const Profile profile = library.find(kind, name).back();
      entries.push_back({{"name", name},
                         {"about", profile.about},
                         {"inherits", profile.inherits},
                         {"for_machines", profile.for_machines},
                         {"file", profile.path}});
      if (format == OutputFormat::Text)
        std::printf("%-10s%-24s%s\n", toString(kind), name.c_str(), profile.about.c_str());
    }
  }
  if (format == OutputFormat::Json) std::printf("%s\n", json.dump(2).c_str());
}

}  // namespace

void addProfiles(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand =
      app.add_subcommand("profiles", "List the profiles of machines, materials and processes");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback([&chosen] { chosen.run = [&chosen] { listProfiles(chosen.format); }; });
}

}  // namespace lamina::cli
