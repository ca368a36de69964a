// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes what a bag holds of a machine and its sensor as tables that `lamina calibrate` reads.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "bag_recording.hpp"
#include "lamina/base/error.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Write poses.csv and profiles.csv of a bag", "lamina-bag-tables"};
  std::string bag;
  std::string folder;
  lamina::BagNames names;
  app.add_option("bag", bag, "Bag with tf and profile")->required();
  app.add_option("-o,--output", folder, "Folder to write to, which is made if need be")->required();
  app.add_option("--profile", names.profile, "Topic of the profiles")->capture_default_str();
  app.add_option("--bed", names.bed, "Frame of the bed")->capture_default_str();
  app.add_option("--nozzle", names.nozzle, "Frame of the nozzle")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    const lamina::BagRecording read = lamina::readBagRecording(bag, names);
    std::filesystem::create_directories(folder);
    lamina::writeRecording(folder, read.recording);
    std::printf(
        "%zu poses, %zu profiles; left out: %llu malformed clouds, %llu points that are not finite or "
        "zero, %llu stamps without a pose of the nozzle\n",
        read.recording.poses.size(), read.recording.profiles.size(),
        static_cast<unsigned long long>(read.malformed),
        static_cast<unsigned long long>(read.points_not_finite),
        static_cast<unsigned long long>(read.stamps_without_pose));
    return 0;
  } catch (...) {
    // Read by `lamina calibrate`, which says the same of a bag as of a folder.
    std::fprintf(stderr, "%s\n", lamina::currentFailure().message.c_str());
    return 1;
  }
}
