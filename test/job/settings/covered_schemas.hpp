// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina::test {

/// Keys of all settings that the core describes.
std::vector<std::string> coreKeys();

}  // namespace lamina::test
