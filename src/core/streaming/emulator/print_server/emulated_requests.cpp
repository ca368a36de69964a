// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/algorithm/string/predicate.hpp>
#include <cstdlib>

#include "streaming/emulator/print_server/emulated_print_server.hpp"

namespace lamina {

std::string percentDecoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size()) {
      decoded += static_cast<char>(std::strtol(std::string(text.substr(i + 1, 2)).c_str(), nullptr, 16));
      i += 2;
    } else {
      decoded += text[i] == '+' ? ' ' : text[i];
    }
  }
  return decoded;
}

std::string queryValue(const std::string& target, const std::string& key) {
  std::size_t start = target.find('?');
  while (start != std::string::npos) {
    const std::size_t end = target.find('&', ++start);
    const std::string_view pair = std::string_view(target).substr(start, end - start);
    if (pair.substr(0, key.size() + 1) == key + "=") return percentDecoded(pair.substr(key.size() + 1));
    start = end;
  }
  return {};
}

std::string headerValue(const HttpRequest& request, const std::string& name) {
  for (const auto& [key, value] : request.headers)
    if (boost::algorithm::iequals(key, name)) return value;
  return {};
}

}  // namespace lamina
