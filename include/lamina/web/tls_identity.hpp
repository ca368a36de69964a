// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Paths of a server's certificate and private key, both PEM files.
struct TlsFiles {
  std::string certificate;
  std::string key;
};

/// Makes a private key (P-256) and a self-signed certificate that is valid for ten years, if neither file
/// exists. Only their owner can read the key.
/// @param host  name or address by which browsers reach the server
/// @throws FileError if a file cannot be written, or only one of the two exists
void makeTlsIdentity(const TlsFiles& files, const std::string& host);

/// The SHA-256 fingerprint of a certificate, as browsers show it: "AB:CD:…".
/// @throws FileError if the file is no certificate
std::string tlsFingerprint(const std::string& certificate);

}  // namespace lamina
