// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <future>
#include <memory>
#include <mutex>
#include <vector>

#include "cell_settings.hpp"
#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/cell_journal.hpp"
#include "messages.hpp"

namespace lamina {

/// Takes programs and toolpaths for the queue in a thread of its own: storing and checking large ones takes
/// minutes, for which no command may wait. Accepted files are added to the journal by the journal's own
/// thread; files of refused ones are removed from the store.
class JobIntake {
 public:
  /// `artefacts` outlives it.
  JobIntake(ros::NodeHandle node, ArtefactStore& artefacts, CellControllerSettings settings);
  ~JobIntake();
  JobIntake(const JobIntake&) = delete;
  JobIntake& operator=(const JobIntake&) = delete;

  /// Adds the programs accepted since the last call.
  /// @return whether there were any
  bool addTo(CellJournal& journal, double utc_s);

 private:
  struct Checked {
    NewJob job;
    std::promise<std::int64_t> id;
  };
  bool onEnqueue(lamina_msgs::EnqueueJob::Request& request, lamina_msgs::EnqueueJob::Response& response);
  std::int64_t enqueue(const lamina_msgs::EnqueueJob::Request& request);
  /// Returns once the journal's thread has added it.
  std::int64_t add(NewJob job);

  ros::NodeHandle node_;
  ArtefactStore& artefacts_;
  CellControllerSettings settings_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<Checked>> checked_;
  ros::CallbackQueue callbacks_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_;
};

}  // namespace lamina
