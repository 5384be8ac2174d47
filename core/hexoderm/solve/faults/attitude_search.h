#pragma once

#include "hexoderm/solve/faults/own_attitudes.h"
#include "hexoderm/solve/faults/patch_shape.h"
#include "hexoderm/solve/tree/skin_links.h"

#include <span>
#include <vector>

namespace hexoderm {

/// What does not fit about a patch's attitudes, as far as readings and links together show it.
struct AttitudeSuspect {
  enum class Kind {
    Link,     ///< turned further than a skin link can be
    Cell,     ///< its readings belong to another attitude, and its links agree on which
    Swapped,  ///< two neighbours fit with each other's readings
    Moved,    ///< turned against the others between two poses
    Patch,    ///< the links' twists belong to no surface: axes or ports of all cells are not as the cell model has them
  };
  Kind kind{};
  std::size_t cell = 0;   ///< Cell, Swapped, Moved
  std::size_t other = 0;  ///< Swapped
  std::size_t link = 0;   ///< Link
  FindingCode
      angle{};  ///< Link: the angle that is furthest off, as ImplausibleBend, ImplausibleTwist or ImplausibleYaw
  double angle_rad = 0;   ///< Link: that angle; Cell, Moved: the turn; Patch: the mean twist
  std::size_t pose = 0;   ///< Moved: of the snapshot, the first after the turn
  double lowest_rad = 0;  ///< Link: what the angle may be in this patch
  double highest_rad = 0;
  double evidence = 0;  ///< logarithm of the likelihood ratio, less the cost of what it leaves free
};

/// Compares the attitude that each cell's own readings show with what its links allow.
///
/// Own attitudes R_c come from the readings and the patch's forces alone, errors of the sensors granted (findAttitude);
/// C_c is their covariance. What a cell's neighbours say about its attitude runs along the links (belief propagation:
/// exact in trees, and cut short after a few links, lest it come back in loops). A link's angles are those of R_c^T
/// R_n. In the elastomer's mould neighbours' angles belong to a surface: with the shape operator S (symmetric, the same
/// for the patch), a link in the direction u bends by u^T S u and twists by -(z x u)^T S u; what is left scatters with
/// deviations that start as the cell model's and follow what the patch shows beyond the errors of its readings (bend
/// and twist; yaw never falls below the model's). Real skins that lie irregularly get wide limits in this way, and
/// regular ones narrow limits.
///
/// A link's angles are compared with that scatter and what both sides say about its cells; a cell's misfit with all its
/// links is a chi-squared with three degrees of freedom, and so is what is gained if it may have turned between two
/// poses; the swap of two neighbours' readings is a likelihood ratio. The limits follow from the number of tests and
/// from how many patches there may be to a false alarm, were all deviations exactly the stated ones. The patch as a
/// whole is tested by the part of S that no surface has, its antisymmetric one: a constant twist.
///
/// The most probable faults of `cells`, of one patch and ascending, the clearest first; what one explains isn't
/// reported again. `own`: of these cells.
std::vector<AttitudeSuspect> findAttitudeSuspects(const SkinLinks& skin, std::span<const std::size_t> cells,
                                                  OwnAttitudes own);

}  // namespace hexoderm
