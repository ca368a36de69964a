// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// Version of the interface between Lamina and plug-ins. It rises when a type that a registry contains
/// changes.
inline constexpr int kPluginInterface = 3;

/// A plug-in as a class, which `pluginlib` finds and creates for the nodes.
class Plugin {
 public:
  virtual ~Plugin() = default;
  /// Adds entries to the registries. It is called once.
  virtual void addEntries() = 0;
};

/// Loads a plug-in (`docs/installation/plugins.md`): a shared library that exports
///
///     extern "C" int lamina_plugin_interface() { return lamina::kPluginInterface; }
///     extern "C" void lamina_register();
///
/// and calls `lamina_register`, which adds the entries of the plug-in to the registries. The library stays
/// loaded until the process ends; a plug-in that is already loaded is skipped. Call this before jobs run.
/// @throws FileError if there is no such library, or it cannot be loaded
/// @throws InvalidInput if it does not export both functions, or was built for another interface
/// @throws what `lamina_register` throws, with the path
void loadPlugin(const std::string& path);

/// Loads several plug-ins, in their order.
/// @throws as `loadPlugin`, at the first that fails
void loadPlugins(const std::vector<std::string>& paths);

/// The paths of a text in which colons separate them; empty ones are left out.
std::vector<std::string> pathsIn(const std::string& text);

/// The paths of the environment variable LAMINA_PLUGINS, separated by colons; none if it is not set.
std::vector<std::string> pluginsOfEnvironment();

}  // namespace lamina
