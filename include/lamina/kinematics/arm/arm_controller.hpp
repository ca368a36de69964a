// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// What a cell file states of the controller of its arm (`cell.controller`).
struct ArmController {
  std::string kind;  ///< one of `kControllerKinds`
  /// For each joint 1, or -1 if the controller counts it against the description; empty if nothing is said.
  std::vector<double> signs;
  std::vector<double> zeros_deg;  ///< value at the description's zero; empty if nothing is said
  std::optional<double> joint_3_from_2;
  std::optional<int> tool_number;
  std::optional<int> frame_number;
};

/// Makes of controllers, by the languages of their programs: RAPID, KRL, Fanuc's listings, INFORM, URScript.
inline constexpr std::array<const char*, 5> kControllerKinds = {"abb", "kuka", "fanuc", "yaskawa", "ur"};

/// The controller that a description made of a cell file has; nothing if none is stated.
std::optional<ArmController> armController(const std::string& urdf);

/// Checks that programs for the controller of a description are of that kind; one without is of any.
/// @param language  of the program, for the message
/// @throws InvalidConfig otherwise
void requireControllerKind(const std::string& urdf, const std::string& kind, const std::string& language);

}  // namespace lamina
