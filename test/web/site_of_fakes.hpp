// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>

#include "lamina/base/scratch_folder.hpp"
#include "lamina/web/operator_site.hpp"
#include "web/fake_desk.hpp"

namespace lamina::test {

using Headers = std::map<std::string, std::string>;

/// A site over a cell that is not there, asked without a socket.
class SiteOfFakes {
 public:
  explicit SiteOfFakes(SiteSettings settings = {})
      : store(folder.path() + "/page.db"),
        site(withFolder(std::move(settings)), desk, store, pageOfOneFile()) {
    desk.seen.heard_s = now.steady_s;
    desk.seen.unit.state = UnitState::Idle;
    desk.seen.unit.accepted_now = {UnitCommand::Start, UnitCommand::Stop, UnitCommand::Abort};
  }

  std::string add(WebRole role, const std::string& name) {
    return store.add({name, role, std::nullopt}, now.utc_s);
  }

  /// Asks, and lets a second go by.
  WebResponse ask(HttpMethod method, const std::string& target, Headers headers,
                  const std::string& body = "") {
    WebRequest request;
    request.head.method = method;
    request.head.target = target;
    request.head.headers = std::move(headers);
    request.head.headers.emplace("host", "127.0.0.1:8080");
    request.head.peer = peer;
    request.body = body;
    request.upload = upload;
    now.steady_s += 1.0;
    now.utc_s += 1.0;
    desk.seen.heard_s = now.steady_s;
    auto admission = site.admit(request.head, now);
    if (auto* refused = std::get_if<WebResponse>(&admission)) return *refused;
    return site.answer(std::get<OperatorSite::Admitted>(admission), request, now);
  }
  nlohmann::json get(const std::string& target, const std::string& token = "") {
    Headers headers;
    if (!token.empty()) headers["x-api-key"] = token;
    return nlohmann::json::parse(ask(HttpMethod::Get, target, headers).body);
  }
  std::string lastAudit() const {
    const auto rows = store.audit(1);
    return rows.empty() ? "" : rows[0].who + " | " + rows[0].what + " | " + rows[0].result;
  }

  ScratchFolder folder;
  FakeDesk desk;
  CellTime now{1000.0, 1.7e9};
  WebStore store;
  OperatorSite site;
  HttpPeer peer{"127.0.0.1", true, false};
  ReceivedUpload upload;

 private:
  SiteSettings withFolder(SiteSettings settings) const {
    settings.upload_folder = folder.path();
    settings.journal_folder = folder.path();
    return settings;
  }
  static std::vector<PageFile> pageOfOneFile() { return {{"index.html", "text/html", "<p>page</p>"}}; }
};

/// Settings by which nobody comes in without a token.
inline SiteSettings closedLoopback() {
  SiteSettings settings;
  settings.access.is_loopback_open = false;
  return settings;
}

}  // namespace lamina::test
