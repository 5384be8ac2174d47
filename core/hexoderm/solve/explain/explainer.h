#pragma once

#include "hexoderm/solve/estimate/estimate.h"

#include <functional>
#include <optional>

namespace hexoderm {

/// Looks for one kind of fault. It is asked with one estimate after another, each without what was explained before, as
/// long as it finds anything.
struct Explainer {
  Estimate::Stage needs{};  ///< how far the estimate must be brought for it
  /// The most probable explanation of what fits worst in the estimate; nothing where all that is left may be chance.
  std::function<std::optional<Explanation>(const Estimate&)> explain;
};

/// By the rotations of links: cells whose accelerometers are all turned or reflected alike against those of the others.
/// For every exchange and negation of axes, and turns by a side of the cell, those cells are a group with which the
/// links fit best; what their readings are turned by is taken back.
Explainer makeTurnedGroupExplainer();

/// By the turns that all links of a patch have in common (TurnMap): axes or ports that are not as in the cell model. It
/// ends the search. Says with which exchange of axes, or numbering of ports, all links fit, if there is one.
Explainer makeWholeSkinExplainer();

/// By the links' rotations: every cell has the readings of the cell with the next ID, or the one before. Asked once.
Explainer makeShiftedIdExplainer();

/// By neighbouring cells alone (SuspectSearch): a pose in which the part moved, cells that contradict their neighbours,
/// and then the links that no skin link can be. A cell that two poses don't clearly show to be wrong is called
/// suspicious and stays, and so do its links.
Explainer makeNeighborExplainer();

/// By the joint estimate, where a link leaves its loops open: a tear through it or through links that stand out more
/// (tearThrough()). Weighed before cells and links beside it, which a torn patch strains.
Explainer makeTearExplainer();

/// By the joint estimate: the pose in which the part was in motion, for most cells leave more unexplained than in the
/// others.
Explainer makeMovingPoseExplainer();

/// By the joint estimate: in every patch the cell whose readings fit the gravity of all others worst, in whatever
/// position, or which turned against them between two poses; and cells away from it that fit about as badly.
Explainer makeMisfitExplainer();

/// By the joint estimate: in every patch the link that leaves its loops open by more than askew cells can, a cable that
/// looks like a skin link in its angles. One link a patch, because the others give way to it.
Explainer makeOpenLinkExplainer();

/// By the attitudes of solved patches (findAttitudeSuspects()): links, and cells that are mounted otherwise or whose
/// readings are each other's. Of a tree's readings also what a hand that turned the part added to them.
Explainer makeAttitudeExplainer();

/// By the signs of the bends of all links, once nothing else is left: a skin that bends inwards nearly everywhere lies
/// in a hollow, or comes out inside out. Asks which, unless the session says so; if that contradicts the bends, the
/// cell model is wrong. Of a flat skin nothing is said.
Explainer makeInsideOutExplainer();

}  // namespace hexoderm
