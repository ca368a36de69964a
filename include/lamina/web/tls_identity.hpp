// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Certificate and private key of a server, as PEM files.
struct TlsFiles {
  std::string certificate;
  std::string key;
};

/// Makes a key (P-256) and a certificate signed by itself for ten years if neither file is there. The key is
/// readable by its owner alone.
/// @param host  name or address that browsers will ask for
/// @throws FileError if a file cannot be written, or only one of the two is there
void makeTlsIdentity(const TlsFiles& files, const std::string& host);

/// SHA-256 of a certificate, as browsers show it: "AB:CD:…".
/// @throws FileError if it is no certificate
std::string tlsFingerprint(const std::string& certificate);

}  // namespace lamina
