// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "description_warning.hpp"

#include <regex>

namespace lamina {
namespace {

std::string nameOfRobotIn(const std::string& urdf) {
  const std::size_t begin = urdf.find("<robot");
  if (begin == std::string::npos) return "";
  const std::string element = urdf.substr(begin, urdf.find('>', begin) - begin);
  std::smatch name;
  return std::regex_search(element, name, std::regex(R"(\sname\s*=\s*["']([^"']*))")) ? name[1].str() : "";
}

}  // namespace

std::string descriptionWarning(const std::string& present, const std::string& own) {
  const std::string other = nameOfRobotIn(present);
  const std::string machine = nameOfRobotIn(own);
  if (other == machine) return "";
  return "it describes the robot '" + other + "'; expected '" + machine + "', the machine of this node";
}

}  // namespace lamina
