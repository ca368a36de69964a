// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath with quaternions of one sign from run to run, and travels that turn from the end of one run
/// to the start of the next: by their own tool axes where these lead from one to the other, else in
/// proportion to their length.
Toolpath withTravelsOriented(Toolpath toolpath);

}  // namespace lamina
