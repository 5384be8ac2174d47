#include "hexoderm/solve/faults/suspects.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/faults/link_plausibility.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

// A link is judged by its angles only where the poses fix them.
constexpr double kJudgeableSigma = 15 * kDegree;

/// Deviations of a link's angles. `covariance`: of its rotation, in the source's frame.
LinkAngles anglesSigma(const Eigen::Matrix3d& covariance, const Port& source) {
  const Eigen::Matrix3d axes = linkAxes(source);
  const auto along = [&](int k) { return std::sqrt(axes.col(k).dot(covariance * axes.col(k))); };
  return {along(0), along(1), along(2)};
}

}  // namespace

SuspectSearch::SuspectSearch(const SkinLinks& skin)
    : skin_(skin),
      verdicts_(skin.edges().size()),
      tested_(skin.graph().cells().size(), 0),
      bad_(skin.graph().cells().size(), 0) {
  for (std::size_t link = 0; link < verdicts_.size(); ++link) {
    verdicts_[link] = judge(link);
    count(link, 1);
  }
}

void SuspectSearch::update(std::span<const std::size_t> links) {
  for (const std::size_t link : links) {
    count(link, -1);
    verdicts_[link] = judge(link);
    count(link, 1);
  }
}

void SuspectSearch::count(std::size_t index, int by) {
  const Verdict& verdict = verdicts_[index];
  if (verdict.tested) tested_links_ += by;
  if (verdict.tested && !verdict.rigid) moving_links_ += by;
  for (const std::size_t cell : {skin_.graph().links()[index].source, skin_.graph().links()[index].target}) {
    if (verdict.tested) tested_[cell] += by;
    if (verdict.bad()) bad_[cell] += by;
    if (isAtOdds(cell)) {
      at_odds_.insert(cell);
    } else {
      at_odds_.erase(cell);
    }
  }
}

bool SuspectSearch::isAtOdds(std::size_t cell) const {
  constexpr double kNearlyAll = 0.74;
  constexpr int kFewestWitnesses = 2;
  return bad_[cell] >= kFewestWitnesses && bad_[cell] >= kNearlyAll * tested_[cell];
}

SuspectSearch::Verdict SuspectSearch::judge(std::size_t index) const {
  Verdict verdict;
  const GraphLink& link = skin_.graph().links()[index];
  if (link.muted() || !skin_.readings().measured(link)) return verdict;
  const EdgeRotation& edge = skin_.edges()[index];
  verdict.tested = true;
  if (edge.deviation_rad < kJudgeableSigma) {
    verdict.implausible =
        judgeLinkAngles(edge.angles, skin_.graph().sourceEnd(link), skin_.graph().targetEnd(link), skin_.model(),
                        skin_.options(), anglesSigma(edge.covariance, skin_.sourcePort(link)));
  }
  ReadingSums sums;
  forReadings(index, [&](const CellReading& source, const Eigen::Vector3d& target_g) { sums.add(source, target_g); });
  verdict.misfit = testRigidity(pairPriorOf(index), sums).deviate();
  verdict.rigid = verdict.misfit <= skin_.options().max_misfit;
  return verdict;
}

AccelerometerPrior SuspectSearch::pairPriorOf(std::size_t index) const {
  const Eigen::Matrix3d& R_u_a = skin_.model().accelerometer.T_u_a.R;
  return pairPrior(skin_.model().accelerometer, R_u_a.transpose() * skin_.edges()[index].R_c_n * R_u_a);
}

template <class Use>
void SuspectSearch::forReadings(std::size_t index, const Use& use) const {
  const GraphLink& link = skin_.graph().links()[index];
  const Eigen::Matrix3d R_a_u = skin_.model().accelerometer.T_u_a.R.transpose();
  const Eigen::Matrix3d R_a_n = R_a_u * skin_.edges()[index].R_c_n;
  for (const std::size_t pose : skin_.table().enabledPoses()) {
    if (!skin_.readings().inBoth(link, pose)) continue;
    const GravityTable::Entry& at_c = skin_.table().at(link.source, pose);
    const GravityTable::Entry& at_n = skin_.table().at(link.target, pose);
    use(CellReading{pose, R_a_u * at_c.mean_g, at_c.variance_g2 + at_n.variance_g2}, R_a_n * at_n.mean_g);
  }
}

std::optional<std::size_t> SuspectSearch::worstPose() const {
  constexpr std::size_t kFewestPoses = 3;
  constexpr int kFewestLinks = 3;
  constexpr double kNearlyNone = 0.2;
  if (skin_.table().enabledPoses().size() < kFewestPoses || tested_links_ < kFewestLinks ||
      2 * moving_links_ <= tested_links_) {
    return std::nullopt;
  }
  std::vector<std::size_t> tested;
  for (std::size_t link = 0; link < verdicts_.size(); ++link) {
    if (verdicts_[link].tested) tested.push_back(link);
  }
  std::vector<std::size_t> moving_without(skin_.table().poseCount(), static_cast<std::size_t>(moving_links_));
  for (const std::size_t link : tested) {
    const AccelerometerPrior prior = pairPriorOf(link);
    ReadingSums all;
    forReadings(link, [&](const CellReading& source, const Eigen::Vector3d& target_g) { all.add(source, target_g); });
    forReadings(link, [&](const CellReading& source, const Eigen::Vector3d& target_g) {
      ReadingSums without = all;
      without.add(source, target_g, -1);
      const bool is_rigid = testRigidity(prior, without).deviate() <= skin_.options().max_misfit;
      std::size_t& still_moving = moving_without[source.pose];
      if (is_rigid && !verdicts_[link].rigid) --still_moving;
      if (!is_rigid && verdicts_[link].rigid) ++still_moving;
    });
  }
  std::optional<std::size_t> worst;
  auto fewest = static_cast<std::size_t>(kNearlyNone * static_cast<double>(tested.size()));
  for (const std::size_t pose : skin_.table().enabledPoses()) {
    const std::size_t still_moving = moving_without[pose];
    if (still_moving > fewest || (worst && still_moving == fewest)) continue;
    worst = pose;
    fewest = still_moving;
  }
  return worst;
}

