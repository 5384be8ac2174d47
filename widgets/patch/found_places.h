#pragma once

#include "hexoderm/base/finding.h"
#include "widgets/scene/scene_pointing.h"

#include <algorithm>
#include <span>
#include <vector>

namespace hexoderm {

/// Where something was found, to be pointed out in the picture.
struct FoundPlace {
  SceneHit at;
  Severity severity = Severity::Warning;
  friend bool operator==(const FoundPlace&, const FoundPlace&) = default;
};

inline constexpr std::size_t kCellsOfOnePlace = 2;  // what names more is about the skin
inline bool isFindingOfLink(const Finding& finding) { return finding.cells.size() == 2 && finding.ports.size() == 2; }

/// The cells and links that errors and warnings are about, errors first, in the order of the findings, each once and
/// `most` at most. Left out are findings of the whole skin, and those of links at a cell that has one of its own, which
/// they follow from.
inline std::vector<FoundPlace> foundPlaces(std::span<const Finding> findings, std::size_t most) {
  std::vector<FoundPlace> places;
  const auto has = [&](CellId cell) {
    return std::ranges::any_of(places, [cell](const FoundPlace& place) { return place.at.cell == cell; });
  };
  const auto forSeverity = [&](Severity severity, bool links) {
    for (const Finding& finding : findings) {
      if (finding.severity != severity || finding.cells.size() > kCellsOfOnePlace ||
          isFindingOfLink(finding) != links) {
        continue;
      }
      if (!links) {
        for (const CellId cell : finding.cells) {
          if (!has(cell)) places.push_back({{cell, std::nullopt}, severity});
        }
        continue;
      }
      const LinkEnd a{finding.cells[0], finding.ports[0]};
      const LinkEnd b{finding.cells[1], finding.ports[1]};
      if (has(a.cell) || has(b.cell)) continue;
      const bool is_known = std::ranges::any_of(places, [&](const FoundPlace& place) {
        return place.at.link == std::pair(a, b) || place.at.link == std::pair(b, a);
      });
      if (!is_known) places.push_back({{std::nullopt, std::pair(a, b)}, severity});
    }
  };
  for (const bool links : {false, true}) {
    for (const Severity severity : {Severity::Error, Severity::Warning}) forSeverity(severity, links);
  }
  std::ranges::stable_sort(places, std::ranges::greater{}, &FoundPlace::severity);
  if (places.size() > most) places.resize(most);
  return places;
}

}  // namespace hexoderm
