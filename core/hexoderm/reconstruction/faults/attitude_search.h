#pragma once

#include "hexoderm/reconstruction/faults/own_attitudes.h"
#include "hexoderm/reconstruction/faults/patch_shape.h"
#include "hexoderm/reconstruction/links/skin_links.h"

#include <Eigen/Core>
#include <map>
#include <optional>
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
class AttitudeSearch {
 public:
  /// `cells`: of the patch, ascending. `own`: of these.
  AttitudeSearch(const SkinLinks& skin, std::span<const std::size_t> cells, OwnAttitudes own);

  /// The most probable faults, the clearest first; what one explains isn't reported again.
  [[nodiscard]] std::vector<AttitudeSuspect> suspects();

 private:
  /// A small turn e of a cell, R_true = R exp(e): its most probable value and the covariance about that.
  struct Turn {
    Eigen::Matrix3d covariance;
    Eigen::Vector3d mean;
  };
  /// What is known of the error e of a cell's own attitude, R_true = R exp(e): information and information times mean.
  struct Belief {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
    [[nodiscard]] Eigen::Matrix3d covariance() const;
    [[nodiscard]] Turn turn() const;
    void operator+=(const Belief& other);
  };
  /// A link between two cells with readings; cells by their place in the patch.
  struct Joint {
    std::size_t link = 0;  ///< of the graph
    std::size_t source = 0;
    std::size_t target = 0;
    Eigen::Matrix3d R_nom = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();   ///< twist, bend, yaw in the source's frame
    double heading_rad = 0;                               ///< of the link in the sheet laid flat
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();   ///< twist, bend and yaw by the shape
    Eigen::Matrix3d R_c_n = Eigen::Matrix3d::Identity();  ///< at these
    Eigen::Vector3d off = Eigen::Vector3d::Zero();        ///< offBy() of its cells
    bool open = true;                                     ///< not explained yet
    Belief to_source;                                     ///< what the target's side says about the source
    Belief to_target;
  };
  /// What all other links of its cells say about them.
  struct Beside {
    Belief source;
    Belief target;
  };
  /// What a turn between two poses must gain, as a chi-squared.
  struct MotionLimits {
    double of_two_angles = 0;
    double of_three_angles = 0;
  };
  [[nodiscard]] std::size_t placeOf(std::size_t cell) const;
  [[nodiscard]] std::vector<double> headings() const;
  [[nodiscard]] double strictness() const;
  void findJoints();
  [[nodiscard]] std::vector<SeenLink> seenLinks() const;
  [[nodiscard]] Eigen::Vector3d anglesOf(const Joint& joint, const OwnCell& source, const OwnCell& target) const;
  [[nodiscard]] Belief ownBelief(std::size_t place) const;
  [[nodiscard]] Belief beliefBeside(std::size_t place, const Joint* but) const;
  [[nodiscard]] Belief along(const Joint& joint, bool to_source) const;
  void passBeliefs();
  [[nodiscard]] Eigen::Matrix3d measured(const Joint& joint, const OwnCell& source, const OwnCell& target) const;
  void expect(const PatchShape& shape);
  void compareWithShape(Joint& joint) const;
  [[nodiscard]] static Eigen::Vector3d offBy(const Joint& joint, const OwnCell& source, const OwnCell& target);
  [[nodiscard]] Eigen::Matrix3d scatter() const;
  [[nodiscard]] double squaredMisfit(const Joint& joint, const OwnCell& source, const OwnCell& target) const;
  [[nodiscard]] std::optional<AttitudeSuspect> judgePatch(const PatchShape& shape) const;
  [[nodiscard]] std::vector<AttitudeSuspect> candidates();
  [[nodiscard]] std::optional<AttitudeSuspect> judgeLink(const Joint& joint, const Beside& beside) const;
  [[nodiscard]] Turn turnByLinks(std::size_t place) const;
  [[nodiscard]] std::optional<AttitudeSuspect> judgeCell(std::size_t place, const Turn& by_links) const;
  [[nodiscard]] std::optional<AttitudeSuspect> judgeMotion(std::size_t place, const Turn& by_links) const;
  void findLimits();
  [[nodiscard]] Eigen::Matrix3d ownScatter(std::size_t place) const;
  [[nodiscard]] std::optional<double> gainOfSwap(const Joint& joint, const Beside& beside, double limit) const;
  [[nodiscard]] double mostPairMisfit(const Joint& joint, const Beside& beside) const;
  [[nodiscard]] double pairMisfit(const Joint& joint, const Beside& beside, const OwnCell& source,
                                  const OwnCell& target) const;
  /// Places in the patch of the cells that a suspicion is about.
  [[nodiscard]] std::vector<std::size_t> placesOf(const AttitudeSuspect& suspect) const;
  void explain(const AttitudeSuspect& suspect);
  [[nodiscard]] bool tested(const Joint& joint) const;

  const SkinLinks& skin_;
  AccelerometerPrior prior_;
  std::vector<std::size_t> cells_;  ///< of the graph
  std::vector<OwnCell> own_;        ///< per cell of the patch
  std::vector<std::size_t> poses_;  ///< of the snapshot, per force
  double measuring_ = 0;            ///< cells that the forces are of
  std::vector<Joint> joints_;
  std::vector<std::vector<std::size_t>> at_;  ///< per cell of the patch, indices into joints_
  // Deviations that a yaw, of whichever sign, and any other test may reach by chance.
  double yaw_limit_ = 0;
  double other_limit_ = 0;
  std::map<std::size_t, MotionLimits> motion_limits_;  ///< of a cell with so many readings
  Eigen::Vector3d sigma_ = Eigen::Vector3d::Zero();    ///< scatter of twist, bend and yaw beyond the shape
};

}  // namespace hexoderm
