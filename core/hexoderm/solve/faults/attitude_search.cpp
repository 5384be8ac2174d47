#include "hexoderm/solve/faults/attitude_search.h"

#include "hexoderm/base/parallel.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/faults/turn_map.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace hexoderm {
namespace {

/// A free angle is a costlier explanation than none: the logarithm of how much narrower readings fix it.
constexpr double kCostOfAngle = 3;

/// Patches to one false alarm: of the yaw of links and cells, of cells that moved, and of everything else. A mould lets
/// nothing turn in the surface, so that yaw shows a sensor that is mounted otherwise best; bend and twist scatter as
/// the part is curved.
constexpr double kPatchesPerFalseYaw = 200;
constexpr double kPatchesPerFalseMotion = 200;
constexpr double kPatchesPerOtherAlarm = 2000;

/// The deviation that a standard normal deviate exceeds once in `times`.
double deviateExceededOnceIn(double times) {
  return boost::math::quantile(boost::math::complement(boost::math::normal(), 1 / times));
}

/// The value that a chi-squared exceeds once in `times`. Misfit::deviate() asks for more than that so far out: for two
/// degrees of freedom and once in 5,000 for 17.7 where it is 17.0.
double chiSquaredExceededOnceIn(double times, double degrees) {
  return boost::math::quantile(boost::math::complement(boost::math::chi_squared(degrees), 1 / times));
}

/// Turns about each axis alone that explain a misfit best, and their deviations: with few poses the errors of different
/// axes go together, and a turn about one of them is known better than each angle by itself.
struct Turns {
  Eigen::Vector3d angle;
  Eigen::Vector3d sigma;
};
Turns likeliestTurns(const Eigen::Vector3d& off, const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d information = covariance.inverse();
  const Eigen::Vector3d diagonal = information.diagonal();
  return {(information * off).cwiseQuotient(diagonal), diagonal.cwiseSqrt().cwiseInverse()};
}

constexpr std::size_t kAtOnce = 128;  // cells or links that one thread looks at

/// What look(k, suspects) adds to the suspects, in the order of k.
template <class Look>
std::vector<AttitudeSuspect> foundAmong(std::size_t count, const Look& look) {
  std::vector<std::vector<AttitudeSuspect>> of_ranges((count + kAtOnce - 1) / kAtOnce);
  inRanges(count, kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) look(k, of_ranges[begin / kAtOnce]);
  });
  std::vector<AttitudeSuspect> all;
  for (const std::vector<AttitudeSuspect>& found : of_ranges) all.insert(all.end(), found.begin(), found.end());
  return all;
}

/// Both say the same of the same cells or of the same link.
bool isOfTheSame(const AttitudeSuspect& a, const AttitudeSuspect& b) {
  return a.kind == b.kind && a.cell == b.cell && a.other == b.other && a.link == b.link;
}

class AttitudeSearch {
 public:
  AttitudeSearch(const SkinLinks& skin, std::span<const std::size_t> cells, OwnAttitudes own)
      : skin_(skin),
        prior_(own.prior),
        cells_(cells.begin(), cells.end()),
        own_(std::move(own.cells)),
        at_(cells_.size()) {
    for (const PatchForce& force : own.forces) poses_.push_back(force.pose);
    measuring_ = static_cast<double>(std::ranges::count_if(own_, &OwnCell::known));
    findJoints();
    findLimits();
  }

  [[nodiscard]] std::vector<AttitudeSuspect> suspects() {
    const std::vector<SeenLink> links = seenLinks();
    if (links.empty()) return {};
    const PatchShape with_twist = fitPatchShape(skin_.model(), links, true);
    if (const auto patch = judgePatch(with_twist)) return {*patch};
    expect(fitPatchShape(skin_.model(), links, false, &with_twist));
    std::vector<AttitudeSuspect> named;
    for (;;) {
      // What is beside a clearer fault may be its work and waits for the next round.
      std::vector<bool> waits(own_.size(), false);
      const std::size_t before = named.size();
      for (const AttitudeSuspect& suspect : candidates()) {
        const std::vector<std::size_t> places = placesOf(suspect);
        if (std::ranges::any_of(places, [&](std::size_t place) { return waits[place]; })) continue;
        // With absurd sigmas a swap can seem to gain both ways.
        if (std::ranges::any_of(named, [&](const AttitudeSuspect& other) { return isOfTheSame(other, suspect); }))
          continue;
        for (const std::size_t place : places) {
          waits[place] = true;
          for (const std::size_t k : at_[place]) waits[joints_[k].source] = waits[joints_[k].target] = true;
        }
        named.push_back(suspect);
        explain(suspect);
      }
      if (named.size() == before) return named;
    }
  }

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
    [[nodiscard]] Turn turn() const {
      const Eigen::Matrix3d covariance = (information + Eigen::Matrix3d::Identity() / kUnknownVariance).inverse();
      return {covariance, covariance * weighted};
    }
    void operator+=(const Belief& other) {
      information += other.information;
      weighted += other.weighted;
    }
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

