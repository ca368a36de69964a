// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace lamina {

/// How many bytes must be put in, left out or replaced to make one text of the other. Time
/// by the product of their lengths.
std::size_t editDistance(std::string_view a, std::string_view b);

}  // namespace lamina
