// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether a layer begins a part on the bed, as on plates that are deposited part by part: it is the first
/// one, or lies no higher than the first one and lower than the one before it.
bool beginsPart(const std::vector<ToolpathLayer>& layers, std::size_t index);

}  // namespace lamina
