// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/role_feed.hpp"

#include <algorithm>

namespace lamina {
namespace {

double feedOf(PathRole role, const FeedSettings& feed) {
  switch (role) {
    case PathRole::OuterWall:
      return feed.outer_wall_mm_s;
    case PathRole::InnerWall:
      return feed.inner_wall_mm_s;
    case PathRole::Skirt:
    case PathRole::Brim:
    case PathRole::Raft:
    case PathRole::Prime:
      return feed.skirt_mm_s;
    case PathRole::Bridge:
      return feed.bridge_mm_s;
    case PathRole::Ironing:
      return feed.ironing_mm_s;
    case PathRole::Support:
      return feed.support_mm_s;
    case PathRole::SupportInterface:
      return feed.support_interface_mm_s;
    case PathRole::TopSkin:
      return feed.top_skin_mm_s;
    case PathRole::Skin:
    case PathRole::BottomSkin:
      return feed.skin_mm_s;
    default:
      return feed.infill_mm_s;
  }
}

}  // namespace

double feedIn(const FeedSettings& feed, PathRole role, std::size_t layer) {
  const double usual = feedOf(role, feed);
  return layer == 0 ? std::min(usual, feed.first_layer_mm_s) : usual;
}

}  // namespace lamina
