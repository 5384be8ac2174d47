#include "tests/benchmarks/cpu_time.h"
#include "tests/benchmarks/reproduce/detection_bound.h"
#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/sim/fault_names.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/global/global_solver.h"
#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/solve.h"

#include "tests/support/corrupted_readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>

namespace hexoderm::cli {
namespace {

constexpr std::size_t kSeedsOfFullRun = 200;  ///< from so many seeds on, rare events are counted in
constexpr std::size_t kSessionsOfFullRun = 500;
constexpr double kTimesStated = 3;      ///< an error is silent beyond so many times what is stated at 95 %
constexpr double kLinkIsOff_m = 0.005;  ///< ends of a link that a cable tore apart

struct Shape {
  const char* patch;
  const char* surface;
};
constexpr std::array<Shape, 3> kShapes = {
    {{"x17", "cylinder:r=0.0501"}, {"sheet:5x5", "cylinder:r=0.08"}, {"sheet:8x8", "torus:R=0.2,r=0.1"}}};
constexpr std::array<std::size_t, 3> kPoses = {3, 4, 6};

/// Shapes and numbers of poses take turns.
SkinCase skinOf(std::size_t seed) {
  const Shape& shape = kShapes.at(seed % kShapes.size());
  const Accelerometer usual = builtInCellModel("hex-bma150").accelerometer;
  return {.patch = shape.patch,
          .surface = shape.surface,
          .poses = kPoses.at(seed / kShapes.size() % kPoses.size()),
          .offset_sigma_mg = 1000 * usual.largestOffsetSigma_g(),
          .offset_shared_sigma_mg = 1000 * usual.offset_shared_sigma_g,
          .scale_shared_sigma = usual.scale_shared_sigma,
          .mounting_sigma_rad = builtInCellModel("hex-bma150").mounting_sigma_rad};
}
std::string nameOf(const SkinCase& skin) { return skin.patch + ", " + std::to_string(skin.poses) + " poses"; }

using CellPair = std::pair<CellId, CellId>;

/// What is truly wrong with a session.
struct Guilt {
  std::set<CellId> cells = {};
  std::set<CellPair> links = {};  ///< the smaller cell first
  std::set<PoseId> poses = {};
  bool of_all = false;     ///< the skin as a whole is: no cell is right
  bool has_sides = false;  ///< of a large part of the skin: which of the two is right can't be told
  bool too_few = false;    ///< nothing, but directions of gravity are missing
};

struct FaultySession {
  Session session;
  std::shared_ptr<const GroundTruth> truth;
  Guilt guilt;
};

/// What a fault is made of: a healthy skin and its session.
struct Healthy {
  std::size_t seed;
  SkinCase skin;
  Session session;

