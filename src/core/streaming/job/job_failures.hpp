// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "streaming/job/job_record.hpp"

namespace lamina {

class RevisedLines;

/// Remark on a safe stop that could not be sent, for the end of a message.
constexpr const char* kLinkNotBack =
    "; the link did not come back, so that the machine was not commanded to stop: look after it";

/// Why a program of which the machine has all lines that there are is not complete; nothing if it is.
/// @param revised  null if the lines are sent unchanged
std::optional<Failure> shortfall(std::uint64_t lines_read, const JobRecord& record,
                                 const RevisedLines* revised = nullptr);

/// The failure of a job whose machine says nothing any more.
/// @param duration  of the silence, in words
Failure fallenSilent(const std::string& duration, const JobRecord& record);

/// The failure of a job at whose beginning no machine says anything.
/// @param limit  of the wait, in words
Failure nobodyThere(const std::string& limit);

}  // namespace lamina
