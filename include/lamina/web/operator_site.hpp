// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lamina/cell/production_cell.hpp"
#include "lamina/web/cell_desk.hpp"
#include "lamina/web/http_message.hpp"
#include "lamina/web/upload_room.hpp"
#include "lamina/web/web_access.hpp"
#include "lamina/web/web_store.hpp"

namespace lamina {

/// A file of the page, as it stands in the binary.
struct PageFile {
  std::string_view name;  ///< "page.css"
  std::string_view type;  ///< "text/css; charset=utf-8"
  std::string_view bytes;
};

/// What uploads with `print=true` come to.
enum class UploadPrint : std::uint8_t {
  Wait,    ///< the job waits for somebody to release it
  Release  ///< it is released if an operator sends it
};

struct SiteSettings {
  WebAccessSettings access;
  std::string upload_folder;
  std::uint64_t most_upload_bytes = std::uint64_t{1} << 30;
  FreeBytes free_bytes = freeForUploads;  ///< of the folder of uploads
  std::string journal_folder;             ///< of the cell, that records of parts are read from
  UploadPrint upload_print = UploadPrint::Wait;
  std::vector<std::string> notices = {};  ///< shown on the page for as long as it runs
};

/// How the body of a request is taken.
enum class RouteBody : std::uint8_t {
  None,
  Small,   ///< at most 64 KiB
  Upload,  ///< a form with a file
  Socket,  ///< becomes a WebSocket
  Camera   ///< is answered by pictures, one after the other
};

/// A row of the table of routes.
struct RouteRow {
  HttpMethod method = HttpMethod::Get;
  std::string pattern;  ///< "/api/v1/jobs/{id}/release"
  WebRight right = WebRight::None;
  RouteBody body = RouteBody::None;
};

constexpr std::uint64_t kMostSmallBody = 65536;

/// The operator's page and its interface: requests in, answers out, orders to the cell. Knows no sockets.
///
/// A request is first admitted by its head, then answered with its body. Whatever changes something, and
/// whatever is refused, stands in the audit. Several threads call at a time.
class OperatorSite {
 public:
  /// A request whose head was taken.
  struct Admitted {
    std::size_t route = 0;
    RouteBody body = RouteBody::None;
    WebIdentity who;
    std::vector<std::string> values;  ///< of the pattern's places
    HttpTarget target;
    std::shared_ptr<UploadPlace> place = nullptr;  ///< on the disk, of uploads, for as long as this is there
  };

  /// `desk` and `store` outlive it.
  OperatorSite(SiteSettings settings, CellDesk& desk, WebStore& store, std::vector<PageFile> files);
  ~OperatorSite();

  /// All routes, in the order in which they are tried.
  static std::vector<RouteRow> routes();

  const SiteSettings& settings() const;

  std::variant<Admitted, WebResponse> admit(const HttpHead& head, const CellTime& now);
  WebResponse answer(const Admitted& admitted, const WebRequest& request, const CellTime& now);

  /// Notes a request that broke off, or was refused before it could be admitted.
  void noteRefusal(const HttpPeer& peer, const std::string& what, const std::string& reason,
                   const CellTime& now);

  /// Looks at the cell; call it some ten times a second.
  void observe(const CellTime& now);

  /// What WebSockets are sent: the state as JSON, and the number of the change.
  struct Live {
    std::uint64_t number = 0;
    std::shared_ptr<const std::string> text;
  };
  Live live(WebRole role) const;
  /// False when a WebSocket's session has ended, or its token is gone.
  bool isStillIn(const WebIdentity& who, const HttpHead& head, const CellTime& now);

  /// The last picture of the camera, as JPEG.
  struct Frame {
    std::uint64_t number = 0;  ///< from 1; 0 for none yet
    std::shared_ptr<const std::string> jpeg;
  };
  void setFrame(std::string jpeg);
  Frame frame() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace lamina
