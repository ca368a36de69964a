// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/strict_yaml.hpp"

namespace lamina {

/// Limits of a joint that a cell file states in place of those of the description.
struct ReplacedLimit {
  std::string joint;
  std::optional<double> lower_deg;
  std::optional<double> upper_deg;
  std::optional<double> deg_s;
  bool may_widen = false;  ///< whether they may be wider or faster than those of the description
};

/// Reads `limits`: joints by their names, each with lower_deg, upper_deg, deg_s, wider.
/// @throws InvalidConfig naming file, line and key on any other content
std::vector<ReplacedLimit> replacedLimitsFrom(const StrictYaml& node);

/// A description (URDF) with the limits replaced. A joint of type `continuous` for which both bounds are
/// stated becomes `revolute`. Text that is no URDF is returned unchanged.
/// @throws InvalidConfig naming joint and values if the description has no such rotary joint, or if a limit
///   is wider or faster than the description's without `may_widen`
std::string withReplacedLimits(const std::string& urdf, const std::vector<ReplacedLimit>& limits);

}  // namespace lamina
