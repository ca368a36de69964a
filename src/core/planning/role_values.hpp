// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How a setting with values by role is described in error messages.
struct RoleValueFormat {
  std::string key;
  double greatest = 1.0;
  std::string value;    ///< "a share in [0, 1]"
  std::string example;  ///< "a role, '=' and a share, as top_skin=0.8"
};

/// Parses a list such as "outer_wall=0.04, infill=0.06" into values by role; none for roles that the list
/// does not name.
/// @throws InvalidConfig if a part is not a role, '=' and a number from 0 to the greatest
std::array<std::optional<double>, kPathRoles> roleValues(const std::string& list,
                                                         const RoleValueFormat& format);

}  // namespace lamina
