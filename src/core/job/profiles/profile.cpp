// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/profile.hpp"

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead = "profile.";
constexpr std::array<ProfileKind, 3> kKinds = {ProfileKind::Machine, ProfileKind::Material,
                                               ProfileKind::Process};

[[noreturn]] void refuseAt(const std::string& path, int line, const std::string& what) {
  throw InvalidConfig(path + ":" + std::to_string(line) + ": " + what);
}

std::vector<std::string> namesIn(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    names.emplace_back(trimmed(text.substr(0, comma)));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return names;
}

ProfileKind kindFrom(const std::string& path, const PlacedSetting& stated) {
  for (const ProfileKind kind : kKinds)
    if (stated.setting.text == toString(kind)) return kind;
  refuseAt(path, stated.line,
           "profile.kind is '" + stated.setting.text + "'; must be one of machine | material | process");
}

void readHead(const PlacedSetting& stated, Profile& profile) {
  const std::string key = stated.setting.key.substr(kHead.size());
  const std::string& text = stated.setting.text;
  if (key == "kind") {
    profile.kind = kindFrom(profile.path, stated);
  } else if (key == "name") {
    profile.name = text;
  } else if (key == "about") {
    profile.about = text;
  } else if (key == "inherits") {
    profile.inherits = text;
    profile.inherits_line = stated.line;
  } else if (key == "for_machines") {
    profile.for_machines = namesIn(text);
  } else {
    refuseAt(profile.path, stated.line,
             "unknown key 'profile." + key + "'; must be one of kind, name, about, inherits, for_machines");
  }
}

}  // namespace

const char* toString(ProfileKind kind) {
  constexpr std::array<const char*, 3> kNames = {"machine", "material", "process"};
  return kNames[static_cast<std::size_t>(kind)];
}

Profile readProfile(const std::string& path) {
  Profile profile;
  profile.path = path;
  bool has_kind = false;
  for (PlacedSetting& stated : placedSettingsFromYaml(readFile(path, kMostSettingsBytes), path)) {
    const std::string& key = stated.setting.key;
    if (key.compare(0, kHead.size(), kHead) == 0) {
      readHead(stated, profile);
      has_kind = has_kind || key == "profile.kind";
      continue;
    }
    const fs::path named = stated.setting.text;
    if (key == "machine.urdf" && !named.empty() && named.is_relative())
      stated.setting.text = (fs::path(path).parent_path() / named).lexically_normal().string();
    profile.settings.push_back(std::move(stated));
  }
  if (!has_kind || profile.name.empty())
    refuseAt(path, 1, "no profile; expected 'profile: {kind: machine | material | process, name: ...}'");
  return profile;
}

}  // namespace lamina
