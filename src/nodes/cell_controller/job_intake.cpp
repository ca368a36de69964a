// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job_intake.hpp"

#include <chrono>
#include <filesystem>
#include <utility>

#include "drive_settings.hpp"
#include "job_rules.hpp"
#include "lamina/base/error.hpp"
#include "lamina/cell/machine_sheet.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "status.hpp"

namespace lamina {
namespace {

constexpr std::chrono::milliseconds kLook(50);

/// The node may end before a large file is checked.
class NodeProgress final : public Progress {
 public:
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return !ros::ok(); }
};

}  // namespace

JobIntake::JobIntake(ros::NodeHandle node, ArtefactStore& artefacts, CellControllerSettings settings)
    : node_(node), artefacts_(artefacts), settings_(std::move(settings)), spinner_(1, &callbacks_) {
  node.setCallbackQueue(&callbacks_);
  service_ = node.advertiseService(names::kEnqueueJob, &JobIntake::onEnqueue, this);
  spinner_.start();
}

JobIntake::~JobIntake() { spinner_.stop(); }

bool JobIntake::addTo(CellJournal& journal, double utc_s) {
  std::vector<std::shared_ptr<Checked>> checked;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    checked.swap(checked_);
  }
  for (const auto& row : checked) {
    try {
      row->id.set_value(journal.addJob(row->job, utc_s));
    } catch (const Error&) {
      row->id.set_exception(std::current_exception());
    }
  }
  return !checked.empty();
}

bool JobIntake::onEnqueue(lamina_msgs::EnqueueJob::Request& request,
                          lamina_msgs::EnqueueJob::Response& response) {
  try {
    response.job = static_cast<std::uint32_t>(enqueue(request));
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"put into the queue", request.program, ""}, failure));
    response.status = toMessage(failure);
  }
  return true;
}

std::int64_t JobIntake::enqueue(const lamina_msgs::EnqueueJob::Request& request) {
  if (settings_.executor == ExecutorKind::Driver) requireDriveSettings(node_, settings_.drive);
  const std::filesystem::path path(request.program);
  const std::string file = path.filename();
  const std::string name = request.name.empty() ? file : request.name;
  // Uploads have no suffix of their own, and files that were kept have no other name than their digest.
  const bool is_name_of_file =
      !path.has_extension() || path.extension() == std::filesystem::path(name).extension();
  std::vector<KeptFile> files = {
      artefacts_.keepFile(request.program, "program", is_name_of_file ? name : file)};
  const auto removeNew = [&] {
    for (const KeptFile& each : files)
      if (each.is_new) artefacts_.remove(each.artefact);
  };
  std::int32_t layers = 0;
  try {
    NodeProgress progress;
    layers = checkedLayers(artefacts_.pathOf(files.front().artefact), name, settings_, progress);
  } catch (...) {
    removeNew();
    throw;
  }
  try {
    if (!request.mesh.empty()) files.push_back(artefacts_.keepFile(request.mesh, "mesh", request.mesh_name));
    std::vector<Artefact> artefacts;
    artefacts.reserve(files.size() + 1);
    for (const KeptFile& each : files) artefacts.push_back(each.artefact);
    // All jobs of a machine share it: it stays also if this one is not taken.
    artefacts.push_back(artefacts_.keepText(jobSheet(settings_), kMachineSheet, "machine.txt"));
    return add({name, request.part, settings_.machine.name, artefacts, request.source, layers});
  } catch (const Cancelled&) {
    throw;  // the journal may still have taken it
  } catch (...) {
    removeNew();
    throw;
  }
}

std::int64_t JobIntake::add(NewJob job) {
  const auto checked = std::make_shared<Checked>();
  checked->job = std::move(job);
  std::future<std::int64_t> id = checked->id.get_future();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    checked_.push_back(checked);
  }
  while (id.wait_for(kLook) != std::future_status::ready)
    if (!ros::ok()) throw Cancelled("the node ends before the job was added to the queue");
  return id.get();
}

}  // namespace lamina
