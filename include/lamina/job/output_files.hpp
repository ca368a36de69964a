// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// Whether both names lead to one file, through links too; files that are not there yet are compared by their
/// paths. An empty name is that of no file.
bool isSameFile(const std::string& one, const std::string& other);

/// @throws InvalidInput naming both if an output is one of the inputs, or the same file as another output
void requireApart(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// An empty name is that of no file, and has any suffix.
/// @param suffixes  with their dot: .csv
/// @throws InvalidInput if the output has none of them
void requireSuffix(const std::string& output, const std::vector<std::string>& suffixes);

}  // namespace lamina
