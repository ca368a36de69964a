// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace lamina {

/// Expands a xacro file to a URDF. Supported is the part of xacro that descriptions of robots use: include,
/// property, arg, macro with parameters, their defaults and blocks, insert_block, if, unless; `$(find)`,
/// `$(arg)`; `${}` with numbers, texts, + - * / ( ), comparisons, `not`, pi, radians, degrees, sin, cos,
/// sqrt, and entries of `load_yaml`, in which values tagged `!degrees` or `!radians` become radians.
///
/// @param arguments  values of args by name
/// @param packages   folders in which packages are searched first (`readRobotDescription`)
/// @throws FileError, InvalidConfig naming file and line of what is not supported
std::string expandXacro(const std::string& path, const std::map<std::string, std::string>& arguments = {},
                        const std::vector<std::string>& packages = {});

}  // namespace lamina
