// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/study/study.hpp"

namespace lamina {

/// Reads a study from YAML; docs/studies/studies.md explains its keys. Nothing is run or written.
/// @param source_name  for messages
/// @param folder       that names of files are relative to; empty for the current one
/// @throws InvalidConfig naming source, line and key: no YAML, unknown or double keys, wrong types, values
///   out of bounds, goals on responses that nothing measures, placeholders that are no variable, a number in
///   JSON that no pointer leads to, more than one way to measure or none
Study readStudy(const std::string& yaml, const std::string& source_name, const std::string& folder);

/// The same from a file; names in it are relative to it.
/// @throws FileError too
Study readStudyFile(const std::string& path);

}  // namespace lamina
