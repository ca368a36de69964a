// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// The text of a URDF as its maker ships it, made independent of where it lies: meshes of collision bodies by
/// absolute `file://` names. Joints that mimic others and state no limits get some, which nothing reads.
///
/// `package://NAME/rest` is looked for in the folders given, in the folders above the file, and in those of
/// ROS_PACKAGE_PATH. A folder is NAME if its package.xml says so or, where it has none, if that is its name;
/// so are the folders directly within one that is searched.
///
/// @param packages  folders that are searched first
/// @throws FileError if the file cannot be read
/// @throws InvalidConfig with all faults of the description, each by its link or joint: no URDF, xacro, links
///   and joints that form no tree, joints without limits or speed, meshes that are not found or of a format
///   that is not read
std::string readRobotDescription(const std::string& path, const std::vector<std::string>& packages = {});

/// The same of a text that lies at a path.
std::string robotDescription(const std::string& text, const std::string& path,
                             const std::vector<std::string>& packages = {});

}  // namespace lamina
