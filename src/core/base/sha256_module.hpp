// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/sha256.hpp"

namespace lamina {

/// What the module `sha256` offers: OpenSSL's digest, which only kept or uploaded programs and cells need.
struct Sha256Module {
  std::string (*digest_of)(const ByteSource& source) = nullptr;
};

}  // namespace lamina
