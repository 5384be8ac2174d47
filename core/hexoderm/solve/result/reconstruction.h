#pragma once

#include "hexoderm/base/finding.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/session/session.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/solve/result/assessment.h"
#include "hexoderm/solve/result/covariances.h"
#include "hexoderm/solve/result/solver_options.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// How well an edge's rotation is determined by the poses, eq. (17).
enum class EdgeQuality { Undefined, Partially, Fully, Over };
std::string_view qualityName(EdgeQuality quality);                  ///< "un", "partially", "fully", "over", as in files
std::optional<EdgeQuality> qualityFromName(std::string_view name);  ///< nothing for a name that is none

/// All that is known of one link. One entry stands for both directed edges: the reverse rotation is the transpose.
struct LinkEstimate {
  LinkEnd source;  ///< the smaller (ID, port)
  LinkEnd target;
  Eigen::Matrix3d R_c_n = Eigen::Matrix3d::Identity();  ///< target to source frame
  EdgeQuality quality = EdgeQuality::Undefined;
  Eigen::Vector3d singular_values = Eigen::Vector3d::Zero();  ///< of the unit vectors, uncentred, without support axes
  double weight = 3;
  /// Rms over poses of the angle between c_p and R_c_n n_p; with the global solver of readings freed from the estimated
  /// errors of their sensors.
  double residual_rad = 0;
  double sigma_rad = 0;  ///< predicted standard deviation about the worst axis
  double bend_rad = 0;
  double twist_rad = 0;
  double yaw_rad = 0;
  bool centred = false;    ///< each cell's mean vector was subtracted
  bool supported = false;  ///< support axes were appended
  bool used = false;       ///< in the solution; false for muted links
  bool in_tree = false;    ///< on the shortest-path tree
  std::optional<FindingCode> muted_by;
  /// Angle between c_p and R_c_n n_p per entry of Reconstruction::poses; absent where a cell has no sample.
  std::vector<std::optional<double>> pose_residual_rad;

  /// `residual_rad` and `sigma_rad`, absent where none was computed (links that no pose measured; files that don't
  /// state them).
  [[nodiscard]] std::optional<double> knownResidual() const;
  [[nodiscard]] std::optional<double> knownSigma() const;  ///< 1 sigma of the link's rotation where it is known, rad
  /// It was measured or solved, so that its angles mean something.
  [[nodiscard]] bool hasMetrics() const;
};

/// How a cell's placement was found: by its own readings, or by its links alone.
enum class PlacedBy { Samples, Links };

/// Where a sensor is.
struct SensorPlacement {
  std::string name;
  std::string type;
  SE3 T_o_s;  ///< in the patch frame
};

/// Placement of a cell, in its patch's frame (the origin cell's frame).
struct CellPlacement {
  CellId cell;
  std::string body_part;
  PlacedBy placed_by = PlacedBy::Samples;
  SE3 T_o_u;
  /// Covariance relative to the origin: order position (m, patch frame) then rotation (rad, right-multiplied error in
  /// the cell frame: R_true = R exp(e)). Zero for the origin. Absent where a solver or an imported file does not state
  /// it.
  std::optional<Matrix6d> cov_t_r;
  /// The same relative to the patch as a whole: what is left when the patch is moved as one so that the variances of
  /// all cells' centres are least in sum (inner constraints; W. Baarda, "S-transformations and criterion matrices",
  /// Netherlands Geodetic Commission, 1973). Does not depend on which cell is the origin, whose own covariance is not
  /// zero here. Stated by the global solver, and by files that it was written to.
  std::optional<Matrix6d> shape_cov_t_r;
  /// The accelerometer reads scale * force + offset along its axes, apart from cross-axis sensitivity. Estimated by the
  /// global solver for measured cells.
  std::optional<Eigen::Vector3d> accel_offset_g;
  std::optional<Eigen::Vector3d> accel_scale;
  /// The cell before it on the shortest path from the origin. Absent for the origin itself, and if imported.
  std::optional<CellId> predecessor;
  std::vector<SensorPlacement> sensors;
};

/// The up direction that the accelerometers read in one pose, in the patch frame.
struct GravityDirection {
  PoseId pose;
  Eigen::Vector3d g_o = Eigen::Vector3d::UnitZ();  ///< unit, points up (specific force)
  /// Tree: scatter of the cells about it, divided by sqrt(cells). Global: predicted, worst axis.
  double sigma_rad = 0;
  /// The specific force at a point t of the patch, at_origin_o_g + swing_o x t: a hand that turns the part while it is
  /// sampled adds to gravity, the more the further out. Held by a fresh result of the global solver, not by files.
  struct Force {
    Eigen::Vector3d at_origin_o_g = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d swing_o = Eigen::Vector3d::Zero();  ///< angular acceleration, g/m
  };
  std::optional<Force> force{};
};

/// Position of a patch's gaps between pivot (0) and arc (1), and its uncertainty (gap share, in
/// core/hexoderm/solve/README.md).
struct GapShareEstimate {
  double share = 0;
  double sigma = 0;  ///< 0 where it was given
};

/// The errors that all accelerometers of a patch have in common, accelerometer axes: a chip with the offset b and the
/// gain I + D of its own reads scale (I + D) f + b + offset of a specific force f.
struct LotEstimate {
  Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();
  Eigen::Vector3d offset_sigma_g = Eigen::Vector3d::Zero();  ///< 1 sigma
  double scale = 1;
  double scale_sigma = 0;  ///< 1 sigma, relative
};

