// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/scaffold/scaffold_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// See `makeScaffold`.
/// @param settings  within their bounds
Toolpath sinusoidalScaffold(const ScaffoldSettings& settings);

}  // namespace lamina
