// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml.h>

#include <string>
#include <vector>

#include "kinematics/description_files/package_path.hpp"

namespace lamina {

/// All faults by which a description cannot be read, in the order of the file: "joint 'x' (line 12) has ...".
/// Empty if it can be read.
std::vector<std::string> descriptionFaults(const TiXmlElement& robot, const PackagePath& packages);

/// Whether the suffix is of a format in which bodies are read.
bool isMeshOfBodies(const std::string& name);

/// Value of an attribute; empty if there is none.
std::string attributeOf(const TiXmlElement& element, const char* name);

}  // namespace lamina
