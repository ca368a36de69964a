// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace lamina {

/// URDF of a xacro file, for the part of xacro that descriptions of robots are written in: include, property,
/// arg, macro with parameters, their defaults and blocks, insert_block, if, unless; `$(find)`, `$(arg)`;
/// `${}` with numbers, texts, + - * / ( ), comparisons, `not`, pi, radians, degrees, sin, cos, sqrt, and
/// entries of `load_yaml`, whose `!degrees` and `!radians` are radians.
///
/// @param arguments  values of args by name
/// @param packages   folders that packages are searched in first (`readRobotDescription`)
/// @throws FileError, InvalidConfig naming file and line of what is not understood
std::string expandXacro(const std::string& path, const std::map<std::string, std::string>& arguments = {},
                        const std::vector<std::string>& packages = {});

}  // namespace lamina
