// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/job/slice_job.hpp"

namespace lamina {

/// Refuses a robot's program if the settings of another language ask for a dry run, or for the controller's
/// arc package, and those of its own language do not: it would run with its process, or without the package.
/// @throws InvalidConfig naming key, value and the key of the program's language
void requireSettingsOfLanguage(const SliceJob& job);

/// A note that names the settings that were changed from their defaults although the language of a robot's
/// program does not use them; empty if there are none, or the output is no program of a robot.
std::string noteOnOtherLanguages(const SliceJob& job);

}  // namespace lamina
