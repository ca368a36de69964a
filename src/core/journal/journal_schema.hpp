// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "journal/database.hpp"

namespace lamina {

/// Gives a journal the tables of this version: all of them, or those that an older one lacks.
/// @throws FileError if a newer version has written it
void bringUpToDate(Database& database, const std::string& path);

/// @throws FileError if the journal is not of this version
void requireUpToDate(const Database& database, const std::string& path);

}  // namespace lamina
