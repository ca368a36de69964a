// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node_plugins.hpp"

#include <dlfcn.h>
#include <ros/console.h>
#include <ros/package.h>

#include <memory>
#include <pluginlib/class_loader.hpp>

#include "lamina/base/layer_error.hpp"
#include "lamina/base/plugin.hpp"
#include "names.hpp"

namespace lamina {
namespace {

using PluginLoader = pluginlib::ClassLoader<Plugin>;

PluginLoader& pluginLoader() {
  static PluginLoader& loader = *std::make_unique<PluginLoader>("lamina", "lamina::Plugin").release();
  return loader;
}

/// Entries hold code of the library to the end of the process, and pluginlib's own loader, which is deleted
/// before them, would take it away.
void keepLoaded(const std::string& library) {
  if (dlopen(library.c_str(), RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE) == nullptr)
    throw FileError("plug-in '" + library + "' is not loaded; expected it to be, by pluginlib");
}

void addEntriesOf(PluginLoader& loader, const std::string& name) {
  try {
    const pluginlib::UniquePtr<Plugin> plugin = loader.createUniqueInstance(name);
    keepLoaded(loader.getClassLibraryPath(name));
    plugin->addEntries();
  } catch (const pluginlib::PluginlibException& error) {
    throw FileError("cannot load plug-in '" + name + "': " + error.what());
  } catch (...) {
    rethrowAt("plug-in '" + name + "'");
  }
}

PluginLoader& foundPlugins() {
  try {
    return pluginLoader();
  } catch (const pluginlib::PluginlibException& error) {
    throw FileError(std::string("cannot look for plug-ins: ") + error.what());
  }
}

}  // namespace

std::vector<std::string> loadPluginClasses() {
  // Where no environment names packages there is none that exports a class.
  if (ros::package::getPath("lamina").empty()) return {};
  PluginLoader& loader = foundPlugins();
  std::vector<std::string> names = loader.getDeclaredClasses();
  for (const std::string& name : names) addEntriesOf(loader, name);
  return names;
}

std::vector<std::string> loadNodePlugins(const ros::NodeHandle& own) {
  loadPlugins(pluginsOfEnvironment());
  loadPlugins(pathsIn(own.param<std::string>(names::kPluginsParameter, "")));
  std::vector<std::string> classes = loadPluginClasses();
  for (const std::string& name : classes) ROS_INFO_STREAM("plug-in " << name << " is loaded");
  return classes;
}

}  // namespace lamina
