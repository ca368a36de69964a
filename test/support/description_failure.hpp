// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina::test {

/// Why a description of a machine is refused; empty if it is not.
inline std::string descriptionFailure(const std::string& urdf) {
  try {
    kinematicModelFromUrdf(urdf);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

}  // namespace lamina::test
