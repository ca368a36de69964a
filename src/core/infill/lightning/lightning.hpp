// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Branches that support the skins above, and nothing else: those of `InfillRequest::branches`, clipped to
/// the regions. If the request has none, branches under a roof over all of the regions. A solid fill is a
/// zigzag.
std::vector<FillPath> lightning(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
