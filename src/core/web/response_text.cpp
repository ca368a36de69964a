// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "web/response_text.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "lamina/base/text_search.hpp"

namespace lamina {

std::string headText(const WebResponse& response, bool is_kept) {
  std::string text = "HTTP/1.1 " + std::to_string(response.status) + ' ' + reasonOf(response.status) + "\r\n";
  const auto add = [&text](const std::string& name, const std::string& value) {
    text += name + ": " + value + "\r\n";
  };
  bool has_cache_rule = false;
  for (const auto& [name, value] : response.headers) {
    has_cache_rule = has_cache_rule || name == "Cache-Control";
    add(name, value);
  }
  if (!has_cache_rule) add("Cache-Control", "no-store");
  if (!response.body.empty()) add("Content-Type", response.type);
  if (response.status != 204) add("Content-Length", std::to_string(response.body.size()));
  add("Connection", is_kept ? "keep-alive" : "close");
  add("Content-Security-Policy",
      "default-src 'self'; object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'");
  add("X-Content-Type-Options", "nosniff");
  add("X-Frame-Options", "DENY");
  add("Referrer-Policy", "no-referrer");
  add("Cross-Origin-Resource-Policy", "same-origin");
  return text + "\r\n";
}

WebResponse plainError(int status, const std::string& code, const std::string& message) {
  WebResponse response;
  response.status = status;
  response.body = R"({"code":")" + code + R"(","message":")" + message + "\"}";
  return response;
}

bool isShownAsText(const HttpHead& request) {
  return request.method == HttpMethod::Post && request.target.rfind("/api/files/", 0) == 0 &&
         !contains(request.header("accept"), "application/json");
}

WebResponse errorAsText(WebResponse response) {
  constexpr int kFirstError = 400;
  if (response.status < kFirstError) return response;
  const auto value = nlohmann::json::parse(response.body, nullptr, false);
  if (!value.is_object()) return response;
  const auto message = value.find("message");
  if (message == value.end() || !message->is_string()) return response;
  response.body = message->get<std::string>();
  response.type = "text/plain";
  return response;
}

}  // namespace lamina