  [[nodiscard]] CellId anyCell(test::NormalDraw& random) const {
    return session.neighbors()[random.generator()() % session.neighbors().size()].id;
  }
  [[nodiscard]] std::size_t anyPose(test::NormalDraw& random) const { return random.generator()() % skin.poses; }
};

struct FaultKind {
  std::string name;
  std::function<FaultySession(const Healthy&, test::NormalDraw&)> make;
  bool is_small = false;  ///< readings change so little that the estimate stays nearby
};

CellPair pairOf(CellId a, CellId b) { return {std::min(a, b), std::max(a, b)}; }

/// Calls visit(cell, link) for every report of a link.
template <class Visit>
void forEachLink(const NeighborList& neighbors, const Visit& visit) {
  for (const CellReport& cell : neighbors) {
    for (const NeighborReport& link : cell.neighbors) {
      if (link.cell.value() != 0) visit(cell.id, link);
    }
  }
}

/// Of cells that lie otherwise than said: their links to the others are wrong too.
Guilt guiltOf(const NeighborList& neighbors, std::set<CellId> cells) {
  Guilt guilt;
  forEachLink(neighbors, [&](CellId cell, const NeighborReport& link) {
    if (cells.contains(cell) != cells.contains(link.cell)) guilt.links.insert(pairOf(cell, link.cell));
  });
  constexpr std::size_t kSide = 3;  // a third of the skin or more is a side
  guilt.has_sides = kSide * cells.size() >= neighbors.size();
  guilt.cells = std::move(cells);
  return guilt;
}

// --- faults of the simulator

FaultySession measured(const SkinCase& skin_case, std::size_t seed, Guilt guilt) {
  SimulatedSkin skin = makeSkin(skin_case, seed);
  Session session = measure(skin, skin_case);
  auto truth = session.truth();
  return {std::move(session), std::move(truth), std::move(guilt)};
}

FaultySession withCellFault(const Healthy& healthy, SkinFault fault, test::NormalDraw& random) {
  SkinCase skin_case = healthy.skin;
  const CellId cell = healthy.anyCell(random);
  std::set<CellId> cells = {cell};
  if (fault == SkinFault::Swapped || fault == SkinFault::Echo) {
    const auto& links = std::ranges::find(healthy.session.neighbors(), cell, &CellReport::id)->neighbors;
    cells.insert(std::ranges::find_if(links, [](const NeighborReport& link) { return link.cell.value() != 0; })->cell);
  }
  skin_case.faults = {{fault, cell}};
  return measured(skin_case, healthy.seed, guiltOf(healthy.session.neighbors(), cells));
}

/// The links that a cable at this end tears apart; those that a joint bends are the same.
std::set<CellPair> tornLinks(SkinCase skin_case, std::size_t seed, LinkEnd at) {
  skin_case.link_faults = {{LinkFaultKind::Cable, at}};
  const SimulatedSkin skin = makeSkin(skin_case, seed);
  std::set<CellPair> torn;
  forEachLink(skin.neighbors(), [&](CellId cell, const NeighborReport& link) {
    const auto end = [&](CellId of, PortNumber port) {
      return skin.truth()[of.value() - 1].T_b_u * skin.model().port(port).vector_m;
    };
    if ((end(cell, link.port) - end(link.cell, *link.cell_port)).norm() > kLinkIsOff_m) {
      torn.insert(pairOf(cell, link.cell));
    }
  });
  return torn;
}

FaultySession withLinkFault(const Healthy& healthy, LinkFaultKind fault, test::NormalDraw& random) {
  std::vector<std::pair<LinkEnd, CellId>> ends;
  forEachLink(healthy.session.neighbors(), [&](CellId cell, const NeighborReport& link) {
    ends.push_back({{cell, link.port}, link.cell});
  });
  std::ranges::shuffle(ends, random.generator());
  for (const auto& [at, other] : ends) {
    SkinCase skin_case = healthy.skin;
    skin_case.link_faults = {{fault, at}};
    try {
      FaultySession faulty = measured(skin_case, healthy.seed, {});
      Guilt& guilt = faulty.guilt;
      guilt.links =
          fault == LinkFaultKind::WrongPort ? std::set{pairOf(at.cell, other)} : tornLinks(skin_case, healthy.seed, at);
      // A cell that hangs by such links alone might as well be turned.
      for (const CellReport& cell : healthy.session.neighbors()) {
        const auto is_right = [&](const NeighborReport& link) {
          return link.cell.value() != 0 && !guilt.links.contains(pairOf(cell.id, link.cell));
        };
        if (std::ranges::none_of(cell.neighbors, is_right)) guilt.cells.insert(cell.id);
      }
      return faulty;
    } catch (const InvalidArgument&) {  // not every link can have every fault
    }
  }
  throw InvalidArgument("no link of this skin can have the fault " + std::string(kLinkFaultNames.of(fault)));
}

FaultySession withSkinFault(const Healthy& healthy, WholeSkinFault fault) {
  SkinCase skin_case = healthy.skin;
  skin_case.whole_skin_faults = {fault};
  return measured(skin_case, healthy.seed, {.of_all = true});
}

/// Up and down along one line, without a hand.
FaultySession alongOneLine(const Healthy& healthy, test::NormalDraw& random) {
  SimulatedSkin skin = makeSkin(healthy.skin, healthy.seed);
  Session session = beginSimulatedSession(skin);
  const Eigen::Vector3d up_b = random.direction();
  for (std::size_t pose = 0; pose < healthy.skin.poses; ++pose) {
    const BodyMotion still{pose % 2 == 0 ? up_b : Eigen::Vector3d(-up_b), Eigen::Matrix3d::Zero()};
    const CarriedBody body{[still](double /*time_s*/) { return still; }};
    session.addPose({std::make_shared<const PoseCapture>(averageFrames(skin.record(body), session.nextPoseId(), {}))});
  }
  auto truth = session.truth();
  return {std::move(session), std::move(truth), {.too_few = true}};
}

// --- faults of readings

/// Sessions of which readings are changed.
FaultySession changedReadings(const Healthy& healthy, Session session, Guilt guilt) {
  return {std::move(session), healthy.session.truth(), std::move(guilt)};
}

FaultySession ofOneCell(const Healthy& healthy, test::NormalDraw& random,
                        const std::function<Session(const Session&, CellId)>& change) {
  const CellId cell = healthy.anyCell(random);
  return changedReadings(healthy, change(healthy.session, cell), guiltOf(healthy.session.neighbors(), {cell}));
}

/// A share of the skin, or a number of cells, beside each other.
FaultySession ofGroup(const Healthy& healthy, test::NormalDraw& random, double share, std::size_t count,
                      const Eigen::Matrix3d& by) {
  const NeighborList& neighbors = healthy.session.neighbors();
  const auto of_share = static_cast<std::size_t>(share * static_cast<double>(neighbors.size()));
  const std::vector<CellId> group = test::cellsAround(neighbors, healthy.anyCell(random), std::max(of_share, count));
  const std::set<CellId> cells(group.begin(), group.end());
  return changedReadings(healthy, test::multiplied(healthy.session, by, cells), guiltOf(neighbors, cells));
}

FaultySession ofAll(const Healthy& healthy, Session session) {
  return changedReadings(healthy, std::move(session), {.of_all = true});
}

FaultySession ofPoses(const Healthy& healthy, Session session, std::set<std::size_t> poses) {
  Guilt guilt;
  for (const std::size_t pose : poses) guilt.poses.insert(healthy.session.poses()[pose].capture->id);
  return changedReadings(healthy, std::move(session), std::move(guilt));
}

/// 1 and, beside the diagonal, cross-axis sensitivities of 2 to 5 %.
Eigen::Matrix3d crossAxes(test::NormalDraw& random) {
  Eigen::Matrix3d all = Eigen::Matrix3d::Identity();
  std::uniform_real_distribution<double> size(0.02, 0.05);
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      if (row != column) all(row, column) = std::copysign(size(random.generator()), random.normal());
    }
  }
  return all;
}

