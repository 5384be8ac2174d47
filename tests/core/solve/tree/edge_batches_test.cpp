// Edges several at a time against those one by one, with vector instructions and without.

#include "hexoderm/solve/tree/edge_batches.h"

#include "tests/support/options.h"
#include "tests/support/simulated_skins.h"

#include <gmock/gmock.h>

#include <numeric>

namespace hexoderm {
namespace {

struct Kernels {
  const char* name;
  EdgeKernel kernel;
};

std::vector<Kernels> kernels() {
  std::vector<Kernels> all = {{"two", estimateEdgesByTwo}};
  if (hasVectorInstructions()) all.push_back({"four", estimateEdgesByFour});
  return all;
}

void expectSame(const EdgeRotation& a, const EdgeRotation& b, double tolerance) {
  EXPECT_LT((a.R_c_n - b.R_c_n).norm(), tolerance);
  EXPECT_LT((a.singular_values - b.singular_values).norm(), tolerance);
  EXPECT_LT((a.covariance - b.covariance).norm(), tolerance * b.covariance.norm());
  EXPECT_LT((a.prior_part - b.prior_part).norm(), tolerance * b.prior_part.norm());
  EXPECT_EQ(a.quality, b.quality);
  EXPECT_EQ(a.centred, b.centred);
  EXPECT_EQ(a.supported, b.supported);
  EXPECT_NEAR(a.residual_rad, b.residual_rad, tolerance);
  EXPECT_NEAR(a.expected_residual_rad, b.expected_residual_rad, tolerance);
  EXPECT_NEAR(a.deviation_rad, b.deviation_rad, 1e-7 * b.deviation_rad);  // its closed form is no better
  EXPECT_NEAR(a.angles.twist_rad, b.angles.twist_rad, tolerance);
  EXPECT_NEAR(a.angles.bend_rad, b.angles.bend_rad, tolerance);
  EXPECT_NEAR(a.angles.yaw_rad, b.angles.yaw_rad, tolerance);
}

/// A skin on a cylinder with all errors of its sensors, of their lot and of the hand. One of its cells' ports has a
/// height.
class Sheet {
 public:
  explicit Sheet(std::size_t poses, SolverOptions options = {}) : options_(std::move(options)) {
    CellModel model = builtInCellModel("hex-bma150");
    model.ports.front().vector_m.z() = -0.004;
    SimulatedSkin skin(std::move(model), test::skinOptions("sheet:9x10", "cylinder:r=0.1", 5));
    snapshot_ = simulateSession(skin, poses, 20).snapshot();
    links_ = std::make_unique<SkinLinks>(*snapshot_, options_, findings_);
  }

