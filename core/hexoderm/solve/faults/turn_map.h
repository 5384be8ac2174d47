#pragma once

#include "hexoderm/solve/tree/skin_links.h"

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace hexoderm {

/// A link's turn beyond its nominal alignment.
struct DirectedTurn {
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();  ///< twist, bend and yaw, about the linkAxes() of its source
  double heading_rad = 0;                              ///< of the link in the sheet laid flat
};

/// What the turns of a patch's links have in common: the linear map B (3 x 2) from a link's direction u in the sheet
/// laid flat to its turn B u that fits most links (least squares, twice less the links that are far off). On a surface
/// with the shape operator S it is J S, with J a quarter turn about z, and S is symmetric: no surface yaws with the
/// direction, or has an antisymmetric S. Where all links go one way, only a yaw tells.
struct TurnMap {
  double bend_rad = 0;  ///< mean over links of u^T S u; positive: outwards
  double bend_sigma_rad = 0;
  double unlike_rad = 0;  ///< rms over links of the part that belongs to no surface
  double deviate = 0;     ///< that part in deviations, as the links scatter about the map
  double far_off = 0;     ///< share of the links that are turned by more than 75 degrees
};

TurnMap fitTurnMap(std::span<const DirectedTurn> turns);

/// Heading of a port in its cell.
double headingOf(const Port& port);

/// Headings of the x axes of a patch's cells in the sheet laid flat, by their place in the patch, against one of them:
/// by the ports, as if every link lay in one plane.
/// `of`: the heading of a port in its cell.
std::vector<double> flatHeadings(const SkinLinks& skin, std::size_t patch,
                                 const std::function<double(const Port&)>& of = headingOf);

}  // namespace hexoderm
