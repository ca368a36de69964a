// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>

#include "lamina/base/percent_encoding.hpp"
#include "streaming/emulator/print_server/emulated_print_server.hpp"

namespace lamina {

std::string decodedFromUrl(std::string_view text) {
  const std::string spaced = boost::algorithm::replace_all_copy(std::string(text), "+", " ");
  return percentDecoded(spaced).value_or(spaced);
}

std::string queryValue(const std::string& target, const std::string& key) {
  std::size_t start = target.find('?');
  while (start != std::string::npos) {
    const std::size_t end = target.find('&', ++start);
    const std::string_view pair = std::string_view(target).substr(start, end - start);
    if (pair.substr(0, key.size() + 1) == key + "=") return decodedFromUrl(pair.substr(key.size() + 1));
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
