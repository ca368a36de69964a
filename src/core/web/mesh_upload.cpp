// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/mesh_upload.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr const char* kSlashes = "/\\";

std::string fieldOf(const ReceivedUpload& upload, const char* name) {
  const auto found = upload.fields.find(name);
  return found == upload.fields.end() ? std::string() : std::string(trimmed(found->second));
}

/// A profile that the cell knows: a file of the host is nobody's to name from the network.
std::string profileOf(const ReceivedUpload& upload, const char* kind) {
  std::string name = fieldOf(upload, kind);
  const bool is_file =
      name.find_first_of(kSlashes) != std::string::npos || std::filesystem::path(name).extension() == ".yaml";
  if (is_file)
    throw InvalidInput(std::string(kind) + " is '" + name + "'; expected the name of a profile, not a file");
  return name;
}

SettingText settingOf(const std::string& line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos)
    throw InvalidInput("the setting '" + line + "' has no '='; expected KEY=VALUE on each line");
  SettingText setting{std::string(trimmed(line.substr(0, equals))),
                      std::string(trimmed(line.substr(equals + 1)))};
  if (setting.key.rfind("machine.", 0) == 0)
    throw InvalidInput("the setting '" + setting.key + "' is the cell's own; expected none of machine.*");
  if (setting.text.find_first_of(kSlashes) != std::string::npos)
    throw InvalidInput("the setting '" + setting.key + "' is '" + setting.text +
                       "'; expected a value that names no folder of the cell's host");
  return setting;
}

}  // namespace

std::string meshSuffix(std::string_view name) {
  constexpr std::array<std::string_view, 6> kSuffixes = {".stl", ".obj", ".ply", ".3mf", ".step", ".stp"};
  const std::string suffix = lowerCase(std::filesystem::path(name).extension().string());
  return std::find(kSuffixes.begin(), kSuffixes.end(), suffix) == kSuffixes.end() ? "" : suffix;
}

DeskMesh meshOf(const ReceivedUpload& upload, const std::string& source) {
  DeskMesh mesh{upload.path, upload.name, fieldOf(upload, "part"), source, {}, {}, {}};
  mesh.material = profileOf(upload, "material");
  mesh.process = profileOf(upload, "process");
  std::istringstream lines(fieldOf(upload, "settings"));
  for (std::string line; std::getline(lines, line);)
    if (!trimmed(line).empty()) mesh.settings.push_back(settingOf(std::string(trimmed(line))));
  return mesh;
}

}  // namespace lamina