/// Each cell by a matrix of its own.
Session eachMultiplied(const Session& session, const std::function<Eigen::Matrix3d()>& draw) {
  std::map<CellId, Eigen::Matrix3d> by;
  for (const CellReport& cell : session.neighbors()) by.emplace(cell.id, draw());
  return changed(session, [&](std::size_t /*pose*/, GravitySample& sample) {
    sample.mean_g = by.at(sample.cell) * sample.mean_g;
  });
}

Eigen::Matrix3d turnedAbout(const Eigen::Vector3d& axis, double degrees) { return expSO3(degrees * kDegree * axis); }

std::vector<FaultKind> faultKinds() {
  std::vector<FaultKind> kinds;
  using Random = test::NormalDraw;
  const auto add = [&](std::string name, std::function<FaultySession(const Healthy&, Random&)> make) {
    kinds.push_back({std::move(name), std::move(make)});
  };
  const auto addSmall = [&](std::string name, std::function<FaultySession(const Healthy&, Random&)> make) {
    kinds.push_back({std::move(name), std::move(make), true});
  };
  for (std::size_t k = 0; k < kSkinFaultNames.names.size(); ++k) {
    const auto fault = static_cast<SkinFault>(k);
    add(std::string(kSkinFaultNames.of(fault)),
        [fault](const Healthy& healthy, Random& random) { return withCellFault(healthy, fault, random); });
  }
  for (std::size_t k = 0; k < kLinkFaultNames.names.size(); ++k) {
    const auto fault = static_cast<LinkFaultKind>(k);
    add(std::string(kLinkFaultNames.of(fault)),
        [fault](const Healthy& healthy, Random& random) { return withLinkFault(healthy, fault, random); });
  }
  for (std::size_t k = 0; k < kWholeSkinFaultNames.names.size(); ++k) {
    const auto fault = static_cast<WholeSkinFault>(k);
    add(std::string(kWholeSkinFaultNames.of(fault)) + ", all cells",
        [fault](const Healthy& healthy, Random& /*random*/) { return withSkinFault(healthy, fault); });
  }

  const auto addGroup = [&](const std::string& name, double share, std::size_t count, const Eigen::Matrix3d& by) {
    add(name, [=](const Healthy& healthy, Random& random) { return ofGroup(healthy, random, share, count, by); });
  };
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  addGroup("2 neighbours turned by 180 deg about z", 0, 2, turnedAbout(z, 180));
  addGroup("4 neighbours turned by 180 deg about y", 0, 4, turnedAbout(y, 180));
  addGroup("4 neighbours turned by 90 deg about z", 0, 4, turnedAbout(z, 90));
  addGroup("third turned by 180 deg about z", 1.0 / 3, 0, turnedAbout(z, 180));
  addGroup("half turned by 180 deg about z", 0.5, 0, turnedAbout(z, 180));
  addGroup("half turned by 90 deg about z", 0.5, 0, turnedAbout(z, 90));
  addGroup("half left-handed (y negated)", 0.5, 0, Eigen::Vector3d(1, -1, 1).asDiagonal());
  addGroup("4 neighbours left-handed (y negated)", 0, 4, Eigen::Vector3d(1, -1, 1).asDiagonal());
  add("mirrored (x of all negated)", [](const Healthy& healthy, Random& /*random*/) {
    return ofAll(healthy, test::multiplied(healthy.session, Eigen::Vector3d(-1, 1, 1).asDiagonal()));
  });
  add("IDs shifted by one", [](const Healthy& healthy, Random& /*random*/) {
    return ofAll(healthy, test::mixedWithPrevious(healthy.session, 1));
  });
  addSmall("crosstalk of 5 %", [](const Healthy& healthy, Random& /*random*/) {
    return ofAll(healthy, test::mixedWithPrevious(healthy.session, 0.05));
  });
  add("two cells exchanged", [](const Healthy& healthy, Random& random) {
    const CellId one = healthy.anyCell(random);
    CellId other = one;
    while (other == one) other = healthy.anyCell(random);
    return changedReadings(healthy, test::exchanged(healthy.session, one, other),
                           guiltOf(healthy.session.neighbors(), {one, other}));
  });

  addSmall("chip yaw of 5 deg, one cell", [](const Healthy& healthy, Random& random) {
    return ofOneCell(healthy, random, [](const Session& session, CellId cell) {
      return test::multiplied(session, turnedAbout(Eigen::Vector3d::UnitZ(), 5), {cell});
    });
  });
  addSmall("chip yaw of 5 deg, all cells", [](const Healthy& healthy, Random& /*random*/) {
    return ofAll(healthy, test::multiplied(healthy.session, turnedAbout(Eigen::Vector3d::UnitZ(), 5)));
  });
  addSmall("chips askew by 1 deg (1 sigma)", [](const Healthy& healthy, Random& random) {
    return ofAll(healthy, eachMultiplied(healthy.session, [&] { return expSO3(1 * kDegree * random.vector()); }));
  });
  addSmall("cross-axis of 2 to 5 %, one cell", [](const Healthy& healthy, Random& random) {
    return ofOneCell(healthy, random, [&](const Session& session, CellId cell) {
      return test::multiplied(session, crossAxes(random), {cell});
    });
  });
  addSmall("cross-axis of 2 to 5 %, all cells", [](const Healthy& healthy, Random& random) {
    return ofAll(healthy, eachMultiplied(healthy.session, [&] { return crossAxes(random); }));
  });
  addSmall("rattling cell (5 deg, 1 sigma)", [](const Healthy& healthy, Random& random) {
    return ofOneCell(healthy, random, [&](const Session& session, CellId cell) {
      return test::rattling(session, cell, 5 * kDegree, random);
    });
  });
  add("tared cell", [](const Healthy& healthy, Random& random) { return ofOneCell(healthy, random, test::tared); });

  add("spinning at 3 to 4 rad/s", [](const Healthy& healthy, Random& random) {
    std::set<std::size_t> poses;
    for (std::size_t pose = 0; pose < healthy.skin.poses; ++pose) poses.insert(pose);
    std::uniform_real_distribution<double> rate(3, 4);
    return ofPoses(healthy, test::spinning(healthy.session, rate(random.generator())), poses);
  });
  addSmall("vibration of 100 mg in a pose", [](const Healthy& healthy, Random& random) {
    const std::size_t pose = healthy.anyPose(random);
    const double rate_hz = healthy.session.model().accelerometer.rate_hz;
    return ofPoses(healthy, test::shaken(healthy.session, pose, 0.1, rate_hz, random), {pose});
  });
  addSmall("shock in a pose", [](const Healthy& healthy, Random& random) {
    const std::size_t pose = healthy.anyPose(random);
    return ofPoses(healthy, test::hit(healthy.session, pose, 0.1, 2, random), {pose});
  });
  addSmall("one cell hit in a pose", [](const Healthy& healthy, Random& random) {
    const std::size_t hit_pose = healthy.anyPose(random);
    const Eigen::Vector3d force_g = 0.2 * random.direction();
    FaultySession faulty = ofOneCell(healthy, random, [&](const Session& session, CellId cell) {
      return changed(session, [&](std::size_t pose, GravitySample& sample) {
        if (sample.cell == cell && pose == hit_pose) sample.mean_g += force_g;
      });
    });
    faulty.guilt.poses.insert(healthy.session.poses()[hit_pose].capture->id);
    return faulty;
  });
  add("poses along one line", alongOneLine);
  return kinds;
}

