// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// What a module offers: a library beside the core that is loaded when it is first needed, so that commands
/// without need for it start without what it links to. Each module defines one table of functions, and
/// `extern "C" const void* lamina_module()` that returns its address.
///
/// @param name  of the module; its file is `liblamina_<name>.so` in the folder of the core library
/// @return the module's table; the same for every call, from any thread; stays loaded
/// @throws FileError if the file cannot be loaded or is no module
const void* moduleTable(const std::string& name);

/// Folder of the core library with its slash at the end; empty for the one the process runs in.
/// @throws FileError if it is not known
std::string folderOfTheCore();

}  // namespace lamina
