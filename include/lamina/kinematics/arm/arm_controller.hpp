// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// Settings of an arm's controller, from its cell file (`cell.controller`).
struct ArmController {
  std::string kind;  ///< one of `kControllerKinds`
  /// For each joint 1, or -1 if the controller counts it opposite to the description; empty if not stated.
  std::vector<double> signs;
  std::vector<double> zeros_deg;  ///< controller's value at the description's zero; empty if not stated
  std::optional<double> joint_3_from_2;
  std::optional<int> tool_number;
  std::optional<int> frame_number;
};

/// Makes of controllers, by the languages of their programs: RAPID, KRL, Fanuc's listings, INFORM, URScript.
inline constexpr std::array<const char*, 5> kControllerKinds = {"abb", "kuka", "fanuc", "yaskawa", "ur"};

/// The controller stated in a description that was made from a cell file; nothing if none is stated.
std::optional<ArmController> armController(const std::string& urdf);

/// Checks that the controller of a description is of a kind. A description without a controller passes.
/// @param language  of the program, for the message
/// @throws InvalidConfig otherwise
void requireControllerKind(const std::string& urdf, const std::string& kind, const std::string& language);

}  // namespace lamina