/// Cells that are joined by links, in a frame of their own.
struct PatchReconstruction {
  PatchId id;
  /// The cell nearest to all others (findOrigin()), of those that were measured in as many poses as most; may change
  /// with poses. Relative to a cell `a` of your own, cell `b` is at T_o_a.inverse() * T_o_b, each its T_o_u, with
  /// covariance->relative(a, b).
  CellId origin;
  std::vector<GravityDirection> gravity;
  std::vector<CellPlacement> cells;           ///< in ascending order of ID
  std::vector<LinkEstimate> links;            ///< muted links too; a link between two patches is listed with its source
  std::optional<GapShareEstimate> gap_share;  ///< set by the global solver
  std::optional<LotEstimate> lot;             ///< the same, where the cell model says that chips share errors
  // Null but for a fresh result of the global solver.
  std::shared_ptr<const PlacementCovariance> covariance;
  std::shared_ptr<const GravityCovariance> gravity_covariance;

  [[nodiscard]] const CellPlacement* findCell(CellId cell_id) const;  ///< null: the cell is not in this patch
  /// The cells of the shortest path from the origin to this cell, both included; empty where it is not known.
  [[nodiscard]] std::vector<CellId> pathTo(CellId cell_id) const;
};

/// A row of the table of poses.
struct PoseSummary {
  PoseId pose;
  Message label;
  bool enabled = true;
  std::size_t cells_measured = 0;
  double noise_g = 0;                  ///< rms over cells of the mean's standard deviation, worst axis
  std::optional<double> new_by_rad;    ///< angle to the nearest earlier enabled pose's direction (either sign)
  std::optional<double> residual_rad;  ///< rms over links
};

/// A cell in the flat honeycomb drawing of the graph.
struct FlatCell {
  CellId cell;
  Vector2d center = Vector2d::Zero();  ///< metres on the sheet
  double angle_rad = 0;                ///< rotation of the cell frame in the sheet
};
/// A link in the drawing, from port to port; `cut` where a closed surface was cut open there.
struct FlatLink {
  PatchId patch;
  std::size_t link = 0;  ///< index into that patch's links
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();
  bool cut = false;
};
/// The skin laid flat, for drawing it as a graph.
struct FlatLayout {
  std::vector<FlatCell> cells;
  std::vector<FlatLink> links;
};

class ResultGraph;

/// Cells and links of a result as a graph, made when it is first asked for; from then on the lists of cells and links
/// must stay as they are. A copy of the result makes a graph of its own, and can be edited until it is asked for it.
class CachedGraph {
 public:
  CachedGraph() = default;                                     ///< holds no graph
  CachedGraph(const CachedGraph& /*other*/) noexcept {}        ///< holds no graph
  CachedGraph& operator=(const CachedGraph& other) noexcept {  ///< holds none any more
    if (this != &other) graph_.reset();
    return *this;
  }
  ~CachedGraph() = default;

  /// The graph of the patches, which must be those of the result that holds this; on any thread.
  [[nodiscard]] const ResultGraph& of(const std::vector<PatchReconstruction>& patches) const;

 private:
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const ResultGraph> graph_;
};

/// The result: everything views and exporters show. Immutable once made; also what a calibration file holds.
struct Reconstruction {
  std::uint64_t revision = 0;   ///< revision of the snapshot it was computed from
  std::string solver = "tree";  ///< "global", "tree" or "imported"
  SolverOptions options;
  SourceDescription source;
  std::shared_ptr<const CellModel> model;  ///< never null
  std::vector<PoseSummary> poses;          ///< all of the session, disabled ones included
  std::vector<PatchReconstruction> patches;
  std::vector<Finding> findings;
  Assessment assessment;
  FlatLayout layout;
  double solve_seconds = 0;
  std::optional<RobotDescription> robot;   ///< that wears the skin, where it was said
  std::vector<PatchPlacement> placements;  ///< on the robot, at most one for each patch, by its origin cell

  [[nodiscard]] std::size_t cellCount() const;  ///< the cells of all patches
  [[nodiscard]] std::size_t linkCount() const;  ///< the links of all patches
  /// Patch and placement of a cell; null if there is none.
  struct Located {
    const PatchReconstruction* patch = nullptr;
    const CellPlacement* cell = nullptr;
  };
  [[nodiscard]] Located find(CellId id) const;  ///< the cell, and the patch that it is in; null if there is none
  [[nodiscard]] const LinkEstimate* findLink(LinkEnd a, LinkEnd b) const;  ///< in either order

  CachedGraph cached_graph;  ///< of the patches, for the library's own functions
  [[nodiscard]] const ResultGraph& graph() const { return cached_graph.of(patches); }  ///< the same
};

/// The patch with the most cells, of equally large ones the first; null for an empty skin.
const PatchReconstruction* largestPatch(const Reconstruction& reconstruction);

/// "17 cells, 16 links, 1 patch", the one way a skin's size is said.
Message sizeText(const Reconstruction& reconstruction);

/// Flat honeycomb of all patches side by side, from the port geometry alone.
FlatLayout computeFlatLayout(const CellModel& model, const std::vector<PatchReconstruction>& patches);

}  // namespace hexoderm
