// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/sha256.hpp"

#include <algorithm>
#include <fstream>

#include "base/module.hpp"
#include "base/sha256_module.hpp"
#include "lamina/base/error.hpp"

namespace lamina {

std::string sha256Of(const ByteSource& source) {
  static const auto* const module = static_cast<const Sha256Module*>(moduleTable("sha256"));
  return module->digest_of(source);
}

std::string sha256Of(std::string_view bytes) {
  return sha256Of([&bytes](char* buffer, std::size_t size) {
    const std::size_t count = bytes.copy(buffer, size);
    bytes.remove_prefix(count);
    return count;
  });
}

std::string sha256OfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path + ": cannot be read");
  return sha256Of([&](char* buffer, std::size_t size) {
    file.read(buffer, static_cast<std::streamsize>(size));
    if (file.bad()) throw FileError(path + ": cannot be read to its end");
    return static_cast<std::size_t>(file.gcount());
  });
}

}  // namespace lamina
