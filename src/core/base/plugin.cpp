// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/plugin.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <set>
#include <sstream>
#include <system_error>

#include "lamina/base/input_file.hpp"
#include "lamina/base/layer_error.hpp"

namespace lamina {
namespace {

/// A name without slash would be looked for in the system's folders.
std::string fileName(const std::string& path) {
  return path.find('/') == std::string::npos ? "./" + path : path;
}

template <class Function>
Function* symbolOf(void* library, const char* name, const std::string& path) {
  void* symbol = dlsym(library, name);
  if (symbol == nullptr)
    throw InvalidInput("plug-in '" + path + "' exports no " + name + "; expected extern \"C\" " + name +
                       "()");
  return reinterpret_cast<Function*>(symbol);
}

/// Libraries by their handles, which are the same for one that is opened again.
bool isFirstLoad(void* library) {
  static std::mutex mutex;
  static std::set<void*> loaded;
  const std::lock_guard<std::mutex> lock(mutex);
  return loaded.insert(library).second;
}

}  // namespace

void loadPlugin(const std::string& path) {
  std::error_code unknown;
  if (std::filesystem::exists(fileName(path), unknown)) requireReadable(fileName(path));
  void* library = dlopen(fileName(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw FileError("cannot load plug-in '" + path + "': " + dlerror());
  const int interface = symbolOf<int()>(library, "lamina_plugin_interface", path)();
  if (interface != kPluginInterface)
    throw InvalidInput("plug-in '" + path + "' is built for interface " + std::to_string(interface) +
                       "; expected " + std::to_string(kPluginInterface));
  const auto enter = symbolOf<void()>(library, "lamina_register", path);
  if (!isFirstLoad(library)) return;
  try {
    enter();
  } catch (...) {
    rethrowAt("plug-in '" + path + "'");
  }
}

void loadPlugins(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) loadPlugin(path);
}

std::vector<std::string> pathsIn(const std::string& text) {
  std::istringstream left(text);
  std::vector<std::string> paths;
  for (std::string path; std::getline(left, path, ':');)
    if (!path.empty()) paths.push_back(path);
  return paths;
}

std::vector<std::string> pluginsOfEnvironment() {
  const char* set = std::getenv("LAMINA_PLUGINS");
  return pathsIn(set != nullptr ? set : "");
}

}  // namespace lamina
