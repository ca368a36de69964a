// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace lamina {

/// The Levenshtein distance: least number of bytes to insert, delete or replace that turn one text into the
/// other. Its cost is the product of the two lengths.
std::size_t editDistance(std::string_view a, std::string_view b);

}  // namespace lamina