// --- what could be found

const GravitySample& sampleOf(const Session& session, std::size_t pose, CellId cell) {
  return *std::ranges::find(session.poses()[pose].capture->samples, cell, &GravitySample::cell);
}

/// By how many deviations a small fault shows in the readings that is known in all but its place, with all other
/// unknowns of the joint estimate free: the root of what it raises the least sum of squares by in the mean over the
/// noise. That mean is the one of readings that are changed by the fault and by its opposite; a fault that is clear
/// needs the first alone.
double deviationsOf(const Healthy& healthy, const Session& faulty) {
  constexpr double kClear = 50;
  const auto snapshot = healthy.session.snapshot();
  const SolverOptions options;
  const auto solved = solveSkin(*snapshot, options);
  const PatchSolver& patch =
      *std::ranges::max_element(solved->patches(), {}, [](const PatchSolver& each) { return each.cells().size(); });
  GlobalProblem problem = patch.joint()->problem();
  problem.loss.threshold = std::numeric_limits<double>::infinity();
  const auto leastWith = [&](double times) {
    GlobalProblem changed = problem;
    for (std::size_t k = 0; k < patch.cells().size(); ++k) {
      const CellId cell = solved->skin().graph().cells()[patch.cells()[k]].id;
      for (CellReading& reading : changed.readings[k]) {
        const std::size_t pose = patch.joint()->poses()[reading.pose];
        const Eigen::Vector3d change_g =
            sampleOf(faulty, pose, cell).mean_g - sampleOf(healthy.session, pose, cell).mean_g;
        reading.y_g += times * problem.model->accelerometer.T_u_a.R.transpose() * change_g;
      }
    }
    GlobalSolverOptions without;
    without.covariance = false;
    return GlobalSolver().solve(changed, patch.joint()->solution().state, without).cost;
  };
  const double least = leastWith(0);
  const double raised = leastWith(1) - least;
  if (raised > kClear) return std::sqrt(2 * raised);
  return std::sqrt(std::max(0.0, raised + leastWith(-1) - least));
}

