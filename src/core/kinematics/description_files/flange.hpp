// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <string>

namespace lamina {

/// Name of the link at the end of an arm: the given one, else tool0, else flange, else the tip of the longest
/// chain.
/// @param named  empty for none
/// @throws InvalidConfig if there is no link of that name
std::string flangeOf(const urdf::ModelInterface& model, const std::string& named);

/// Cosine of the angle between the flange's z and the axis of the last joint that moves the flange.
/// @throws InvalidConfig if no joint moves it
double flangeCosine(const urdf::ModelInterface& model, const std::string& flange);

}  // namespace lamina
