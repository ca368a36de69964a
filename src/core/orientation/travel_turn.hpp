// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath with orientations made continuous: the signs of quaternions are consistent from run to run,
/// and travels turn from the end of one run to the start of the next, along their own tool axes if these lead
/// from one to the other, otherwise in proportion to length.
Toolpath withTravelsOriented(Toolpath toolpath);

}  // namespace lamina
