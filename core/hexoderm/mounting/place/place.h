#pragma once

#include "hexoderm/base/message.h"
#include "hexoderm/base/triangle_mesh.h"
#include "hexoderm/skin/patch_on_link.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

struct PatchLinks;

/// How a patch is turned on its link, from gravity for example: R_true = R_l_o exp(e), e in the patch's frame.
struct KnownRotation {
  Eigen::Matrix3d R_l_o = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of e, rad^2, positive definite
};

/// How a patch is turned on a link, with its covariance, as findLinks() found it: of the link that it is placed on, of
/// one that fits, or of the one that comes nearest. nullopt where the link is none of these.
std::optional<KnownRotation> rotationByGravity(const PatchLinks& patch, std::string_view link);

/// A turn that gravity does not allow.
struct AgainstGravity {
  double angle_rad = 0;  ///< about the axes that are known
  double sigma_rad = 0;  ///< of how the patch is turned about them, the worst way
};
/// Whether R_l_o is another turn than the known one, about axes that are known to 15 degrees or better: by more than
/// `slack_rad` and its uncertainty make probable (99.9 %). `slack_rad`, above 0, is how far off R_l_o may be itself, 1
/// sigma an axis.
std::optional<AgainstGravity> againstGravity(const KnownRotation& known, const Eigen::Matrix3d& R_l_o,
                                             double slack_rad);

/// A patch whose place on the link is wanted.
struct PatchToPlace {
  CellId origin;
  std::vector<CellId> cells;  ///< the origin among them
  std::vector<SE3> T_o_u;     ///< of each
  /// How far off the cells may be, all together: 6 N x 6 N, row by row; of each cell first the position (m, patch
  /// frame) and then the rotation (rad, right-multiplied error in the cell frame). Relative to anything: a motion of
  /// the patch as a whole goes into its place.
  std::vector<double> covariance;
  bool covariance_assumed = false;        ///< what was solved or read states none
  std::optional<KnownRotation> rotation;  ///< nothing: any
  /// T_l_o where the patch was put by hand (PatchByHand): the fit from there is one more candidate.
  std::optional<SE3> start;
};

/// A patch as it was solved: with the covariance of all cells together where a fresh result of the global solver has
/// it; of a file relative to the patch as a whole, cell by cell; where none is stated, 2 mm and 3 degrees for each
/// cell. Of patches of more than 150 cells, 150 all over the patch.
PatchToPlace patchToPlace(const PatchReconstruction& patch);

/// What is known of where patches are on one link. At least one of surface, points and distances.
struct PlaceTask {
  std::string link;
  std::vector<PatchToPlace> patches;
  /// The link's surface in its frame l: the backs of all cells lie on it, their z along its outward normal.
  std::optional<TriangleMesh> surface;
  double thickness_m = 0;  ///< from front to back of a cell, CellModel::thickness_m
  std::vector<KnownPoint> points;
  std::vector<KnownDistance> distances;
};

inline constexpr double kMaxPlaceLength_m = 100;  ///< no length of a task or its options may be larger
inline constexpr double kMinPlaceSigma_m = 1e-6;  ///< nor a sigma smaller
/// Throws InvalidArgument naming what is out of these limits, its value and the range.
void requirePlaceable(const KnownPoint& point);
void requirePlaceable(const KnownDistance& distance);  ///< likewise

/// What a patch is placed by.
struct PlaceOptions {
  double surface_sigma_m = 0.001;  ///< how far a cell's back lies off the mesh, 1 sigma
  double normal_sigma_rad = 0;     ///< how far its z is off the normal, an axis; set by the constructor to 3 degrees
  double gap_m = 0;                ///< of glue or cloth between backs and mesh
  /// Probability with which the true place is called one that doesn't fit.
  double false_alarm = 1e-3;
  /// What moves the cells so far at 1 sigma, in the mean, is free.
  double free_m = 0.010;
  std::size_t most_candidates = 20;

  PlaceOptions();
  /// Throws InvalidArgument naming the option, its value and the range.
  void validate() const;
};

/// A way in which a patch can be moved without lying worse.
struct FreeDirection {
  /// The way in which it can be moved.
  enum class Kind { Slide, Turn, Screw };
  Kind kind = Kind::Slide;
  /// The motion as a twist in the link's frame: x moves by shift_m + turn_rad x x. Scaled to move the cells by 1 m,
  /// rms.
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();      ///< unit: along which it slides, about which it turns
  Eigen::Vector3d through_m = Eigen::Vector3d::Zero();  ///< a point of the axis; of a slide the patch's middle
  double sigma_m = 0;                                   ///< of the cells, rms, with all that is known
  /// The surface, points and distances leave it open, and how the patch is turned decides it.
  bool held_by_rotation = false;
  /// How far one can go while it still fits, forwards and backwards: motion of the cells, rms, along the way; and the
  /// turn. 0 where the rotation holds it.
  double forward_m = 0;
  double backward_m = 0;
  double forward_rad = 0;
  double backward_rad = 0;
  bool all_the_way = false;  ///< round and round
  /// Places of the patch, T_l_o, from as far back as it fits to as far forward, every 4 mm or less; empty where the
  /// rotation holds it.
  std::vector<SE3> way;
  Message words;
};

/// A cell in the link's frame.
struct CellOnLink {
  CellId cell;
  SE3 T_l_u;
  /// Of shape and place together: position (m, link frame), then rotation (rad, right-multiplied error in the cell
  /// frame).
  Matrix6d cov_t_r = Matrix6d::Zero();
  std::optional<double> above_m;  ///< how far its back is above the mesh, less the gap
};

/// A patch where it fits.
struct PlacedPatch {
  PatchOnLink place;              ///< cov_t_r is always stated
  std::vector<CellOnLink> cells;  ///< of PatchToPlace
  std::vector<FreeDirection> free;
};

/// One way in which the patches can lie.
struct PlaceCandidate {
  std::vector<PlacedPatch> patches;  ///< as in PlaceTask
  double chi_squared = 0;
  int freedom = 0;
  double probability = 1;  ///< of a misfit at least as large where the patches do lie so
  double rms_m = 0;        ///< of distances to the surface, points and distances
  bool fits = true;
  bool by_hand = false;  ///< of the place at which patches were put by hand; given even where it does not fit
};

/// What can be said about the place.
enum class PlaceVerdict {
  Placed,    ///< one place fits, and no direction is free
  Open,      ///< one place fits, and the patch can be moved along it
  Several,   ///< several places fit
  NoneFits,  ///< the best is given, though it does not fit
  TooLarge,  ///< the patch is larger than the link, or the link too large to be searched: no candidates
};
std::string_view placeVerdictName(PlaceVerdict verdict);  ///< "placed", "open", "several", "none_fits", "too_large"

/// All places that fit, the best first.
struct PlaceResult {
  PlaceVerdict verdict = PlaceVerdict::NoneFits;
  std::vector<PlaceCandidate> candidates;  ///< the best first
  Message summary;                         ///< one sentence or two
  std::vector<Message> remarks;            ///< what was taken otherwise than given, and what is doubtful
};

/// Where patches lie on a link: all places that fit surface, points, distances and rotations, by weighted least squares
/// with the covariances of the cells' own places. The rule is in core/hexoderm/mounting/place/README.md.
///
/// Throws InvalidArgument for a task that makes none: no patches, nothing known but rotations, cells that no patch has
/// or two have, a distance inside a patch, lengths and sigmas out of their ranges, a mesh in which no triangle has an
/// area, numbers that are not finite.
PlaceResult placePatches(const PlaceTask& task, const PlaceOptions& options = {});

}  // namespace hexoderm
