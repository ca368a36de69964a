// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/web/operator_site.hpp"
#include "lamina/web/web_server.hpp"

namespace lamina {

/// Who needs a token on the loopback interface.
enum class LoopbackAccess : std::uint8_t {
  None,  ///< nobody: a bench with one user
  Token  ///< everybody
};

/// Parameters of the node operator_page.
struct OperatorPageSettings {
  std::string bind = "127.0.0.1";
  int port = 8080;
  std::string hosts;  ///< further names in `Host`, separated by blanks
  std::string folder = "cell";
  bool is_encrypted = false;
  std::string certificate;  ///< empty: in the folder
  std::string key;          ///< empty: in the folder
  bool allows_plain = false;
  int largest_upload_mb = 1024;
  int connections = 32;            ///< at a time
  int connections_of_address = 8;  ///< of them from one address
  LoopbackAccess loopback = LoopbackAccess::None;
  UploadPrint upload_print = UploadPrint::Wait;
  std::string camera_topic = "camera/image_raw";
  double patience_s = 5.0;  ///< for an answer of the cell
};

/// Adds the node's keys.
void describe(SettingsSchema& schema, OperatorPageSettings& settings);

/// What the page shows, and from whom it accepts commands.
/// @param folder  of the page, absolute
SiteSettings siteOf(const OperatorPageSettings& settings, const std::string& folder);

/// Address at which the page listens, and the limits on connections. With TLS and no certificate stated,
/// makes one in the folder if it is not there.
/// @throws InvalidConfig for a certificate without its key; FileError
WebServerSettings webServerOf(const OperatorPageSettings& settings, const std::string& folder);

}  // namespace lamina
