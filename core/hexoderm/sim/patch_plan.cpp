#include "hexoderm/sim/patch_plan.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"

#include <cmath>

namespace hexoderm {
namespace {

constexpr std::size_t kMaxCellsOfSheet = 1'000'000;
constexpr std::size_t kMaxCellsOfRing = 100'000;
constexpr std::size_t kMaxLiveCells = 100'000;
constexpr std::size_t kArmCells = 4;
constexpr std::string_view kClosed = ":closed";

/// A straight line of cells leaves each through `out` and enters the next through `in`.
struct Line {
  Port out;
  Port in;
};

bool areOpposite(const Port& a, const Port& b) {
  const Eigen::Vector2d u = a.vector_m.head<2>().normalized();
  const Eigen::Vector2d v = b.vector_m.head<2>().normalized();
  return u.dot(v) < 0 && std::abs(u.x() * v.y() - u.y() * v.x()) < 0.5 * kDegree;
}

/// The model's lines in the order of their smallest port number.
std::vector<Line> straightLines(const CellModel& model, std::size_t needed, const std::string& patch) {
  std::vector<Port> ports = model.ports;
  std::ranges::sort(ports, {}, &Port::number);
  std::vector<Line> lines;
  for (std::size_t a = 0; a < ports.size(); ++a) {
    for (std::size_t b = a + 1; b < ports.size(); ++b) {
      if (areOpposite(ports[a], ports[b]) && !model.isForbidden(ports[a].number, ports[b].number)) {
        lines.push_back({ports[a], ports[b]});
        break;
      }
    }
  }
  if (lines.size() < needed) {
    throw InvalidArgument(
        needed == 1
            ? message("patch {} needs a cell model with 1 pair of opposite ports that may be joined; {} has {}", patch,
                      model.name, lines.size())
            : message("patch {} needs a cell model with {} pairs of opposite ports that may be joined; {} has {}",
                      patch, needed, model.name, lines.size()));
  }
  return lines;
}

double headingOf(const Eigen::Vector3d& v) { return std::atan2(v.y(), v.x()); }

/// Two crossing lines, turned so that they leave the cell less than 90 degrees apart.
std::pair<Line, Line> crossingLines(const CellModel& model, const std::string& patch) {
  const std::vector<Line> lines = straightLines(model, 2, patch);
  Line a = lines[0];
  Line b = lines[1];
  if (a.out.vector_m.dot(b.out.vector_m) < 0) std::swap(b.out, b.in);
  return {a, b};
}

void join(PatchPlan& plan, std::size_t from, std::size_t to, const Line& line) {
  plan.links.push_back({from, to, line.out, line.in});
}

PatchPlan planX17(const CellModel& model, const std::string& patch) {
  const auto [a, b] = crossingLines(model, patch);
  PatchPlan plan;
  plan.cell_count = 1 + 4 * kArmCells;
  plan.start_yaw_rad = -headingOf(a.out.vector_m.normalized() + b.out.vector_m.normalized());
  std::size_t next = 1;
  for (const Line& line : {a, Line{a.in, a.out}, b, Line{b.in, b.out}}) {
    std::size_t from = 0;
    for (std::size_t k = 0; k < kArmCells; ++k) {
      join(plan, from, next, line);
      from = next++;
    }
  }
  return plan;
}

/// The line that a ring runs along, and the paper's: cell k's second port of the last pair joins the next cell's first.
Line ringLine(const CellModel& model, const std::string& patch) {
  const Line line = straightLines(model, 1, patch).back();
  return {line.in, line.out};
}

PatchPlan planRing(std::size_t cells, bool closed, const CellModel& model, const std::string& patch) {
  const Line line = ringLine(model, patch);
  PatchPlan plan;
  plan.cell_count = cells;
  plan.start = (cells - 1) / 2;
  plan.start_yaw_rad = -headingOf(line.out.vector_m);
  plan.is_ring = true;
  for (std::size_t k = 0; k + 1 < cells; ++k) join(plan, k, k + 1, line);
  if (closed) {
    plan.closure = {cells - 1, 0, line.out, line.in};
  } else {
    plan.loop = {{CellId(1), line.in.number}, {CellId(static_cast<std::uint32_t>(cells)), line.out.number}};
  }
  return plan;
}

/// Cells at the points of the rhombic lattice of two crossing lines, cut to a rectangle: the columns stand side by side
/// along the bisector of the lines, every second one half a row higher. Neighbours in a row are joined by one line, and
/// diagonally by the other. A single column, which would not be joined at all, becomes a straight line instead.
PatchPlan planSheet(std::size_t rows, std::size_t cols, const CellModel& model, const std::string& patch) {
  const auto [a, b] = crossingLines(model, patch);
  PatchPlan plan;
  plan.cell_count = rows * cols;
  plan.start_yaw_rad = -headingOf(a.out.vector_m.normalized() + b.out.vector_m.normalized());
  plan.start = (rows / 2) * cols + cols / 2;
  plan.has_loops = rows > 1 && cols > 1;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t col = 0; col < cols; ++col) {
      const std::size_t cell = row * cols + col;
      if (cols == 1) {
        if (row + 1 < rows) join(plan, cell, cell + 1, a);
        continue;
      }
      if (col + 1 == cols) continue;
      const bool high = col % 2 == 1;
      join(plan, cell, cell + 1, high ? b : a);
      if (high && row + 1 < rows) join(plan, cell, cell + cols + 1, a);
      if (!high && row > 0) join(plan, cell, cell - cols + 1, b);
    }
  }
  return plan;
}

}  // namespace

