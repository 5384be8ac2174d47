// A session of arrays: links and readings of your own in, placements out.
// The readings here are made up, of three cells in a row whose links bend by 20 degrees, so that the result can be
// compared; with a skin's, fill `links` and `readings_g`, and leave the solver's options as they are.
#include <hexoderm/hexoderm.h>

#include <iomanip>
#include <iostream>
#include <map>
#include <vector>

using namespace hexoderm;

namespace {

/// A link as an array has it: cell and port at both ends.
struct Link {
  std::uint32_t source, source_port, target, target_port;
};
const std::vector<Link> links = {{1, 2, 2, 3}, {2, 2, 3, 3}};

/// Both cells report the link, each with its own port first.
NeighborList neighborsOf(const std::vector<Link>& links) {
  std::map<CellId, CellReport> cells;
  const auto report = [&](std::uint32_t cell, std::uint32_t port, std::uint32_t other, std::uint32_t other_port) {
    cells[CellId(cell)].neighbors.push_back({PortNumber(port), CellId(other), PortNumber(other_port)});
  };
  for (const Link& link : links) {
    report(link.source, link.source_port, link.target, link.target_port);
    report(link.target, link.target_port, link.source, link.source_port);
  }
  NeighborList neighbors;
  for (auto& [id, cell] : cells) neighbors.push_back({id, "", std::move(cell.neighbors)});
  return neighbors;
}

/// Where the made-up cells are, in the frame of cell 1.
std::map<CellId, SE3> placementsOf(const std::vector<Link>& links, const CellModel& model) {
  std::map<CellId, SE3> T_1_u = {{CellId(1), SE3()}};
  for (const Link& link : links) {
    const Port& source = model.port(PortNumber(link.source_port));
    const Port& target = model.port(PortNumber(link.target_port));
    const Eigen::Vector3d bend_rad = 20 * kDegree * Eigen::Vector3d::UnitZ().cross(source.vector_m.normalized());
    const Eigen::Matrix3d R_c_n = expSO3(bend_rad) * nominalAlignment(source, target);
    T_1_u[CellId(link.target)] = T_1_u.at(CellId(link.source)) * linkTransform(R_c_n, source, target);
  }
  return T_1_u;
}

}  // namespace

int main() try {
  const CellModel model = builtInCellModel("hex-bma150");
  const std::map<CellId, SE3> truth = placementsOf(links, model);

  // Per pose and cell the mean of its readings, g, in the accelerometer's axes: (0, 0, 1) for a cell that lies on a
  // table.
  std::vector<std::map<CellId, Eigen::Vector3d>> readings_g;
  for (const Eigen::Vector3d& up : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)}) {
    auto& pose = readings_g.emplace_back();
    for (const auto& [cell, T_1_u] : truth) pose[cell] = T_1_u.R.transpose() * up;
  }

  Session session(model, neighborsOf(links));
  for (const auto& pose : readings_g) {
    PoseCapture capture;
    capture.id = session.nextPoseId();
    for (const auto& [cell, mean_g] : pose) capture.samples.push_back({cell, mean_g});
    session.addPose({std::make_shared<const PoseCapture>(std::move(capture))});
  }

  SolverOptions options;
  options.gap_model = GapModel::Pivot;  // made up by linkTransform(); the default suits a skin
  const auto result = reconstruct(*session.snapshot(), options);
  std::cout << result->assessment.reason << '\n' << result->assessment.next_action << '\n';
  std::cout << std::fixed << std::setprecision(3);
  const SE3 T_o_1 = result->find(CellId(1)).cell->T_o_u;
  for (const CellPlacement& cell : result->patches.front().cells) {
    const SE3 T_1_u = T_o_1.inverse() * cell.T_o_u;
    std::cout << "Cell " << cell.cell << ": " << 1000 * T_1_u.t.transpose() << " mm from cell 1, off by "
              << 1000 * (T_1_u.t - truth.at(cell.cell).t).norm() << " mm\n";
  }
  saveSession(session, "arrays.session.json");
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
