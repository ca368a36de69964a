// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// Number of the interface between Lamina and plug-ins. It rises when a type that a registry holds changes.
inline constexpr int kPluginInterface = 3;

/// A plug-in as a class, which `pluginlib` finds and makes for the nodes.
class Plugin {
 public:
  virtual ~Plugin() = default;
  /// Adds entries to the registries. Called once.
  virtual void addEntries() = 0;
};

/// Loads a plug-in (`docs/installation/plugins.md`): a shared library that exports
///
///     extern "C" int lamina_plugin_interface() { return lamina::kPluginInterface; }
///     extern "C" void lamina_register();
///
/// and adds its entries to the registries in the latter. It stays loaded until the process ends. One that is
/// loaded already is left alone. To be called before jobs run.
/// @throws FileError if there is no such library, or it cannot be loaded
/// @throws InvalidInput if it exports neither function, or was built for another interface
/// @throws what its registering throws, with the path
void loadPlugin(const std::string& path);

/// Loads all of them, in order.
/// @throws as `loadPlugin`, at the first that fails
void loadPlugins(const std::vector<std::string>& paths);

/// The paths of a text with colons between; empty ones are left out.
std::vector<std::string> pathsIn(const std::string& text);

/// The paths in the environment variable LAMINA_PLUGINS, with colons between; none if it is not set.
std::vector<std::string> pluginsOfEnvironment();

}  // namespace lamina
