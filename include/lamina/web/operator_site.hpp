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
#include "lamina/web/state_bell.hpp"
#include "lamina/web/upload_room.hpp"
#include "lamina/web/web_access.hpp"
#include "lamina/web/web_store.hpp"

namespace lamina {

/// A file of the page, as it is contained in the executable.
struct PageFile {
  std::string_view name;  ///< "page.css"
  std::string_view type;  ///< "text/css; charset=utf-8"
  std::string_view bytes;
};

/// What happens to jobs uploaded with `print=true`.
enum class UploadPrint : std::uint8_t {
  Wait,    ///< they wait for somebody to release them
  Release  ///< they are released if an operator has sent them
};

struct SiteSettings {
  WebAccessSettings access;
  std::string upload_folder;
  std::uint64_t most_upload_bytes = std::uint64_t{1} << 30;
  FreeBytes free_bytes = freeForUploads;  ///< returns the free space on the disk of `upload_folder`
  std::string journal_folder;  ///< folder of the cell's journal, from which records of parts are read
  UploadPrint upload_print = UploadPrint::Wait;
  double patience_s = 5.0;                ///< longest time on the way of a request that lets the unit move
  std::string identity = {};              ///< text that is unique to this page and remains over restarts
  std::vector<std::string> notices = {};  ///< shown on the page as long as the site runs
};

/// How the body of a request is received, or how the connection is used afterwards.
enum class RouteBody : std::uint8_t {
  None,
  Small,   ///< at most 64 KiB
  Upload,  ///< a form with a file
  Socket,  ///< becomes a WebSocket
  Camera   ///< answered by an endless sequence of pictures
};

/// A row of the table of routes.
struct RouteRow {
  HttpMethod method = HttpMethod::Get;
  std::string pattern;  ///< "/api/v1/jobs/{id}/release"
  WebRight right = WebRight::None;
  RouteBody body = RouteBody::None;
};

constexpr std::uint64_t kMostSmallBody = 65536;

/// The operator's page and its HTTP interface: receives requests, returns answers, and gives orders to the
/// cell. It does not handle sockets.
///
/// A request is first admitted by its head, then answered with its body. The audit has an entry for every
/// request that is to change something, and for a limited number of refused requests per second. May be
/// called from several threads.
class OperatorSite {
 public:
  /// A request that was admitted by its head.
  struct Admitted {
    std::size_t route = 0;  ///< index in `routes`
    RouteBody body = RouteBody::None;
    WebIdentity who;
    std::vector<std::string> values;  ///< values of the placeholders in the route's pattern
    HttpTarget target;
    /// For uploads: room on the disk, reserved as long as this object lives.
    std::shared_ptr<UploadPlace> place = nullptr;
  };

  /// `desk` and `store` must outlive the site.
  OperatorSite(SiteSettings settings, CellDesk& desk, WebStore& store, std::vector<PageFile> files);
  ~OperatorSite();

  /// All routes, in the order in which they are tried.
  static std::vector<RouteRow> routes();

  const SiteSettings& settings() const;

  /// Checks the head of a request: its target, origin, identity, rights, rate and size.
  /// @return the admitted request, or the answer that refuses it
  std::variant<Admitted, WebResponse> admit(const HttpHead& head, const CellTime& now);
  /// Carries out an admitted request. A request that changes something is carried out once for its
  /// `Idempotency-Key`, and repetitions get the same answer, unless it stops the unit or its answer is
  /// secret.
  WebResponse answer(const Admitted& admitted, const WebRequest& request, const CellTime& now);

  /// Enters in the audit a request that broke off, or was refused before `admit`.
  void noteRefusal(const HttpPeer& peer, const std::string& what, const std::string& reason,
                   const CellTime& now);

  /// Updates history and state from the cell; to be called about ten times a second. The state is written
  /// only while somebody hears its bell, which then is rung for each new one.
  void observe(const CellTime& now);

  /// The state that is sent to WebSockets, as JSON, and the number of its latest change.
  struct Live {
    std::uint64_t number = 0;
    std::shared_ptr<const std::string> text;
  };
  /// The state as a role may see it; without a text until `observe` is called while its bell is heard.
  Live live(WebRole role) const;
  StateBell& bell();
  /// Whether the owner of a WebSocket is still identified as before; false once its session has ended or its
  /// token was removed.
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
