// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// The Levenshtein distance: least number of bytes to insert, delete or replace that turn one text into the
/// other. Its cost is the product of the two lengths.
std::size_t editDistance(std::string_view a, std::string_view b);

/// "; did you mean '...'?" with the name at the least edit distance from `given`, the first of several. Names
/// that contain `given` as whole words ("layer_height" in "slicing.layer_height_mm") precede all others.
/// Empty if nothing is given, if there are no names, or if the distance is more than half the length of the
/// longer of the two texts and no name contains `given` as whole words.
std::string suggestionFor(const std::vector<std::string>& names, std::string_view given);

}  // namespace lamina