  [[nodiscard]] std::size_t placeOf(std::size_t cell) const { return skin_.graph().cells()[cell].place; }

  void findJoints() {
    const SkinGraph& graph = skin_.graph();
    const std::vector<double> heading = flatHeadings(skin_, graph.cells()[cells_.front()].patch.value());
    for (std::size_t place = 0; place < cells_.size(); ++place) {
      for (const std::size_t k : graph.linksAt(cells_[place])) {
        const GraphLink& link = graph.links()[k];
        if (link.muted() || link.source != cells_[place]) continue;
        Joint joint;
        joint.link = k;
        joint.source = place;
        joint.target = placeOf(link.target);
        joint.R_nom = nominalAlignment(skin_.sourcePort(link), skin_.targetPort(link));
        joint.axes = linkAxes(skin_.sourcePort(link));
        joint.heading_rad = heading[place] + headingOf(skin_.sourcePort(link));
        at_[joint.source].push_back(joints_.size());
        at_[joint.target].push_back(joints_.size());
        joints_.push_back(joint);
      }
    }
  }

  [[nodiscard]] bool tested(const Joint& joint) const {
    return joint.open && own_[joint.source].known && own_[joint.target].known;
  }

  /// Twist, bend and yaw.
  [[nodiscard]] Eigen::Vector3d anglesOf(const Joint& joint, const OwnCell& source, const OwnCell& target) const {
    return joint.axes.transpose() * logSO3(source.R_o_u.transpose() * target.R_o_u * joint.R_nom.transpose());
  }

  /// Covariance that the readings leave in a link's angles.
  [[nodiscard]] Eigen::Matrix3d measured(const Joint& joint, const OwnCell& source, const OwnCell& target) const {
    const Eigen::Matrix3d R_c_n = source.R_o_u.transpose() * target.R_o_u;
    return joint.axes.transpose() * (source.covariance + R_c_n * target.covariance * R_c_n.transpose()) * joint.axes;
  }

  void expect(const PatchShape& shape) {
    sigma_ = shape.sigma;
    for (Joint& joint : joints_) {
      joint.expected = shape.anglesAt(joint.heading_rad);
      joint.R_c_n = expSO3(joint.axes * joint.expected) * joint.R_nom;
      compareWithShape(joint);
    }
  }

  /// To be called whenever the own attitude of one of its cells has become another.
  void compareWithShape(Joint& joint) const { joint.off = offBy(joint, own_[joint.source], own_[joint.target]); }

  /// By how much the cells of a link are turned against what the shape says, in the source's frame.
  [[nodiscard]] static Eigen::Vector3d offBy(const Joint& joint, const OwnCell& source, const OwnCell& target) {
    return logSO3(source.R_o_u.transpose() * target.R_o_u * joint.R_c_n.transpose());
  }

  [[nodiscard]] Eigen::Matrix3d scatter() const { return sigma_.cwiseAbs2().asDiagonal(); }

  [[nodiscard]] double squaredMisfit(const Joint& joint, const OwnCell& source, const OwnCell& target) const {
    const Eigen::Vector3d off = anglesOf(joint, source, target) - joint.expected;
    const Eigen::Matrix3d covariance = scatter() + measured(joint, source, target);
    return off.dot(covariance.ldlt().solve(off));
  }

