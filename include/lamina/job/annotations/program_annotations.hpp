// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "lamina/job/job_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Comments of a program that hosts and displays read, besides its motions.
struct ProgramAnnotations {
  std::string head;  ///< put after the first line: thumbnails
  std::string tail;  ///< put after the last line: time, filament, layer height, settings
};

/// Thumbnails and closing comments as far as `program.thumbnails`, `program.closing_comments` and
/// `program.settings_in_file` ask for them.
/// @throws InvalidConfig as `thumbnailsFrom`
ProgramAnnotations annotationsOf(const Toolpath& toolpath, const JobSettings& settings);

/// Writes a program with its annotations.
/// @param write  writes the program, whose first line is a comment, to the sink that it is given
void writeAnnotated(const ProgramAnnotations& annotations,
                    const std::function<void(const TextSink& sink)>& write, const TextSink& sink);

/// A duration as "1d 2h 3m 4s", rounded to seconds, without leading units that are 0.
std::string durationText(double time_s);

}  // namespace lamina
