// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description_files/package_path.hpp"

#include <tinyxml.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr char kPackageScheme[] = "package://";
constexpr char kFileScheme[] = "file://";

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

/// Name that a folder's package.xml gives it; that of the folder if there is no such file.
std::string packageName(const fs::path& folder) {
  TiXmlDocument document;
  if (!document.LoadFile((folder / "package.xml").c_str())) return folder.filename().string();
  const TiXmlElement* name = TiXmlHandle(&document).FirstChild("package").FirstChild("name").ToElement();
  const char* text = name != nullptr ? name->GetText() : nullptr;
  return text != nullptr ? text : "";
}

bool isPackage(const fs::path& folder, const std::string& name) {
  std::error_code error;
  return fs::is_directory(folder, error) && packageName(folder) == name;
}

/// The folder, or one directly within it; those within by their names, so that the choice is always the same.
std::optional<std::string> packageIn(const fs::path& folder, const std::string& name) {
  if (isPackage(folder, name)) return folder.string();
  if (isPackage(folder / name, name)) return (folder / name).string();
  std::error_code error;
  std::vector<fs::path> within;
  for (const auto& entry : fs::directory_iterator(folder, error)) within.push_back(entry.path());
  std::sort(within.begin(), within.end());
  for (const fs::path& each : within)
    if (fs::exists(each / "package.xml", error) && isPackage(each, name)) return each.string();
  return std::nullopt;
}

}  // namespace

PackagePath::PackagePath(const std::vector<std::string>& packages, const std::string& description) {
  own_folder_ = fs::absolute(description).lexically_normal().parent_path().string();
  for (const std::string& folder : packages) folders_.push_back(fs::absolute(folder).lexically_normal());
  for (fs::path folder = own_folder_; folder.has_relative_path(); folder = folder.parent_path())
    folders_.push_back(folder);
  const char* ros = std::getenv("ROS_PACKAGE_PATH");  // NOLINT(concurrency-mt-unsafe): nothing here sets it
  std::istringstream listed(ros != nullptr ? ros : "");
  for (std::string folder; std::getline(listed, folder, ':');)
    if (!folder.empty()) folders_.push_back(folder);
}

std::optional<std::string> PackagePath::package(const std::string& name) const {
  for (const std::string& folder : folders_)
    if (auto found = packageIn(folder, name)) return found;
  return std::nullopt;
}

std::optional<std::string> PackagePath::resolved(const std::string& name) const {
  if (startsWith(name, kFileScheme)) return name.substr(sizeof kFileScheme - 1);
  if (!startsWith(name, kPackageScheme)) return (fs::path(own_folder_) / name).lexically_normal().string();
  const std::string rest = name.substr(sizeof kPackageScheme - 1);
  const std::size_t slash = std::min(rest.find('/'), rest.size());
  const auto folder = package(rest.substr(0, slash));
  if (!folder) return std::nullopt;
  return *folder + rest.substr(slash);
}

}  // namespace lamina
