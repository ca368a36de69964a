// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// What the module `threemf` offers: lib3mf stays out of commands that read no 3MF.
struct ThreemfModule {
  Mesh (*read)(std::string_view bytes, const std::string& name);  ///< as `readThreemf`
};

}  // namespace lamina
