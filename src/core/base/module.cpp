// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/module.hpp"

#include <dlfcn.h>

#include "lamina/base/error.hpp"
#include "lamina/base/version.hpp"

namespace lamina {

std::string folderOfTheCore() {
  Dl_info found{};
  if (dladdr(reinterpret_cast<const void*>(&laminaVersion), &found) == 0 || found.dli_fname == nullptr)
    throw FileError("the folder of the core library is not known; expected it to be loaded from a file");
  const std::string path = found.dli_fname;
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

const void* moduleTable(const std::string& name) {
  const std::string path = folderOfTheCore() + "liblamina_" + name + ".so";
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) throw FileError("cannot load module '" + name + "': " + dlerror());
  using Entry = const void* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(library, "lamina_module"));
  if (entry == nullptr) throw FileError(path + " is no module of Lamina; expected an entry 'lamina_module'");
  return entry();
}

}  // namespace lamina
