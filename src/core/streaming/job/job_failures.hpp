// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/streaming/job/unstopped_machine.hpp"
#include "streaming/job/job_record.hpp"

namespace lamina {

class RevisedLines;

/// Why a program is incomplete although the machine has received all lines that exist; nothing if it is
/// complete.
std::optional<Failure> shortfall(std::uint64_t lines_read, const JobRecord& record,
                                 const RevisedLines* revised = nullptr);

/// Failure of a job whose machine has stopped responding.
/// @param duration  duration of the silence, in words
Failure fallenSilent(const std::string& duration, const JobRecord& record);

/// Failure of a job whose machine does not respond at the start.
/// @param limit  longest wait, in words
Failure nobodyThere(const std::string& limit);

}  // namespace lamina
