// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/role_values.hpp"

#include <charconv>
#include <sstream>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

[[noreturn]] void refuse(const RoleValueFormat& format, std::string_view part, const std::string& expected) {
  throw InvalidConfig(format.key + " holds '" + std::string(part) + "'; expected " + expected);
}

PathRole roleOf(std::string_view name, std::string_view part, const RoleValueFormat& format) {
  try {
    return pathRoleFromString(std::string(name));
  } catch (const InvalidInput& fault) {
    refuse(format, part, std::string("a role: ") + fault.what());
  }
}

double valueOf(std::string_view text, std::string_view part, const RoleValueFormat& format) {
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = read.ec == std::errc{} && read.ptr == text.data() + text.size();
  if (!is_number || !(value >= 0.0 && value <= format.greatest))
    refuse(format, part, format.value + " after '='");
  return value;
}

}  // namespace

std::array<std::optional<double>, kPathRoles> roleValues(const std::string& list,
                                                         const RoleValueFormat& format) {
  std::array<std::optional<double>, kPathRoles> values;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::string_view whole = trimmed(part);
    const std::size_t sign = whole.find('=');
    if (sign == std::string_view::npos) refuse(format, whole, format.example);
    const PathRole role = roleOf(trimmed(whole.substr(0, sign)), whole, format);
    values[static_cast<std::size_t>(role)] = valueOf(trimmed(whole.substr(sign + 1)), whole, format);
  }
  return values;
}

}  // namespace lamina