  /// The links as the own attitudes of their cells show them.
  [[nodiscard]] std::vector<SeenLink> seenLinks() const {
    std::vector<SeenLink> links;
    links.reserve(joints_.size());
    for (const Joint& joint : joints_) {
      if (!tested(joint)) continue;
      const OwnCell& source = own_[joint.source];
      const OwnCell& target = own_[joint.target];
      links.push_back({anglesOf(joint, source, target), measured(joint, source, target).diagonal(), joint.heading_rad});
    }
    return links;
  }

  /// A surface's normal turns towards the way that it bends: links twist one way along one direction as much as they
  /// twist the other way across it. A twist that is the same in all directions belongs to no surface.
  [[nodiscard]] std::optional<AttitudeSuspect> judgePatch(const PatchShape& shape) const {
    constexpr double kLimit = 5;
    constexpr double kMin = 4 * kDegree;
    if (shape.antisymmetric_sigma <= 0) return std::nullopt;
    const double deviate = std::abs(shape.parameters.w()) / shape.antisymmetric_sigma;
    if (deviate < strictness() * kLimit || std::abs(shape.parameters.w()) < kMin) return std::nullopt;
    AttitudeSuspect suspect{AttitudeSuspect::Kind::Patch};
    suspect.angle_rad = std::abs(shape.parameters.w());
    return suspect;
  }

  [[nodiscard]] Belief ownBelief(std::size_t place) const {
    Belief own;
    if (own_[place].known) own.information = own_[place].information;
    return own;
  }

  /// What all links of a cell but one say about it.
  [[nodiscard]] Belief beliefBeside(std::size_t place, const Joint* but) const {
    Belief belief;
    for (const std::size_t k : at_[place]) {
      const Joint& joint = joints_[k];
      if (!joint.open || &joint == but) continue;
      belief += joint.source == place ? joint.to_source : joint.to_target;
    }
    return belief;
  }

  /// What the far side of a link says about the cell at the near one.
  [[nodiscard]] Belief along(const Joint& joint, bool to_source) const {
    const std::size_t far = to_source ? joint.target : joint.source;
    Belief of_far = ownBelief(far);
    of_far += beliefBeside(far, &joint);
    const Turn turn = of_far.turn();
    const Eigen::Matrix3d& R_c_n = joint.R_c_n;
    const Eigen::Matrix3d R_far_near = to_source ? Eigen::Matrix3d(R_c_n.transpose()) : R_c_n;
    const Eigen::Matrix3d elastomer = joint.axes * scatter() * joint.axes.transpose();
    const Eigen::Matrix3d of_link = to_source ? elastomer : Eigen::Matrix3d(R_c_n.transpose() * elastomer * R_c_n);
    const Eigen::Vector3d off = to_source ? joint.off : Eigen::Vector3d(-(R_c_n.transpose() * joint.off));
    Belief belief;
    belief.information = (of_link + R_far_near.transpose() * turn.covariance * R_far_near).inverse();
    belief.weighted = belief.information * (off + R_far_near.transpose() * turn.mean);
    return belief;
  }

