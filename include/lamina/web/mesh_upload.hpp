// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/web/cell_desk.hpp"
#include "lamina/web/http_message.hpp"

namespace lamina {

/// The suffix of a mesh file's name, in lower case (".stl"); empty if the name is not that of a mesh.
std::string meshSuffix(std::string_view name);

/// The order that an upload of a mesh contains. Fields of its form: `part`; `material` and `process`, names
/// of profiles; `settings`, one KEY=VALUE on each line.
/// @throws InvalidInput if a profile is no plain name; if a line has no '='; if a key is one of machine.*,
///   which the cell decides; if a value names a file by its folder
DeskMesh meshOf(const ReceivedUpload& upload, const std::string& source);

}  // namespace lamina