/// Where the fault could be as well.
std::size_t placesOf(const Guilt& guilt, const Healthy& healthy) {
  if (guilt.of_all) return 1;
  return guilt.cells.empty() && guilt.links.empty() ? healthy.skin.poses : healthy.session.neighbors().size();
}

// --- what is said of them

/// A finding against the skin as a whole.
bool isAboutAll(const Finding& finding, std::size_t cells) {
  switch (finding.code) {
    case FindingCode::ContradictsModel:
    case FindingCode::InsideOut:
    case FindingCode::SensorsUnlikeModel:
      return true;
    default:
      return 2 * std::set(finding.cells.begin(), finding.cells.end()).size() > cells;
  }
}

enum class Verdict { Right, Neither, Wrong };

Verdict judgeCells(const Finding& finding, const Guilt& guilt) {
  const auto is_guilty = [&](CellId cell) { return guilt.cells.contains(cell); };
  const auto guilty = static_cast<std::size_t>(std::ranges::count_if(finding.cells, is_guilty));
  const bool is_other_side = guilt.has_sides && guilty == 0;
  return guilty == finding.cells.size() || is_other_side ? Verdict::Right : Verdict::Wrong;
}

/// One truly wrong link is enough, if no link is right.
Verdict judgeLinks(const Finding& finding, const Guilt& guilt) {
  for (std::size_t k = 0; k + 1 < finding.cells.size(); k += 2) {
    if (!guilt.links.contains(pairOf(finding.cells[k], finding.cells[k + 1]))) return Verdict::Wrong;
  }
  return finding.cells.size() < 2 ? Verdict::Neither : Verdict::Right;
}

