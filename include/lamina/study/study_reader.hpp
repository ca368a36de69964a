// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/study/study.hpp"

namespace lamina {

/// Reads a study from YAML text; docs/studies/studies.md explains its keys. Nothing is run or written.
/// @param source_name  name of the source, for messages
/// @param folder       folder to which paths in the study are relative; empty for the current one
/// @throws InvalidConfig naming source, line and key: no YAML, unknown or repeated keys, wrong types, values
///   out of bounds, goals on responses that nothing measures, placeholders that are no variables, invalid
///   JSON pointers, more than one way to measure or none
Study readStudy(const std::string& yaml, const std::string& source_name, const std::string& folder);

/// Reads a study from a YAML file; paths in it are relative to its folder.
/// @throws InvalidConfig as `readStudy`; FileError if the file cannot be read
Study readStudyFile(const std::string& path);

}  // namespace lamina
