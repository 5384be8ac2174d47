#pragma once

#include "hexoderm/util/finding.h"
#include "widgets/scene/scene_pointing.h"

#include <span>
#include <vector>

namespace hexoderm {

/// Where something was found, to be pointed out in the picture.
struct FoundPlace {
  SceneHit at;
  Severity severity = Severity::Warning;
  friend bool operator==(const FoundPlace&, const FoundPlace&) = default;
};

/// The cells and links that errors and warnings are about, errors first, in the order of the findings, each once and
/// `most` at most. Left out are findings of the whole skin, and those of links at a cell that has one of its own, which
/// they follow from.
std::vector<FoundPlace> foundPlaces(std::span<const Finding> findings, std::size_t most);

}  // namespace hexoderm
