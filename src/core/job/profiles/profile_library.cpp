// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/profile_library.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "base/module.hpp"
#include "job/profiles/profile_suggestion.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/output_files.hpp"

namespace lamina {
namespace {

constexpr const char* kSuffix = ".yaml";

std::string folderOf(ProfileKind kind) {
  return kind == ProfileKind::Process ? "processes" : std::string(toString(kind)) + "s";
}

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string usersFolder() {
  std::string config = environment("XDG_CONFIG_HOME");
  if (config.empty() && !environment("HOME").empty()) config = environment("HOME") + "/.config";
  return config.empty() ? "" : config + "/lamina/profiles";
}

/// Of a profile that was found by its name, or read from a file that was named.
void requireKind(const Profile& profile, ProfileKind kind) {
  if (profile.kind != kind)
    throw InvalidConfig(profile.path + ": a profile of kind '" + toString(profile.kind) + "'; expected '" +
                        toString(kind) + "'");
}

void requireNoCycle(const std::vector<Profile>& chain, const std::string& path) {
  const Profile& last = chain.back();
  for (const Profile& profile : chain)
    if (isSameFile(profile.path, path))
      throw InvalidConfig(last.path + ":" + std::to_string(last.inherits_line) + ": inherits from '" +
                          last.inherits + "', which inherits from this one");
}

}  // namespace

std::vector<std::string> profileFolders() {
  std::vector<std::string> folders;
  std::istringstream named(environment("LAMINA_PROFILES"));
  for (std::string folder; std::getline(named, folder, ':');) {
    if (folder.empty()) continue;
    if (!std::filesystem::is_directory(folder))
      throw InvalidConfig("LAMINA_PROFILES names '" + folder + "'; expected a folder with profiles");
    folders.push_back(folder);
  }
  if (const std::string own = usersFolder(); !own.empty()) folders.push_back(own);
  const std::filesystem::path shipped = std::filesystem::path(folderOfTheCore()) / "../share/lamina/profiles";
  folders.push_back(shipped.lexically_normal().string());
  return folders;
}

std::vector<std::string> ProfileLibrary::names(ProfileKind kind) const {
  std::set<std::string> names;
  for (const std::string& folder : folders_) {
    std::error_code missing;
    for (const auto& file :
         std::filesystem::directory_iterator(std::filesystem::path(folder) / folderOf(kind), missing))
      if (file.path().extension() == kSuffix) names.insert(file.path().stem().string());
  }
  return {names.begin(), names.end()};
}

std::string ProfileLibrary::pathOf(ProfileKind kind, const std::string& name) const {
  if (name.empty() || name.find('/') != std::string::npos) return "";
  for (const std::string& folder : folders_) {
    const std::filesystem::path file = std::filesystem::path(folder) / folderOf(kind) / (name + kSuffix);
    if (std::filesystem::exists(file)) return file.string();
  }
  return "";
}

std::vector<Profile> ProfileLibrary::find(ProfileKind kind, const std::string& name) const {
  std::vector<Profile> chain;
  for (std::string next = name; !next.empty(); next = chain.back().inherits) {
    std::string path = pathOf(kind, next);
    const bool is_named = !path.empty();
    if (!is_named && std::filesystem::path(next).extension() == kSuffix) {
      const bool is_beside = !chain.empty() && std::filesystem::path(next).is_relative();
      path = is_beside ? (std::filesystem::path(chain.back().path).parent_path() / next).string() : next;
    }
    if (path.empty())
      throw InvalidConfig(
          (chain.empty() ? "" : chain.back().path + ":" + std::to_string(chain.back().inherits_line) + ": ") +
          "there is no " + toString(kind) + " '" + next + "'; expected one of " + listed(names(kind)) +
          ", or a file (.yaml)" + profileSuggestion(names(kind), next));
    if (!chain.empty()) requireNoCycle(chain, path);
    chain.push_back(readProfile(path));
    requireKind(chain.back(), kind);
    if (is_named && chain.back().name != next)
      throw InvalidConfig(path + ": profile.name is '" + chain.back().name + "'; expected '" + next +
                          "' as the file");
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace lamina
