// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// Reads a manufacturer's URDF, and makes it independent of the location of its file: meshes of collision
/// bodies get absolute `file://` names. Mimic joints without limits get limits, which nothing uses.
///
/// `package://NAME/rest` is searched in the given folders, then in the folders above the file, then in those
/// of ROS_PACKAGE_PATH. In each case the folder itself and its direct subfolders are searched. A folder is
/// the package NAME if its package.xml says so or, if it has none, if its own name is NAME.
///
/// @param packages  folders that are searched first
/// @throws FileError if the file cannot be read
/// @throws InvalidConfig listing all faults of the description by link or joint: no URDF, unexpanded xacro,
///   links and joints that form no tree, joints without limits or speed, meshes that are not found or of an
///   unknown format
std::string readRobotDescription(const std::string& path, const std::vector<std::string>& packages = {});

/// The same for a text that was read from that path.
std::string robotDescription(const std::string& text, const std::string& path,
                             const std::vector<std::string>& packages = {});

}  // namespace lamina