Verdict judge(const Finding& finding, const Guilt& guilt, std::size_t cells) {
  if (finding.code == FindingCode::TooFewDirections) return guilt.too_few ? Verdict::Right : Verdict::Neither;
  if (finding.code == FindingCode::PoorFit || finding.code == FindingCode::NotConverged) return Verdict::Neither;
  if (guilt.of_all) return isAboutAll(finding, cells) ? Verdict::Right : Verdict::Neither;
  if (!finding.ports.empty()) return judgeLinks(finding, guilt);
  if (!finding.cells.empty()) return judgeCells(finding, guilt);
  if (finding.poses.empty()) return isAboutAll(finding, cells) ? Verdict::Wrong : Verdict::Neither;
  const auto is_guilty = [&](PoseId pose) { return guilt.poses.contains(pose); };
  return std::ranges::all_of(finding.poses, is_guilty) ? Verdict::Right : Verdict::Wrong;
}

/// A measured cell is further off, relative to its origin, than three times what is stated of it.
bool isFarOff(const Reconstruction& result, const GroundTruth& truth) {
  for (const PatchReconstruction& patch : result.patches) {
    const SE3 T_o_b = truePlacement(truth, patch.origin).inverse();
    for (const CellPlacement& cell : patch.cells) {
      if (cell.cell == patch.origin || cell.placed_by != PlacedBy::Samples || !cell.cov_t_r) continue;
      const SE3 T_o_u = T_o_b * truePlacement(truth, cell.cell);
      const Uncertainty95 stated = uncertaintyBy(*cell.cov_t_r);
      if ((cell.T_o_u.t - T_o_u.t).norm() > kTimesStated * stated.position_m ||
          rotationAngle(cell.T_o_u.R.transpose() * T_o_u.R) > kTimesStated * stated.orientation_rad) {
        return true;
      }
    }
  }
  return false;
}

