// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Whether a joint is no function of the nozzle's pose, by its name: external_1 and so on.
inline bool isExternal(const std::string& joint) { return joint.rfind("external_", 0) == 0; }

}  // namespace lamina
