#pragma once

#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/place/place.h"
#include "widgets/verify/verify_words.h"

#include <QString>
#include <vector>

namespace hexoderm {

// What is known of places on a robot, in words for lists and sentences. The sentences themselves are core's.

/// A link to choose from.
struct LinkChoice {
  QString link;
  QString text;
  friend bool operator==(const LinkChoice&, const LinkChoice&) = default;
};
/// Links that fit, the best first, those that the poses can't tell apart one below the other; then the nearest where
/// none fits.
std::vector<LinkChoice> linkChoices(const PatchLinks& patch);
VerifySentence linkText(const PatchLinks& patch);

/// One place, for a list: its number, misfit, and what is left open. `chosen`: the patch is there.
QString placeInList(const PlaceCandidate& candidate, std::size_t number, bool chosen);
/// What all places together say, and in which ways the patch can be moved from the one at `row` (0 if there is none).
VerifySentence placesText(const PlaceResult& result, std::size_t row);

/// "Cell 3 at (12.0, -3.5, 80.0) mm ± 1.0 mm", "Cell 3 to cell 20: 84.0 mm ± 1.0 mm".
QString pointText(const KnownPoint& point);
QString distanceText(const KnownDistance& distance);

/// All sentences as one, one a line, with the gravest tone; with signs of their own where they are several.
VerifySentence together(const std::vector<VerifySentence>& sentences);

}  // namespace hexoderm
