// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "page_settings.hpp"

#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/loopback.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

std::optional<TlsFiles> tlsFiles(const OperatorPageSettings& settings, const std::string& folder) {
  if (!settings.is_encrypted) return std::nullopt;
  if (settings.certificate.empty() != settings.key.empty())
    throw InvalidConfig("web.certificate is '" + settings.certificate + "' and web.key is '" + settings.key +
                        "'; expected both or none");
  TlsFiles files{settings.certificate, settings.key};
  if (files.certificate.empty()) {
    files = {folder + "/page_certificate.pem", folder + "/page_key.pem"};
    const std::vector<std::string> hosts = splitIntoWords(settings.hosts);
    makeTlsIdentity(files, hosts.empty() ? settings.bind : hosts.front());
  }
  return files;
}

/// The host by the number that its system was given when it was installed, and the page's folder on it.
std::string identityOf(const std::string& folder) {
  constexpr const char* kNumberOfHost = "/etc/machine-id";
  const std::string host = std::filesystem::exists(kNumberOfHost) ? readFile(kNumberOfHost) : "";
  return "lamina operator_page\n" + host + std::filesystem::absolute(folder).string();
}

}  // namespace

void describe(SettingsSchema& schema, OperatorPageSettings& settings) {
  schema.text("web.bind", settings.bind,
              "Address to listen on; beyond the loopback interface with web.tls only.");
  schema.integer("web.port", settings.port, {0, 65535}, "Port to listen on; 0 for any that is free.");
  schema.text(
      "web.hosts", settings.hosts,
      "Names and addresses by which browsers call this host, separated by blanks, besides localhost.");
  schema.text(
      "web.folder", settings.folder,
      "Folder of tokens, audit and uploads, on a local disk; a relative one is in the folder that the "
      "node runs in.");
  schema.flag("web.tls", settings.is_encrypted, "Whether the page is served by HTTPS alone.");
  schema.text("web.certificate", settings.certificate,
              "Certificate, a PEM file; empty for one of the page's own, made at its first start.");
  schema.text("web.key", settings.key, "Its private key, a PEM file; empty for one of the page's own.");
  schema.flag("web.allow_plain", settings.allows_plain,
              "Whether the page may be reached from other hosts without TLS.");
  schema.integer("web.largest_upload_mb", settings.largest_upload_mb, {1, 65536},
                 "Size of the largest program.");
  schema.integer("web.connections", settings.connections, {8, 1024},
                 "Connections at a time, of which three quarters at most are pages that are kept up to date, "
                 "and uploads.");
  schema.integer("web.connections_of_address", settings.connections_of_address, {2, 1024},
                 "Connections at a time from one address.");
  schema.choice("auth.loopback", settings.loopback,
                {{"none", LoopbackAccess::None}, {"token", LoopbackAccess::Token}},
                "Whether who comes from this host needs a token.");
  schema.choice(
      "api.octoprint_print", settings.upload_print,
      {{"wait", UploadPrint::Wait}, {"release", UploadPrint::Release}},
      "What becomes of a program that a slicer sends to be printed at once: it waits, or is released if "
      "an operator's token sends it.");
  schema.text("camera.topic", settings.camera_topic,
              "Images of the camera; those on this topic with /compressed are taken before raw ones.");
  schema.number("cell.patience_s", settings.patience_s, {0.1, 60.0},
                "Time in which the cell answers an order, and the longest that one to move was on its way.");
}

SiteSettings siteOf(const OperatorPageSettings& settings, const std::string& folder) {
  SiteSettings site;
  site.access.is_loopback_open = settings.loopback == LoopbackAccess::None;
  site.access.hosts = splitIntoWords(settings.hosts);
  for (std::string& host : site.access.hosts)
    host = hostName(host.find(':') == std::string::npos ? host : "[" + host + "]");
  site.access.hosts.push_back(settings.bind);
  site.upload_folder = folder + "/uploads";
  site.journal_folder = folder;
  site.most_upload_bytes = static_cast<std::uint64_t>(settings.largest_upload_mb) << 20;
  site.upload_print = settings.upload_print;
  site.patience_s = settings.patience_s;
  site.identity = identityOf(folder);
  if (!isLoopbackHost(settings.bind))
    site.notices.push_back(settings.is_encrypted
                               ? "This page is reached from other hosts."
                               : "This page is reached from other hosts, without encryption.");
  return site;
}

WebServerSettings webServerOf(const OperatorPageSettings& settings, const std::string& folder) {
  WebServerSettings server;
  server.connections = static_cast<std::size_t>(settings.connections);
  server.connections_of_client = static_cast<std::size_t>(settings.connections_of_address);
  server.bind = settings.bind;
  server.port = static_cast<std::uint16_t>(settings.port);
  server.tls = tlsFiles(settings, folder);
  server.allows_plain = settings.allows_plain;
  return server;
}

}  // namespace lamina
