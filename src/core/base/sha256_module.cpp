// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/sha256_module.hpp"

#include <openssl/evp.h>

#include <array>
#include <memory>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/hex_text.hpp"

namespace lamina {
namespace {

struct FreeContext {
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};

std::string digestOfBytes(const ByteSource& source) {
  constexpr std::size_t kPiece = 1 << 16;
  const std::unique_ptr<EVP_MD_CTX, FreeContext> context(EVP_MD_CTX_new());
  bool is_good = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  std::vector<char> piece(kPiece);
  while (is_good) {
    const std::size_t count = source(piece.data(), kPiece);
    if (count == 0) break;
    is_good = EVP_DigestUpdate(context.get(), piece.data(), count) == 1;
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  if (!is_good || EVP_DigestFinal_ex(context.get(), digest.data(), &length) != 1)
    throw FileError("cannot compute a SHA-256: OpenSSL refuses");
  return hexText(digest.data(), length);
}

}  // namespace
}  // namespace lamina

// A name of C.
extern "C" const void* lamina_module();   // NOLINT(readability-identifier-naming)
extern "C" const void* lamina_module() {  // NOLINT(readability-identifier-naming)
  static constexpr lamina::Sha256Module kTable{&lamina::digestOfBytes};
  return &kTable;
}
