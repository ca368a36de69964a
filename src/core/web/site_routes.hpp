// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lamina/web/cell_history.hpp"
#include "lamina/web/operator_site.hpp"

namespace lamina {

/// Objects that all routes use.
struct SiteParts {
  SiteParts(SiteSettings given, CellDesk& cell_desk, WebStore& web_store, std::vector<PageFile> page)
      : settings(std::move(given)),
        desk(cell_desk),
        store(web_store),
        access(settings.access, web_store),
        files(std::move(page)) {}
  SiteSettings settings;
  CellDesk& desk;
  WebStore& store;
  WebAccess access;
  std::vector<PageFile> files;
  std::mutex history_mutex;
  CellHistory history;
};

/// A request with what routes need to answer it.
struct SiteCall {
  SiteParts& parts;
  const WebRequest& request;
  const OperatorSite::Admitted& admitted;
  CellTime now;

  const WebIdentity& who() const { return admitted.who; }
  /// Name under which the request is reported to the cell: "page: anna".
  std::string source() const { return "page: " + admitted.who.name; }
  const std::string& value(std::size_t place) const { return admitted.values.at(place); }
};

using SiteHandler = WebResponse (*)(SiteCall& call);

struct SiteRoute {
  RouteRow row;
  SiteHandler handler = nullptr;
};

std::vector<SiteRoute> pageRoutes();       ///< files of the page, sessions, tokens, keys, audit
std::vector<SiteRoute> cellRoutes();       ///< the cell by /api/v1
std::vector<SiteRoute> partRoutes();       ///< records of parts that were made
std::vector<SiteRoute> octoprintRoutes();  ///< OctoPrint's interface, as slicers use it

// Answers.

WebResponse jsonAnswer(int status, const nlohmann::json& value);
/// {code, message}
WebResponse errorAnswer(int status, const std::string& code, const std::string& message);
/// The answer to a command; if the unit refused it, with the commands that it would accept.
WebResponse orderAnswer(const SiteCall& call, const DeskAnswer& answer);
/// The body as a JSON object.
/// @throws InvalidInput if it is none
nlohmann::json bodyObject(const SiteCall& call);
/// Number of an alarm or token, from the path.
/// @throws InvalidInput if it is no whole number from 0 to 2^53
std::int64_t wholeNumber(const std::string& text);
/// Number of a job, from the path.
/// @throws InvalidInput if it is no whole number from 0 to 2^32 - 1, as messages carry it
std::int64_t jobNumber(const std::string& text);
/// A text of a JSON object; empty if it is missing.
/// @throws InvalidInput if it is not a text
std::string textOf(const nlohmann::json& object, const std::string& key);

// The cell as JSON.

/// Whether the unit has been heard from within the last three seconds.
bool isFresh(const CellSnapshot& seen, const CellTime& now);

nlohmann::json stateJson(SiteParts& parts, WebRole role, const CellTime& now);
nlohmann::json jobJson(const ShownJob& job);
nlohmann::json alarmsJson(const CellSnapshot& seen);
nlohmann::json startupJson(const CellSnapshot& seen);
nlohmann::json layersJson(const CellSnapshot& seen);

/// Adds an uploaded program to the queue, or the program that an uploaded mesh is sliced into.
/// @throws InvalidInput as `meshOf`
DeskAnswer enqueueUpload(SiteCall& call, const std::string& source);

}  // namespace lamina
