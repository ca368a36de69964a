// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Branches that hold up the skins above, and nothing else: those of `InfillRequest::branches` as far as they
/// run inside the regions. Without any given, those under a roof over the whole of the regions. A solid fill
/// is a zigzag.
std::vector<FillPath> lightning(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
