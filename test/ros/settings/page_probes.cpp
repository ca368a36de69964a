// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The operator's page: who may do what, and where it listens.
#include <filesystem>

#include "nodes/operator_page/page_settings.hpp"
#include "ros/settings/node_probes.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

std::string pageFor(const SettingTexts& set) {
  const SiteSettings site = siteOf(settingsWith<OperatorPageSettings>(set), "page");
  std::string text = numbersText({double(site.access.is_loopback_open), double(site.most_upload_bytes),
                                  double(site.upload_print), site.patience_s});
  for (const std::string& host : site.access.hosts) text += host + "\n";
  return text;
}

/// Where the page listens; with TLS, by which files.
std::string pageAt(const SettingTexts& set) {
  static const ScratchFolder scratch;
  const std::string folder = scratch.file("page");
  std::filesystem::create_directory(folder);
  const WebServerSettings server = webServerOf(settingsWith<OperatorPageSettings>(set), folder);
  return server.bind + " " +
         numbersText({double(server.port), double(server.allows_plain), double(server.connections),
                      double(server.connections_of_client)}) +
         (server.tls ? server.tls->certificate + " " + server.tls->key : "plain");
}

}  // namespace

std::vector<SettingProbe> pageProbes() {
  return {{"who may do what",
           "",
           pageFor,
           {{"auth.loopback=token"},
            {"api.octoprint_print=release"},
            {"web.hosts=cell.example.org"},
            {"cell.patience_s=2"},
            {"web.largest_upload_mb=1"}}},
          {"where the page listens",
           "",
           pageAt,
           {{"web.bind=127.0.0.2"},
            {"web.port=8081"},
            {"web.allow_plain=true"},
            {"web.connections=16"},
            {"web.connections_of_address=4"},
            {"web.tls=true"},
            {"web.certificate=page.pem;web.key=key.pem", "web.tls=true"},
            {"web.key=other.pem", "web.tls=true;web.certificate=page.pem;web.key=key.pem"}}}};
}

}  // namespace lamina::test
