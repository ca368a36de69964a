// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/part/source_part.hpp"

namespace lamina {

/// Reads a part and prepares its mesh for slicing, with repairs as the settings allow.
/// @param part  name of a parametric part, otherwise path of a mesh file
/// @throws InvalidMesh if the mesh cannot be read or repaired, or is not sound and the policy is strict;
/// FileError; Cancelled as `readMesh`
SourcePart readPart(const std::string& part, const InputSettings& settings, Progress& progress);

/// One of the objects of a part's file.
struct SourceObject {
  std::string name;  ///< empty if the file gives none
  SourcePart source;
};

/// The objects that a mesh file distinguishes (`readMeshObjects`), each prepared as by `readPart`. A
/// parametric part is a single object.
std::vector<SourceObject> readParts(const std::string& part, const InputSettings& settings,
                                    Progress& progress);

}  // namespace lamina
