// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/tls_identity.hpp"

#include <arpa/inet.h>
#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <memory>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/hex_text.hpp"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr long kLifetime = 3650L * 86400L;  // [s]

struct FreeCertificate {
  void operator()(X509* certificate) const { X509_free(certificate); }
};
struct FreeKey {
  void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
};
struct FreeBio {
  void operator()(BIO* bio) const { BIO_free(bio); }
};
using Certificate = std::unique_ptr<X509, FreeCertificate>;
using PrivateKey = std::unique_ptr<EVP_PKEY, FreeKey>;
using Bio = std::unique_ptr<BIO, FreeBio>;

void require(bool is_done, const char* what) {
  if (!is_done) throw FileError(std::string("OpenSSL cannot ") + what);
}

bool isAddress(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  return ::inet_pton(AF_INET, host.c_str(), bytes.data()) == 1 ||
         ::inet_pton(AF_INET6, host.c_str(), bytes.data()) == 1;
}

void addNames(X509* certificate, const std::string& host) {
  std::string names = "DNS:localhost,IP:127.0.0.1";
  if (!host.empty() && host != "localhost" && host != "127.0.0.1")
    names += (isAddress(host) ? ",IP:" : ",DNS:") + host;
  X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, nullptr, NID_subject_alt_name, names.c_str());
  require(extension != nullptr, "name the certificate's host");
  const int added = X509_add_ext(certificate, extension, -1);
  X509_EXTENSION_free(extension);
  require(added == 1, "name the certificate's host");
}

Certificate selfSigned(EVP_PKEY* key, const std::string& host) {
  Certificate certificate(X509_new());
  require(certificate != nullptr, "make a certificate");
  std::array<unsigned char, 8> serial{};
  require(RAND_bytes(serial.data(), static_cast<int>(serial.size())) == 1, "give random bytes");
  serial[0] &= 0x7f;
  ASN1_INTEGER* number = X509_get_serialNumber(certificate.get());
  const std::unique_ptr<BIGNUM, void (*)(BIGNUM*)> big(
      BN_bin2bn(serial.data(), static_cast<int>(serial.size()), nullptr), BN_free);
  require(BN_to_ASN1_INTEGER(big.get(), number) != nullptr, "number the certificate");
  X509_set_version(certificate.get(), X509_VERSION_3);
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -3600);
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), kLifetime);
  X509_NAME* name = X509_get_subject_name(certificate.get());
  const std::string shown = "Lamina " + host.substr(0, 50);
  X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_UTF8, reinterpret_cast<const unsigned char*>(shown.c_str()),
                             -1, -1, 0);
  X509_set_issuer_name(certificate.get(), name);
  X509_set_pubkey(certificate.get(), key);
  addNames(certificate.get(), host);
  require(X509_sign(certificate.get(), key, EVP_sha256()) != 0, "sign a certificate");
  return certificate;
}

std::string textOf(BIO* bio) {
  char* bytes = nullptr;
  const long size = BIO_get_mem_data(bio, &bytes);
  return {bytes, static_cast<std::size_t>(size)};
}

}  // namespace

void makeTlsIdentity(const TlsFiles& files, const std::string& host) {
  const bool has_certificate = fs::exists(files.certificate);
  const bool has_key = fs::exists(files.key);
  if (has_certificate && has_key) return;
  if (has_certificate != has_key)
    throw FileError((has_key ? files.certificate : files.key) + ": is missing, but " +
                    (has_key ? files.key : files.certificate) + " is there; expected both or none");
  const PrivateKey key(EVP_EC_gen("P-256"));
  require(key != nullptr, "make a key");
  const Certificate certificate = selfSigned(key.get(), host);
  const Bio key_text(BIO_new(BIO_s_mem()));
  require(PEM_write_bio_PrivateKey(key_text.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) == 1,
          "write a key");
  const Bio certificate_text(BIO_new(BIO_s_mem()));
  require(PEM_write_bio_X509(certificate_text.get(), certificate.get()) == 1, "write a certificate");
  {
    AtomicFile file(files.key);
    fs::permissions(file.temporaryPath(), fs::perms::owner_read | fs::perms::owner_write);
    file.write(textOf(key_text.get()));
    file.commit();
  }
  fs::permissions(files.key, fs::perms::owner_read | fs::perms::owner_write);
  writeFile(files.certificate, textOf(certificate_text.get()));
}

std::string tlsFingerprint(const std::string& certificate) {
  const std::string text = readFile(certificate);
  const Bio bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  const Certificate read(PEM_read_bio_X509(bio.get(), nullptr, nullptr, nullptr));
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (!read || X509_digest(read.get(), EVP_sha256(), digest.data(), &size) != 1)
    throw FileError(certificate + ": is no certificate in PEM");
  const std::string digits = hexText(digest.data(), size);
  std::string shown;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && i % 2 == 0) shown += ':';
    shown += static_cast<char>(std::toupper(static_cast<unsigned char>(digits[i])));
  }
  return shown;
}

}  // namespace lamina
