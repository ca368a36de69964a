// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// Whether two paths lead to one file, also through links; files that do not exist are compared by their
/// paths. An empty path names no file.
bool isSameFile(const std::string& one, const std::string& other);

/// Checks that no output would overwrite an input or another output.
/// @throws InvalidInput naming both if one does
void requireApart(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// Checks that a file can be written, before its contents are computed; an existing file stays as it is. An
/// empty path names no file and is accepted.
/// @throws FileError as `AtomicFile`
void requireWritableFile(const std::string& output);

/// Checks the suffix of an output. An empty path names no file and is accepted.
/// @param suffixes  with their dot: .csv
/// @throws InvalidInput if the output has none of the suffixes
void requireSuffix(const std::string& output, const std::vector<std::string>& suffixes);

}  // namespace lamina