  void passBeliefs() {
    // Round a loop what a cell says would come back to it as another's word.
    const bool has_loops = joints_.size() >= cells_.size();
    const int reach = has_loops ? 1 : 4;  // links
    for (Joint& joint : joints_) joint.to_source = joint.to_target = Belief{};
    for (int k = 0; k < reach; ++k) {
      std::vector<std::pair<Belief, Belief>> next(joints_.size());
      inRanges(joints_.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t link = begin; link < end; ++link) {
          next[link] = {along(joints_[link], true), along(joints_[link], false)};
        }
      });
      for (std::size_t link = 0; link < joints_.size(); ++link) {
        joints_[link].to_source = next[link].first;
        joints_[link].to_target = next[link].second;
      }
    }
  }

  /// The options' misfit stands for all limits here: 1 for its default.
  [[nodiscard]] double strictness() const { return skin_.options().max_misfit / SolverOptions{}.max_misfit; }

  /// The angle of a link that is furthest beyond its limit.
  [[nodiscard]] std::optional<AttitudeSuspect> judgeLink(const Joint& joint, const Beside& beside) const {
    constexpr std::array kCodes = {FindingCode::ImplausibleTwist, FindingCode::ImplausibleBend,
                                   FindingCode::ImplausibleYaw};
    // Both cells as all but this link have them.
    const auto withoutThis = [&](std::size_t place, const Belief& others) {
      Belief belief = ownBelief(place);
      belief += others;
      const Turn turn = belief.turn();
      OwnCell all;
      all.covariance = turn.covariance;
      all.R_o_u = own_[place].R_o_u * expSO3(turn.mean);
      return all;
    };
    const OwnCell source = withoutThis(joint.source, beside.source);
    const OwnCell target = withoutThis(joint.target, beside.target);
    const Eigen::Vector3d& expected = joint.expected;
    const Turns turns =
        likeliestTurns(anglesOf(joint, source, target) - expected, scatter() + measured(joint, source, target));
    const Eigen::Vector3d limits = turns.sigma.cwiseProduct(Eigen::Vector3d(other_limit_, other_limit_, yaw_limit_));
    Eigen::Index worst = 0;
    if (turns.angle.cwiseQuotient(limits).cwiseAbs().maxCoeff(&worst) <= 1) return std::nullopt;
    AttitudeSuspect suspect{AttitudeSuspect::Kind::Link};
    suspect.link = joint.link;
    suspect.angle = kCodes.at(static_cast<std::size_t>(worst));
    suspect.angle_rad = expected[worst] + turns.angle[worst];
    suspect.lowest_rad = expected[worst] - limits[worst];
    suspect.highest_rad = expected[worst] + limits[worst];
    suspect.evidence = squaredMisfit(joint, source, target) / 2 - kCostOfAngle * 3;
    return suspect;
  }

  /// What the covariance of a cell by its links lacks: half of each link's scatter is how askew this very cell sits in
  /// the mould, which is the same for all of them and does not average out.
  [[nodiscard]] Eigen::Matrix3d ownScatter(std::size_t place) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    double links = 0;
    for (const std::size_t k : at_[place]) {
      const Joint& joint = joints_[k];
      if (!tested(joint)) continue;
      Eigen::Matrix3d axes = joint.axes;
      if (joint.target == place) axes = (joint.R_nom.transpose() * axes).eval();
      sum += axes * scatter() * axes.transpose();
      ++links;
    }
    return links == 0 ? sum : Eigen::Matrix3d((1 - 1 / links) / 2 * sum / links);
  }

  /// What all links of a cell say about its attitude.
  [[nodiscard]] Turn turnByLinks(std::size_t place) const {
    Turn turn = beliefBeside(place, nullptr).turn();
    turn.covariance += ownScatter(place);
    return turn;
  }

  /// A cell whose own attitude is not what all its links say together. Nothing for one with fewer than two links to say
  /// so.
  [[nodiscard]] std::optional<AttitudeSuspect> judgeCell(std::size_t place, const Turn& by_links) const {
    const auto witnesses = std::ranges::count_if(at_[place], [&](std::size_t k) { return tested(joints_[k]); });
    if (witnesses < 2) return std::nullopt;
    const Eigen::Vector3d& turn = by_links.mean;
    const Eigen::Matrix3d covariance = by_links.covariance + own_[place].covariance;
    const double squared = turn.dot(covariance.ldlt().solve(turn));
    const bool is_turned = Misfit{squared, 3}.deviate() > other_limit_;
    const Turns turns = likeliestTurns(turn, covariance);
    const bool is_yawed = std::abs(turns.angle.z()) > yaw_limit_ * turns.sigma.z();
    if (!is_turned && !is_yawed) return std::nullopt;
    AttitudeSuspect suspect{AttitudeSuspect::Kind::Cell};
    suspect.cell = cells_[place];
    suspect.angle_rad = turn.norm();
    suspect.evidence = squared / 2 - kCostOfAngle * 3;
    return suspect;
  }

  /// A cell whose readings before and after a pose belong to two attitudes.
  [[nodiscard]] std::optional<AttitudeSuspect> judgeMotion(std::size_t place, const Turn& by_links) const {
    constexpr double kMinTurn = 2 * kDegree;  // what a cell does in a soft mould
    const OwnCell& own = own_[place];
    if (own.readings.size() < 2) return std::nullopt;
    const Eigen::Matrix3d& R_u_a = skin_.model().accelerometer.T_u_a.R;
    const Eigen::Matrix3d R_a_o = (own.R_o_u * R_u_a).transpose();
    std::vector<Eigen::Vector3d> v_g;
    v_g.reserve(own.f_o.size());
    for (const Eigen::Vector3d& f_o : own.f_o) v_g.emplace_back(R_a_o * f_o);
    const Eigen::Matrix3d information = by_links.covariance.inverse();
    const Eigen::Vector3d weighted = information * by_links.mean;
    const MotionLimits& limits = motion_limits_.at(own.readings.size());
    // The forces are what all cells agree on, and the cell's own share in them hides as much of its turn.
    const double hidden = measuring_ / std::max(1.0, measuring_ - 1);
    const double least_gain = limits.of_two_angles / hidden;
    const AttitudePrior attitude{R_u_a.transpose() * information * R_u_a, R_u_a.transpose() * weighted};
    TurnBetweenPoses turn = findTurn(prior_, own.readings, v_g, attitude, least_gain);
    turn.gain.chi_squared *= hidden;
    const double limit = turn.gain.degrees <= 2 ? limits.of_two_angles : limits.of_three_angles;
    if (!(turn.angle_rad >= kMinTurn && turn.gain.chi_squared > limit)) return std::nullopt;
    AttitudeSuspect suspect{AttitudeSuspect::Kind::Moved};
    suspect.cell = cells_[place];
    suspect.angle_rad = turn.angle_rad;
    suspect.pose = poses_[own.readings[turn.first_after].pose];
    suspect.evidence = turn.gain.chi_squared / 2 - kCostOfAngle * turn.gain.degrees;
    return suspect;
  }

  /// Squared misfit of the own attitudes of two neighbours, together, with what all their links say. `source`,
  /// `target`: whose readings count at the ends of the link.
  [[nodiscard]] double pairMisfit(const Joint& joint, const Beside& beside, const OwnCell& source,
                                  const OwnCell& target) const {
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    // The errors (e_source, e_target) of both attitudes as the links have them.
    Matrix6 information = Matrix6::Identity() / kUnknownVariance;
    Vector6 weighted = Vector6::Zero();
    const auto addBeside = [&](std::size_t place, const Belief& others, const OwnCell& own, Eigen::Index at) {
      const Eigen::Matrix3d R_believed = own_[place].R_o_u * expSO3(others.turn().mean);
      information.block<3, 3>(at, at) += others.information;
      weighted.segment<3>(at) += others.information * logSO3(own.R_o_u.transpose() * R_believed);
    };
    addBeside(joint.source, beside.source, source, 0);
    addBeside(joint.target, beside.target, target, 3);
    const Eigen::Vector3d off = offBy(joint, source, target);
    Eigen::Matrix<double, 3, 6> J;  // of the link's angle, off - e_source + R_c_n e_target
    J << -Eigen::Matrix3d::Identity(), joint.R_c_n;
    const Eigen::Matrix3d precision = joint.axes * scatter().inverse() * joint.axes.transpose();
    information += J.transpose() * precision * J;
    weighted -= J.transpose() * precision * off;

    Matrix6 covariance = information.inverse();
    const Vector6 mean = covariance * weighted;
    covariance.topLeftCorner<3, 3>() += source.covariance;
    covariance.bottomRightCorner<3, 3>() += target.covariance;
    return mean.dot(covariance.ldlt().solve(mean));
  }

  /// No less than pairMisfit() of the cells' own readings: what it would be if the links' errors were none.
  [[nodiscard]] double mostPairMisfit(const Joint& joint, const Beside& beside) const {
    const auto misfitOf = [](const Belief& others) {
      const Eigen::Vector3d turn = others.turn().mean;
      return turn.dot(others.information * turn);
    };
    const Eigen::Vector3d deviations = (joint.axes.transpose() * joint.off).cwiseQuotient(sigma_);
    return deviations.squaredNorm() + misfitOf(beside.source) + misfitOf(beside.target);
  }

  /// By how much two neighbours fit their links better with each other's readings: the logarithm of the likelihood
  /// ratio. Nothing if that can't be more than `limit`.
  [[nodiscard]] std::optional<double> gainOfSwap(const Joint& joint, const Beside& beside, double limit) const {
    // With each other's readings the misfit is 0 at least.
    if (mostPairMisfit(joint, beside) <= 2 * limit) return std::nullopt;
    const OwnCell& source = own_[joint.source];
    const OwnCell& target = own_[joint.target];
    const double as_it_is = pairMisfit(joint, beside, source, target);
    if (as_it_is <= 2 * limit) return std::nullopt;
    const double gain = (as_it_is - pairMisfit(joint, beside, target, source)) / 2;
    return gain > limit ? std::optional(gain) : std::nullopt;
  }

  void findLimits() {
    const auto joints = static_cast<double>(joints_.size());
    const auto cells = static_cast<double>(cells_.size());
    yaw_limit_ = strictness() * deviateExceededOnceIn(2 * kPatchesPerFalseYaw * (joints + cells));
    other_limit_ = strictness() * deviateExceededOnceIn(2 * kPatchesPerOtherAlarm * (2 * joints + cells));
    for (const OwnCell& own : own_) {
      const std::size_t readings = own.readings.size();
      if (readings < 2 || motion_limits_.contains(readings)) continue;
      const double times = kPatchesPerFalseMotion * cells * static_cast<double>(readings - 1);
      motion_limits_[readings] = {strictness() * strictness() * chiSquaredExceededOnceIn(times, 2),
                                  strictness() * strictness() * chiSquaredExceededOnceIn(times, 3)};
    }
  }

  std::vector<AttitudeSuspect> candidates() {
    passBeliefs();
    const double swap_limit =
        strictness() * strictness() * std::log(kPatchesPerOtherAlarm * static_cast<double>(joints_.size()));
    std::vector<AttitudeSuspect> found = foundAmong(joints_.size(), [&](std::size_t k, auto& suspects) {
      const Joint& joint = joints_[k];
      if (!tested(joint)) return;
      const Beside beside{beliefBeside(joint.source, &joint), beliefBeside(joint.target, &joint)};
      if (const auto suspect = judgeLink(joint, beside)) suspects.push_back(*suspect);
      if (const std::optional<double> gain = gainOfSwap(joint, beside, swap_limit)) {
        AttitudeSuspect suspect{AttitudeSuspect::Kind::Swapped};
        suspect.cell = cells_[joint.source];
        suspect.other = cells_[joint.target];
        suspect.evidence = *gain;
        suspects.push_back(suspect);
      }
    });
    std::ranges::copy(foundAmong(cells_.size(),
                                 [&](std::size_t place, auto& suspects) {
                                   if (!own_[place].known) return;
                                   const Turn turn = turnByLinks(place);
                                   if (const auto suspect = judgeCell(place, turn)) suspects.push_back(*suspect);
                                   if (const auto suspect = judgeMotion(place, turn)) suspects.push_back(*suspect);
                                 }),
                      std::back_inserter(found));
    std::ranges::sort(found, std::greater<>(), &AttitudeSuspect::evidence);
    return found;
  }

  [[nodiscard]] std::vector<std::size_t> placesOf(const AttitudeSuspect& suspect) const {
    if (suspect.kind == AttitudeSuspect::Kind::Cell || suspect.kind == AttitudeSuspect::Kind::Moved)
      return {placeOf(suspect.cell)};
    if (suspect.kind == AttitudeSuspect::Kind::Swapped) return {placeOf(suspect.cell), placeOf(suspect.other)};
    const GraphLink& link = skin_.graph().links()[suspect.link];
    return {placeOf(link.source), placeOf(link.target)};
  }

  void explain(const AttitudeSuspect& suspect) {
    switch (suspect.kind) {
      case AttitudeSuspect::Kind::Link:
        for (Joint& joint : joints_) joint.open = joint.open && joint.link != suspect.link;
        break;
      case AttitudeSuspect::Kind::Swapped:
        std::swap(own_[placeOf(suspect.cell)], own_[placeOf(suspect.other)]);
        for (const std::size_t cell : {suspect.cell, suspect.other}) {
          for (const std::size_t k : at_[placeOf(cell)]) compareWithShape(joints_[k]);
        }
        break;
      case AttitudeSuspect::Kind::Cell:
      case AttitudeSuspect::Kind::Moved:
        own_[placeOf(suspect.cell)].known = false;
        break;
      case AttitudeSuspect::Kind::Patch:
        break;
    }
  }

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

}  // namespace

std::vector<AttitudeSuspect> findAttitudeSuspects(const SkinLinks& skin, std::span<const std::size_t> cells,
                                                  OwnAttitudes own) {
  return AttitudeSearch(skin, cells, std::move(own)).suspects();
}

}  // namespace hexoderm
