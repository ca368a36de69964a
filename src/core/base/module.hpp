// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// The functions of a module: a library beside the core that is loaded when it is first needed, so that
/// commands that do not need it start without the libraries it links to. Each module defines one table of
/// functions, and `extern "C" const void* lamina_module()` that returns the address of this table.
///
/// @param name  name of the module; its file is `liblamina_<name>.so` in the folder of the core library
/// @return the module's table; the same one at every call, from any thread; valid until the process ends
/// @throws FileError if the file cannot be loaded or is no module
const void* moduleTable(const std::string& name);

/// Folder of the core library, with a slash at its end; empty if it is the working directory.
/// @throws FileError if the folder is not known
std::string folderOfTheCore();

}  // namespace lamina