NamedPatch parsePatch(const std::string& patch) {
  if (patch == "x17") return {};
  const std::string ring = "ring";
  if (patch.starts_with(ring) && patch.size() > ring.size()) {
    std::string_view count = std::string_view(patch).substr(ring.size());
    const bool closed = count.ends_with(kClosed);
    if (closed) count.remove_suffix(kClosed.size());
    const std::size_t cells = parseUnsigned(count, "patch \"" + patch + "\", cells");
    if (cells < 3 || cells > kMaxCellsOfRing)
      throw InvalidArgument(message("patch \"{}\": a ring has 3 to 100000 cells", patch));
    return {closed ? PatchKind::ClosedRing : PatchKind::Ring, cells, 1};
  }
  const std::string sheet = "sheet:";
  if (patch.starts_with(sheet)) {
    const std::vector<std::string> sizes = split(std::string_view(patch).substr(sheet.size()), 'x');
    if (sizes.size() != 2) throw InvalidArgument(message("patch \"{}\": expected sheet:ROWSxCOLS", patch));
    const std::size_t rows = parseUnsigned(sizes[0], "patch \"" + patch + "\", rows");
    const std::size_t cols = parseUnsigned(sizes[1], "patch \"" + patch + "\", columns");
    if (rows == 0 || cols == 0 || rows > kMaxCellsOfSheet || cols > kMaxCellsOfSheet ||
        rows * cols > kMaxCellsOfSheet) {
      throw InvalidArgument(message("patch \"{}\": a sheet has 1 to 1000000 cells", patch));
    }
    return {PatchKind::Sheet, rows, cols};
  }
  throw InvalidArgument(
      message("patch \"{}\" is not known; expected x17, ringN, ringN:closed or sheet:ROWSxCOLS", patch));
}

NamedPatch parseLivePatch(const std::string& patch) {
  const NamedPatch shape = parsePatch(patch);
  if (shape.rows * shape.cols > kMaxLiveCells) {
    throw InvalidArgument(
        message("patch \"{}\": a live skin, or one on a robot, has at most {} cells", patch, kMaxLiveCells));
  }
  return shape;
}

PatchPlan planPatch(const std::string& patch, const CellModel& model) {
  const NamedPatch shape = parsePatch(patch);
  switch (shape.kind) {
    case PatchKind::X17:
      return planX17(model, patch);
    case PatchKind::Ring:
    case PatchKind::ClosedRing:
      return planRing(shape.rows, shape.kind == PatchKind::ClosedRing, model, patch);
    case PatchKind::Sheet:
      return planSheet(shape.rows, shape.cols, model, patch);
  }
  return {};
}

std::vector<PlannedLink> PatchPlan::allLinks() const {
  std::vector<PlannedLink> all = links;
  if (closure) all.push_back(*closure);
  return all;
}

double closingRadius(const CellModel& model, std::size_t ring_cells, bool bends) {
  const Line line = ringLine(model, "ring");
  const double a = reachOf(line.out);
  const double b = reachOf(line.in);
  const double angle = 2 * kPi / static_cast<double>(ring_cells);
  if (!bends) return (a + b) / angle;
  // atan(a / r) + atan(b / r) = angle. The cotangent of 45 degrees is 1, which rounding would miss.
  const double sum = (a + b) * (ring_cells == 8 ? 1 : std::cos(angle) / std::sin(angle));
  return (sum + std::sqrt(sum * sum + 4 * a * b)) / 2;
}

}  // namespace hexoderm