bool SuspectSearch::isClearlyWrong(std::size_t cell) const {
  return std::ranges::any_of(skin_.graph().linksAt(cell), [&](std::size_t link) {
    return verdicts_[link].tested && verdicts_[link].misfit > kClearly * skin_.options().max_misfit;
  });
}

std::optional<std::size_t> SuspectSearch::worstCell(std::span<const std::size_t> but) const {
  std::optional<std::size_t> worst;
  double worst_misfit = 0;
  for (const std::size_t cell : at_odds_) {
    if (std::ranges::count(but, cell) > 0) continue;
    double misfit = 0;
    // Neighbours at odds with others too speak for a joint that runs between all of them.
    int unreliable = 0;
    for (const std::size_t link : skin_.graph().linksAt(cell)) {
      if (!verdicts_[link].bad()) continue;
      misfit += std::max(verdicts_[link].misfit, skin_.options().max_misfit);
      if (bad_[skin_.graph().links()[link].other(cell)] > 1) ++unreliable;
    }
    if (2 * unreliable >= bad_[cell] || misfit <= worst_misfit) continue;
    worst = cell;
    worst_misfit = misfit;
  }
  return worst;
}

std::vector<SuspectSearch::BadLink> SuspectSearch::badLinks(std::span<const std::size_t> spared) const {
  std::vector<BadLink> bad;
  for (std::size_t index = 0; index < verdicts_.size(); ++index) {
    const Verdict& verdict = verdicts_[index];
    const GraphLink& graph_link = skin_.graph().links()[index];
    const bool is_spared = std::ranges::any_of(
        spared, [&](std::size_t cell) { return cell == graph_link.source || cell == graph_link.target; });
    if (!verdict.bad() || is_spared) continue;
    // Of cells that moved against each other the angles mean nothing.
    if (verdict.rigid) {
      bad.push_back({index, verdict.implausible});
      continue;
    }
    const LinkEnd source = skin_.graph().sourceEnd(graph_link);
    const LinkEnd target = skin_.graph().targetEnd(graph_link);
    bad.push_back(
        {index,
         {makeFinding(
             FindingCode::LinkNotRigid,
             message("The cells of the {} moved against each other between poses (misfit {} standard deviations, limit "
                     "{}): probably a joint or a cable, or one of the two sensors is bad. The link is not used.",
                     linkText(source, target), Number{verdict.misfit, 1}, Number{skin_.options().max_misfit, 1}),
             {source.cell, target.cell}, {source.port, target.port})}});
  }
  return bad;
}

bool hasTooFewPoses(const SkinLinks& skin, std::size_t cell) {
  constexpr std::size_t kFewestToAccuse = 3;
  return skin.table().usablePoseCount(cell) < kFewestToAccuse;
}

Finding describeSuspiciousSensor(const SkinLinks& skin, std::size_t cell) {
  const CellId id = skin.graph().cells()[cell].id;
  return makeFinding(FindingCode::SuspiciousSensor,
                     message("Cell {} does not fit its neighbours well, and {} poses don't tell why. It is used; take "
                             "another pose.",
                             id, skin.table().usablePoses(cell).size()),
                     {id});
}

Finding describeMovedCell(const SkinLinks& skin, std::size_t cell, std::size_t first_pose_after, double angle_rad) {
  const CellId id = skin.graph().cells()[cell].id;
  const PoseId pose = skin.poseId(first_pose_after);
  return makeFinding(FindingCode::MovedCell,
                     message("Cell {} turned by {} degrees or more against the others before pose {}: it came loose or "
                             "was fixed anew. It is placed through its links; take the poses before pose {} again.",
                             id, Number{toDegrees(angle_rad), 0}, pose, pose),
                     {id}, {}, {pose});
}

Finding describeBadSensor(const SkinLinks& skin, std::size_t cell, bool is_leaf) {
  const CellId id = skin.graph().cells()[cell].id;
  std::vector<PoseId> poses;
  double mean = 0;
  double mean_sq = 0;
  for (const std::size_t pose : skin.table().usablePoses(cell)) {
    poses.push_back(skin.poseId(pose));
    const double norm = skin.table().at(cell, pose).mean_g.norm();
    mean += norm;
    mean_sq += norm * norm;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, poses.size()));
  mean /= count;
  const double scatter = std::sqrt(std::max(0.0, mean_sq / count - mean * mean));
  // Offsets make the norm rise and fall with the pose; a gain moves it alike in all of them.
  constexpr double kClearlyOff = 0.1;
  if (std::abs(mean - 1) > kClearlyOff && scatter < std::abs(mean - 1) / 2) {
    return makeFinding(
        FindingCode::WrongGain,
        message("Cell {} reads {} g on average where there is 1 g, and does not fit its neighbours: its gain "
                "is wrong. The cell is placed through its links.",
                id, Number{mean, 2}),
        {id}, {}, poses);
  }
  return makeFinding(FindingCode::InconsistentSensor,
                     is_leaf
                         ? message("Cell {} reads what fits none of the other cells, however it lies: its "
                                   "accelerometer is wrongly wired or broken, or its one link is not rigid. The "
                                   "cell is placed through its links.",
                                   id)
                         : message("Cell {} reads what fits none of the other cells, however it lies: its "
                                   "accelerometer is wrongly wired or broken. The cell is placed through its links.",
                                   id),
                     {id}, {}, poses);
}

}  // namespace hexoderm