  [[nodiscard]] SkinLinks& links() { return *links_; }
  [[nodiscard]] std::vector<std::size_t> all() const {
    std::vector<std::size_t> all(links_->graph().links().size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }

  struct Result {
    std::vector<EdgeRotation> edges;
    std::vector<std::optional<double>> residuals;
    std::vector<std::size_t> unusual;  ///< in ascending order
    [[nodiscard]] bool isUnusual(std::size_t link) const { return std::ranges::binary_search(unusual, link); }
  };
  [[nodiscard]] Result estimate(EdgeKernel kernel, std::span<const std::size_t> of) {
    links_->estimateEdges();  // with the readings as they are now
    Result result;
    result.edges.resize(links_->graph().links().size());
    result.residuals.resize(result.edges.size() * links_->table().poseCount());
    result.unusual = estimateUsualEdges(*links_, of, result.edges, result.residuals, kernel);
    return result;
  }
  /// Of all links, which are as one by one where they are not left to the careful way.
  Result estimateAndCompare(EdgeKernel kernel, double tolerance) {
    Result result = estimate(kernel, all());
    const GravityTable& table = links_->table();
    for (const std::size_t link : all()) {
      if (result.isUnusual(link)) continue;
      const EdgeRotation expected = carefully(link);
      expectSame(result.edges[link], expected, tolerance);
      const GraphLink& ends = links_->graph().links()[link];
      std::vector<double> found;
      for (std::size_t pose = 0; pose < table.poseCount(); ++pose) {
        const std::optional<double>& residual = result.residuals[link * table.poseCount() + pose];
        EXPECT_EQ(residual.has_value(), table.at(ends.source, pose).usable && table.at(ends.target, pose).usable);
        if (residual) found.push_back(*residual);
      }
      EXPECT_THAT(found, testing::Pointwise(testing::DoubleNear(tolerance), expected.pose_residual_rad));
    }
    return result;
  }
  [[nodiscard]] EdgeRotation carefully(std::size_t index) const {
    const GraphLink& link = links_->graph().links()[index];
    return estimateEdgeRotation(links_->model(), links_->sourcePort(link), links_->targetPort(link),
                                links_->readings().readingsOf(link), options_);
  }

 private:
  SolverOptions options_;
  std::shared_ptr<const SessionSnapshot> snapshot_;
  std::vector<Finding> findings_;
  std::unique_ptr<SkinLinks> links_;
};

TEST(EdgeBatches, AgreeWithEdgesOneByOne) {
  for (const Centring centring : {Centring::Auto, Centring::On, Centring::Off}) {
    for (const std::size_t poses : {2U, 3U, 4U, 7U}) {
      Sheet sheet(poses, test::with(&SolverOptions::centring, centring));
      for (const auto& [name, kernel] : kernels()) {
        SCOPED_TRACE(testing::Message() << name << ", " << poses << " poses");
        EXPECT_LT(sheet.estimateAndCompare(kernel, 1e-12).unusual.size(), sheet.all().size() / 10);
      }
    }
  }
}

TEST(EdgeBatches, MissingReadingsMakeBatchesOfTheirOwn) {
  Sheet sheet(4);
  for (std::size_t cell = 0; cell < sheet.links().table().cellCount(); cell += 7) {
    sheet.links().table().at(cell, cell % 4).usable = false;
  }
  for (const auto& [name, kernel] : kernels()) {
    SCOPED_TRACE(name);
    sheet.estimateAndCompare(kernel, 1e-12);
  }
}

/// One direction, opposite ones, mirrored readings, no reading at all, a reading that is nearly none: all are left to
/// the careful way, and their neighbours in the batch are not.
TEST(EdgeBatches, DegenerateLinksAreLeftToTheCarefulWay) {
  Sheet sheet(3);
  SkinLinks& links = sheet.links();
  const auto set = [&](std::size_t link, std::size_t pose, const Eigen::Vector3d& c, const Eigen::Vector3d& n) {
    links.table().at(links.graph().links()[link].source, pose).mean_g = c;
    links.table().at(links.graph().links()[link].target, pose).mean_g = n;
  };
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const std::size_t same = 0;
  const std::size_t opposite = 60;
  const std::size_t mirrored = 110;
  const std::size_t tiny = 150;
  for (std::size_t pose = 0; pose < 3; ++pose) {
    set(same, pose, z, z);
    set(opposite, pose, pose == 1 ? -z : z, pose == 1 ? -z : z);
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(pose));
    set(mirrored, pose, axis, -axis);
    set(tiny, pose, 1e-9 * axis, axis);
  }
  for (const auto& [name, kernel] : kernels()) {
    const Sheet::Result result = sheet.estimateAndCompare(kernel, 1e-11);
    for (const std::size_t link : {same, opposite, mirrored, tiny}) {
      EXPECT_TRUE(result.isUnusual(link)) << name << ", link " << link;
    }
    EXPECT_LT(result.unusual.size(), sheet.all().size() / 2);
  }
  links.estimateEdges();
  for (const EdgeRotation& edge : links.edges()) {
    EXPECT_TRUE(edge.R_c_n.allFinite() && edge.covariance.allFinite());
  }
}

TEST(EdgeBatches, SupportAxesAreLeftToTheCarefulWay) {
  Sheet sheet(3, test::with(&SolverOptions::support_axes, SupportAxes::On));
  EXPECT_EQ(sheet.estimate(fastestEdgeKernel(), sheet.all()).unusual, sheet.all());
}

}  // namespace
}  // namespace hexoderm
