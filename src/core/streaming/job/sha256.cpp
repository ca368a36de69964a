// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/module.hpp"
#include "streaming/job/sha256_module.hpp"

namespace lamina {

std::string sha256Of(const ByteSource& source) {
  static const auto* const module = static_cast<const Sha256Module*>(moduleTable("sha256"));
  return module->digest_of(source);
}

}  // namespace lamina
