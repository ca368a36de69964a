// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "streaming/emulator/print_server/emulated_printer.hpp"
#include "streaming/upload/http_exchange.hpp"

namespace lamina {

/// A print server with an emulated printer, which answers requests by responses. The printer's time is given.
class EmulatedPrintServer {
 public:
  virtual ~EmulatedPrintServer() = default;

  /// @param body  whole body of the request
  virtual HttpResponse answer(const HttpRequest& request, std::string_view body) = 0;
  /// Ends all sessions.
  virtual void forgetSessions() {}

  EmulatedPrinter printer;
  std::string password;  ///< password or key; empty for none
  /// Whether it was just started and has not found its printer yet (Moonraker).
  bool has_just_started = false;
};

std::unique_ptr<EmulatedPrintServer> makeEmulatedMoonraker();
std::unique_ptr<EmulatedPrintServer> makeEmulatedDuet();
std::unique_ptr<EmulatedPrintServer> makeEmulatedDuetWithComputer();

/// The decoded value of a key in the query of a request target; empty if the key is missing.
std::string queryValue(const std::string& target, const std::string& key);
/// A path or value of a URL, decoded. A % without two hexadecimal digits after it stays unchanged.
std::string decodedFromUrl(std::string_view text);
/// The value of a header, whose name is compared without regard to case; empty if it is missing.
std::string headerValue(const HttpRequest& request, const std::string& name);

}  // namespace lamina
