// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Whether a joint is an external axis, which does not follow from the nozzle's pose. Such joints have the
/// names external_1, external_2, ...
inline bool isExternal(const std::string& joint) { return joint.rfind("external_", 0) == 0; }

}  // namespace lamina
