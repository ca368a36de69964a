// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "streaming/upload/print_server.hpp"

namespace lamina {

/// Why a machine cannot begin a print, as its report shows; nothing if it can.
std::optional<Failure> hindrance(const MachineReport& report);

/// Why a machine has no print of an earlier session that can be continued; nothing if it has one.
/// @param earlier_files  beginning of the names that the file of such a print may have
std::optional<Failure> hindranceToGoOn(const MachineReport& report, const std::string& earlier_files);

/// Why a requested print will not begin; nothing if it still may.
std::optional<Failure> hindranceToCome(const MachineReport& report);

/// Why a print has ended without being complete; nothing if it is still running or complete.
std::optional<Failure> endOfPrint(const PrintServer& server);

}  // namespace lamina