/// The session is passed as one to use: exit code 0.
bool isPassed(const Reconstruction& result) {
  return result.assessment.isUsable() || result.assessment.level == VerdictLevel::Coarse;
}

/// The result, and the CPU time that it took.
std::pair<std::shared_ptr<const Reconstruction>, double> timed(const Session& session) {
  const CoresInUse alone(cores());  // no other thread works on it
  const auto snapshot = session.snapshot();
  const double before_ms = cpuTime_ms(CLOCK_THREAD_CPUTIME_ID);
  auto result = reconstruct(*snapshot);
  return {std::move(result), cpuTime_ms(CLOCK_THREAD_CPUTIME_ID) - before_ms};
}

void tryFault(Tally& tally, const FaultySession& faulty, double healthy_ms) {
  const auto [result, took_ms] = timed(faulty.session);
  tally.note("times", took_ms / healthy_ms);
  double alarms = 0;
  bool is_right = false;
  bool is_wrong = false;
  bool is_asked = false;
  for (const Finding& finding : result->findings) {
    is_asked = is_asked || finding.code == FindingCode::InsideOut;
    if (finding.severity == Severity::Info && finding.code != FindingCode::InsideOut) continue;
    ++alarms;
    const Verdict verdict = judge(finding, faulty.guilt, result->cellCount());
    is_right = is_right || verdict == Verdict::Right;
    is_wrong = is_wrong || verdict == Verdict::Wrong;
  }
  tally.note("findings", alarms);
  tally.count("found", alarms > 0 || !isPassed(*result));
  tally.count("right", is_right);
  if (!faulty.guilt.of_all) tally.count("wrong", is_wrong);
  tally.count("passed", isPassed(*result));
  tally.count("silent", isPassed(*result) && !is_asked && isFarOff(*result, *faulty.truth));
}

FigureRow runRow(const Trials& trials, const FaultKind& kind, const std::vector<std::optional<Healthy>>& healthy,
                 const Tally& healthy_times) {
  const Tally tally = trials.run(kind.name, healthy.size(), [&](Tally& found, std::size_t seed) {
    const Healthy& base = *healthy[seed - 1];
    test::NormalDraw random(seed);
    const FaultySession faulty = kind.make(base, random);
    tryFault(found, faulty, *healthy_times.median(nameOf(base.skin)));
    if (!kind.is_small) return;
    found.note("best", bestDetection(deviationsOf(base, faulty.session), placesOf(faulty.guilt, base)));
  });
  return {ofText("fault", "fault", kind.name),
          ofPercent("best test", "best_test_percent", tally.mean("best"), 0),
          ofShare("found (95 %)", "found", tally.share("found"), 0),
          ofShare("named right (95 %)", "named_right", tally.share("right"), 0),
          ofShare("false (95 %)", "false", tally.share("wrong"), 0),
          ofPercent("passed", "", tally.percent("passed"), 0),
          ofShare("", "passed", tally.share("passed"), 1),
          ofShare("silently wrong (95 %)", "silently_wrong", tally.share("silent"), 1),
          ofNumber("findings", "findings_median", tally.median("findings"), 0),
          ofNumber("most", "findings_most", tally.quantile("findings", 1), 0),
          ofNumber("CPU", "times_healthy_cpu_median", tally.median("times"), 1),
          ofNumber("most", "times_healthy_cpu_most", tally.quantile("times", 1), 1)};
}

