// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <string>

namespace lamina {

/// The link at the end of an arm: the one named, else tool0, flange, or the tip of the longest chain.
/// @param named  empty for none
/// @throws InvalidConfig if there is no link of that name
std::string flangeOf(const urdf::ModelInterface& model, const std::string& named);

/// Cosine of the flange's z to the axis of the last joint that moves it.
/// @throws InvalidConfig if nothing moves it
double flangeCosine(const urdf::ModelInterface& model, const std::string& flange);

}  // namespace lamina
