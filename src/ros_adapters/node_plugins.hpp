// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

namespace lamina {

/// Loads the plug-ins of a node, in this order: those in LAMINA_PLUGINS, those of its parameter `plugins`
/// (paths with colons between), and all classes that packages export for `lamina` (`lamina::Plugin`, found by
/// pluginlib). To be called before the node reads its settings.
/// @param own  the node's private namespace
/// @return names of the classes that pluginlib loaded
/// @throws FileError, InvalidInput as `loadPlugin`; FileError naming a class that pluginlib cannot make
std::vector<std::string> loadNodePlugins(const ros::NodeHandle& own);

/// Loads only the classes that packages export; none if ROS_PACKAGE_PATH does not lead to lamina.
/// @throws FileError naming a class that pluginlib cannot make
std::vector<std::string> loadPluginClasses();

}  // namespace lamina
