// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/upload_file.hpp"

#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/hex_text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLongestField = 4096;

}  // namespace

struct UploadFile::Digest {
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> context{EVP_MD_CTX_new()};

  Digest() { EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr); }
  void add(std::string_view piece) { EVP_DigestUpdate(context.get(), piece.data(), piece.size()); }
  std::string text() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned int size = 0;
    EVP_DigestFinal_ex(context.get(), bytes.data(), &size);
    return hexText(bytes.data(), size);
  }
};

UploadFile::UploadFile(std::string folder, const std::string& boundary, std::uint64_t most,
                       std::shared_ptr<UploadPlace> place)
    : folder_(std::move(folder)),
      most_(most),
      reader_(boundary, {[this](const MultipartHead& head) { begin(head); },
                         [this](std::string_view piece) { take(piece); }, [this] { is_in_file_ = false; }}),
      digest_(std::make_unique<Digest>()),
      place_(std::move(place)) {}

UploadFile::~UploadFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!received_.path.empty()) ::unlink(received_.path.c_str());
}

void UploadFile::begin(const MultipartHead& head) {
  field_ = head.name;
  if (!head.filename) {
    received_.fields[field_].clear();
    return;
  }
  if (descriptor_ >= 0) throw InvalidInput("the form has two files; expected one");
  std::string path = folder_ + "/upload-XXXXXX";
  descriptor_ = ::mkstemp(path.data());
  if (descriptor_ < 0) throw FileError(path + ": cannot be written: " + std::strerror(errno));
  received_.path = path;
  received_.name = safeFileName(*head.filename);
  is_in_file_ = true;
}

void UploadFile::take(std::string_view piece) {
  if (!is_in_file_) {
    std::string& value = received_.fields[field_];
    if (value.size() + piece.size() > kLongestField)
      throw InvalidInput("field '" + field_.substr(0, 60) + "' of the form has more than " +
                         std::to_string(kLongestField) + " bytes");
    value += piece;
    return;
  }
  received_.bytes += piece.size();
  if (received_.bytes > most_)
    throw UploadTooLarge(413, "the file has more than " + std::to_string(most_) + " bytes");
  digest_->add(piece);
  while (!piece.empty()) {
    const ssize_t written = ::write(descriptor_, piece.data(), piece.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      throw UploadTooLarge(507, received_.path + ": cannot be written: " + std::strerror(errno));
    piece.remove_prefix(static_cast<std::size_t>(written));
    place_->note(static_cast<std::uint64_t>(written));
  }
}

void UploadFile::read(std::string_view piece) { reader_.read(piece); }

const ReceivedUpload& UploadFile::finish() {
  reader_.finish();
  if (descriptor_ < 0) throw InvalidInput("the form has no file; expected a field with a file name");
  received_.sha256 = digest_->text();
  return received_;
}

}  // namespace lamina
