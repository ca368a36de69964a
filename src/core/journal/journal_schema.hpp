// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "journal/database.hpp"

namespace lamina {

/// Creates the tables of this version in a journal, or those that an older version lacks.
/// @throws FileError if a newer version has written it
void bringUpToDate(Database& database, const std::string& path);

/// Refuses a journal of another version.
/// @throws FileError
void requireUpToDate(const Database& database, const std::string& path);

}  // namespace lamina
