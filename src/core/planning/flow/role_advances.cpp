// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/flow/role_advances.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr double kMostAdvance = 10.0;  // s, as of all roles

[[noreturn]] void refuse(const std::string& part, const std::string& expected) {
  throw InvalidConfig("flow.advance_by_role holds '" + part + "'; expected " + expected);
}

PathRole roleOf(const std::string& name, const std::string& part) {
  try {
    return pathRoleFromString(name);
  } catch (const InvalidInput& fault) {
    refuse(part, std::string("a role: ") + fault.what());
  }
}

double secondsOf(std::string_view text, const std::string& part) {
  double seconds = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seconds);
  const bool is_number = read.ec == std::errc{} && read.ptr == text.data() + text.size();
  if (!is_number || !(seconds >= 0.0 && seconds <= kMostAdvance))
    refuse(part, "a time in [0, 10] s after '='");
  return seconds;
}

}  // namespace

bool hasAdvance(const FlowSettings& settings) {
  const std::array<double, kPathRoles> advances = advancesOf(settings);
  return std::any_of(advances.begin(), advances.end(), [](double advance_s) { return advance_s > 0.0; });
}

std::array<double, kPathRoles> advancesOf(const FlowSettings& settings) {
  std::array<double, kPathRoles> advances{};
  advances.fill(settings.advance_s);
  std::istringstream parts(settings.advance_by_role);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::string_view whole = trimmed(part);
    const std::size_t sign = whole.find('=');
    if (sign == std::string_view::npos)
      refuse(std::string(whole), "a role, '=' and a time, as outer_wall=0.04");
    const PathRole role = roleOf(std::string(trimmed(whole.substr(0, sign))), std::string(whole));
    advances[static_cast<std::size_t>(role)] = secondsOf(trimmed(whole.substr(sign + 1)), std::string(whole));
  }
  return advances;
}

}  // namespace lamina
