// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "lamina/job/job_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What hosts and displays read in a program besides its motions, as comments.
struct ProgramAnnotations {
  std::string head;  ///< behind the first line: thumbnails
  std::string tail;  ///< behind the last: time, filament, layer height, settings
};

/// Thumbnails and closing comments as `program.thumbnails`, `program.closing_comments` and
/// `program.settings_in_file` ask for them.
/// @throws InvalidConfig as `thumbnailsFrom`
ProgramAnnotations annotationsOf(const Toolpath& toolpath, const JobSettings& settings);

/// Writes a program with annotations.
/// @param write  writes the program, its first line a comment
void writeAnnotated(const ProgramAnnotations& annotations,
                    const std::function<void(const TextSink& sink)>& write, const TextSink& sink);

/// "1d 2h 3m 4s", without the units before the first that is not 0.
std::string durationText(double time_s);

}  // namespace lamina