/// Makes healthy sessions, and counts what is said of them.
Tally tryHealthy(const Trials& trials, std::vector<std::optional<Healthy>>& healthy) {
  return trials.run("healthy", healthy.size(), [&](Tally& found, std::size_t seed) {
    const SkinCase skin_case = skinOf(seed);
    SimulatedSkin skin = makeSkin(skin_case, seed);
    const Healthy& base = healthy[seed - 1].emplace(Healthy{seed, skin_case, measure(skin, skin_case)});
    const auto [result, took_ms] = timed(base.session);
    const std::string name = nameOf(skin_case);
    found.note(name, took_ms);
    found.count(name + " alarms", std::ranges::any_of(result->findings, isAlarm));
    for (const VerdictLevel level : {VerdictLevel::Good, VerdictLevel::Usable, VerdictLevel::Coarse}) {
      found.count(name + std::string(verdictName(level)), result->assessment.level == level);
    }
    found.count(name + " silent", isPassed(*result) && isFarOff(*result, *base.session.truth()));
  });
}

std::vector<FigureRow> healthyRows(const Tally& tally) {
  std::vector<FigureRow> rows;
  const std::size_t kinds = kShapes.size() * kPoses.size();
  for (std::size_t seed = 0; seed < kinds; ++seed) {
    const SkinCase skin = skinOf(seed);
    const std::string name = nameOf(skin);
    if (!tally.share(name + " alarms")) continue;
    FigureRow row = {ofText("healthy skin", "skin", skin.patch + " on " + skin.surface),
                     ofCount("poses", "poses", skin.poses),
                     ofCount("sessions", "sessions", tally.share(name + " alarms")->whole),
                     ofShare("with a false alarm (95 %)", "alarms", tally.share(name + " alarms"), 1),
                     ofShare("silently wrong (95 %)", "silently_wrong", tally.share(name + " silent"), 1)};
    for (const VerdictLevel level : {VerdictLevel::Good, VerdictLevel::Usable, VerdictLevel::Coarse}) {
      const std::string level_name(verdictName(level));
      row.push_back(ofPercent(level_name, level_name + "_percent", tally.percent(name + level_name), 0));
    }
    row.push_back(ofNumber("CPU, ms", "cpu_ms", tally.median(name), 1));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Json countFaults(const Trials& trials, bool prints) {
  const std::size_t sessions =
      trials.seeds() < kSeedsOfFullRun ? trials.seeds() : std::max(trials.seeds(), kSessionsOfFullRun);
  std::vector<std::optional<Healthy>> healthy(sessions);
  const Tally healthy_tally = tryHealthy(trials, healthy);
  const std::vector<FigureRow> healthy_rows = healthyRows(healthy_tally);
  std::vector<FigureRow> rows;
  for (const FaultKind& kind : faultKinds()) rows.push_back(runRow(trials, kind, healthy, healthy_tally));
  if (prints) {
    std::cout
        << "Faults of every kind, on simulated skins of three shapes with 3, 4 and 6 poses in turn, the built-in cell "
           "model, global\nsolver, defaults: "
        << sessions << " sessions per row.\n"
        << "Best test, of small faults: a likelihood ratio with 0.2 % false alarms a session that knows the fault, but "
           "for its place.\n"
        << "Found: a finding above \"info\", or not passed. Named right: a finding names what is wrong, and nothing "
           "that is not; of\nwhat is wrong with the whole skin: a finding about the skin. False: a finding names what "
           "is right. Passed: the verdict\nlets the result be used. Silently wrong: passed, and a measured cell is off "
           "by more than three times what is stated\nat 95 %, relative to its origin. Findings above \"info\": median, "
           "and most of a session. CPU: time over that of a\nhealthy session of the same shape and poses, median and "
           "most; it is that of one run. With 95 % intervals by Wilson.\n\n";
    printTable(healthy_rows);
    std::cout << '\n';
    printTable(rows);
  }
  return {{"sessions", sessions}, {"healthy", toJson(healthy_rows)}, {"rows", toJson(rows)}};
}

}  // namespace hexoderm::cli
