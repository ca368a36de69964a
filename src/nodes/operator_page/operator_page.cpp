// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "operator_page.hpp"

#include <std_msgs/String.h>

#include <filesystem>

#include "lamina/base/error.hpp"
#include "log_bridge.hpp"
#include "names.hpp"
#include "page_files.hpp"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr double kTick = 0.1;  // [s]
constexpr int kReachable = 9002;
constexpr int kAuditBroken = 9003;
constexpr int kStoreDamaged = 7001;

/// The folder of the page, with an empty one for uploads; both for their owner alone.
std::string madePageFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  const fs::path uploads = fs::path(folder) / "uploads";
  // What an earlier run has left there was never put into the queue.
  if (!error) fs::remove_all(uploads, error);
  if (!error) fs::create_directory(uploads, error);
  if (!error) fs::permissions(uploads, fs::perms::owner_all, error);
  if (error) throw FileError(folder + ": cannot be made: " + error.message());
  return fs::absolute(folder).string();
}

std::string lostTokens(const std::string& store) {
  return "page.db was damaged and moved to " + store + "; a new one without tokens has begun";
}

}  // namespace

OperatorPage::OperatorPage(ros::NodeHandle node, const OperatorPageSettings& settings)
    : settings_(settings),
      address_(node.advertise<std_msgs::String>(names::kPageAddress, 1, true)),
      desk_(node, settings.patience_s),
      damaged_store_(moveDamagedStoreAside(madePageFolder(settings.folder) + "/page.db")),
      store_(fs::absolute(settings.folder).string() + "/page.db") {
  const std::string folder = fs::absolute(settings.folder).string();
  if (!damaged_store_.empty()) ROS_ERROR_STREAM(lostTokens(damaged_store_));
  site_ = std::make_unique<OperatorSite>(siteOf(settings, folder), desk_, store_, pageFiles());
  camera_ = std::make_unique<CameraIntake>(node, settings.camera_topic,
                                           [this](std::string jpeg) { site_->setFrame(std::move(jpeg)); });
  const WebServerSettings server = webServerOf(settings, folder);
  server_ = std::make_unique<WebServer>(server, *site_, rosLog());
  if (server.tls) ROS_INFO_STREAM("certificate, SHA-256: " << tlsFingerprint(server.tls->certificate));
  for (const std::string& notice : site_->settings().notices) ROS_WARN_STREAM(notice);
  const boost::function<void(const ros::WallTimerEvent&)> tick = [this](const auto&) { onTick(); };
  timer_ = node.createWallTimer(ros::WallDuration(kTick), tick);
  std_msgs::String address;
  address.data = server_->address();
  address_.publish(address);
  ROS_INFO_STREAM("the page is at " << address.data);
}

void OperatorPage::onTick() {
  desk_.setCamera(camera_->isThere());
  try {
    site_->observe({clock_.now(), ros::WallTime::now().toSec()});
  } catch (const Error& error) {
    ROS_ERROR_STREAM_THROTTLE(60.0, "the page cannot be informed of the cell: " << error.what());
  }
  if (!is_exposure_reported_ && desk_.snapshot().heard_s) tellExposure();
}

/// Once the unit is there to hear it.
void OperatorPage::tellExposure() {
  is_exposure_reported_ = true;
  for (const std::string& notice : site_->settings().notices) desk_.report(kReachable, 0.0, notice);
  if (!damaged_store_.empty()) desk_.report(kStoreDamaged, 0.0, lostTokens(damaged_store_));
  if (const auto bad = store_.firstBadAudit())
    desk_.report(kAuditBroken, static_cast<double>(*bad),
                 "row " + std::to_string(*bad) + " of the page's audit was edited, removed or added");
}

}  // namespace lamina
