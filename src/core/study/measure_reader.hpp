// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/study/study.hpp"
#include "study/strict_yaml.hpp"

namespace lamina {

/// A file named in a study: relative to its folder, unless it is absolute or there is no folder.
std::string inFolder(const std::string& folder, const std::string& file);

/// The key `slice`. A part that is no file beside the study keeps its name.
SliceMeasure sliceMeasureFrom(const StrictYaml& yaml, const std::string& folder);

/// The key `commands`.
std::vector<StudyCommand> commandsFrom(const StrictYaml& yaml);

/// The key `responses`.
/// @throws InvalidConfig too if a response is of no command, or its pointer cannot lead anywhere
std::vector<CommandResponse> responsesFrom(const StrictYaml& yaml, const std::vector<StudyCommand>& commands);

}  // namespace lamina
