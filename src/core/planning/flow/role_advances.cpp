// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/flow/role_advances.hpp"

#include <algorithm>

#include "planning/role_values.hpp"

namespace lamina {
namespace {

constexpr double kMostAdvance = 10.0;  // s, as of all roles

}  // namespace

bool hasAdvance(const FlowSettings& settings) {
  const std::array<double, kPathRoles> advances = advancesOf(settings);
  return std::any_of(advances.begin(), advances.end(), [](double advance_s) { return advance_s > 0.0; });
}

std::array<double, kPathRoles> advancesOf(const FlowSettings& settings) {
  const auto own =
      roleValues(settings.advance_by_role, {"flow.advance_by_role", kMostAdvance, "a time in [0, 10] s",
                                            "a role, '=' and a time, as outer_wall=0.04"});
  std::array<double, kPathRoles> advances{};
  for (std::size_t role = 0; role < kPathRoles; ++role)
    advances[role] = own[role].value_or(settings.advance_s);
  return advances;
}

}  // namespace lamina
