#include "hexoderm/io/tum_xml.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/base/text.h"
#include "hexoderm/skin/skin_graph.h"
#include "hexoderm/solve/faults/link_plausibility.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstring>
#include <pugixml.hpp>
#include <set>
#include <unordered_map>

namespace hexoderm {
namespace {

constexpr double kRotationTolerance = 1e-6;
/// No skin is larger; what follows from positions of 1e308 m is not finite.
constexpr double kFarthest_m = 1000;
/// Tens of thousands of cells; an element of four bytes takes about 70 in memory.
constexpr std::size_t kMaxXmlMegabytes = 50;

/// Reads one file; knows where it is for its complaints.
class TumReader {
 public:
  TumReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  TumSkinConfig read() {
    if (text_.size() > kMaxXmlMegabytes * 1'000'000) {
      throw FormatError(file_, message("is too large: at most {} MB of XML are read", kMaxXmlMegabytes));
    }
    const pugi::xml_parse_result parsed = document_.load_buffer(text_.data(), text_.size());
    if (!parsed) {
      throw FormatError(file_,
                        located(message("line {}", lineAt(parsed.offset)),
                                message("this is not well-formed XML ({}; truncated?), expected a TUM SkinConfig",
                                        parsed.description())));
    }
    const pugi::xml_node root = document_.document_element();
    if (std::strcmp(root.name(), "SkinConfig") != 0) {
      fail(root, "", message("expected the root element SkinConfig, found {}", root.name()));
    }
    TumSkinConfig config;
    std::set<CellId> known;
    for (const pugi::xml_node node : root.children("cell")) {
      config.cells.push_back(readCell(node));
      const CellId id = config.cells.back().report.id;
      if (!known.insert(id).second)
        fail(node, "cell " + toString(id), message("expected each cell once, found this ID again"));
    }
    const unsigned count = wholeAttribute(root, "numberOfCells", "SkinConfig");
    if (count != config.cells.size()) {
      fail(root, "SkinConfig", message("expected numberOfCells=\"{}\" cells, found {}", count, config.cells.size()));
    }
    config.sha256 = sha256Hex(text_);
    return config;
  }

 private:
  [[nodiscard]] std::ptrdiff_t lineAt(std::ptrdiff_t offset) const {
    const auto end = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
    return std::ranges::count(text_.substr(0, end), '\n') + 1;
  }

  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& where, Message what) const {
    if (!where.empty()) what = located(where, std::move(what));
    throw FormatError(file_, located(message("line {}", lineAt(node.offset_debug())), std::move(what)));
  }

  [[nodiscard]] pugi::xml_node child(const pugi::xml_node& parent, const char* name, const std::string& where) const {
    const pugi::xml_node node = parent.child(name);
    if (!node) fail(parent, where, message("expected an element <{}>, but there is none", name));
    if (node.next_sibling(name)) fail(node.next_sibling(name), where, message("expected only one <{}>", name));
    return node;
  }

  /// Turns the complaint of a parser of plain text into one that says where it is.
  template <class Parse>
  auto parse(const pugi::xml_node& node, const std::string& where, const std::string& what, std::string_view text,
             Parse parse_text) const {
    try {
      return parse_text(trimmed(text), what);
    } catch (const InvalidArgument& error) {
      fail(node, where, error.message());
    }
  }

  [[nodiscard]] unsigned wholeAttribute(const pugi::xml_node& node, const char* name, const std::string& where) const {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) fail(node, where, message("expected an attribute {}, but there is none", name));
    return parse(node, where, name, attribute.value(), parseUnsigned);
  }

  TumSkinConfig::Cell readCell(const pugi::xml_node& node) const {
    TumSkinConfig::Cell cell;
    cell.report.id = CellId(wholeAttribute(node, "id", "cell"));
    const std::string where = "cell " + toString(cell.report.id);
    cell.patch = wholeAttribute(node, "patch", where);
    cell.segment = wholeAttribute(node, "segment", where);
    const pugi::xml_node root = child(node, "rootCellId", where);
    cell.root = CellId(parse(root, where, "rootCellId", root.child_value(), parseUnsigned));
    cell.report.neighbors = readNeighbors(child(node, "neighbors", where), cell.report.id, where);
    const pugi::xml_node pos = child(node, "pos", where);
    cell.T_root_u.t = readMatrix<3, 1>(pos, where + ", pos");
    if (cell.T_root_u.t.cwiseAbs().maxCoeff() > kFarthest_m) {
      fail(pos, where + ", pos", message("expected metres from the root cell, at most {}", Number{kFarthest_m, 0}));
    }
    const pugi::xml_node rot = child(node, "rot", where);
    cell.T_root_u.R = readMatrix<3, 3>(rot, where + ", rot");
    const Eigen::Matrix3d& R = cell.T_root_u.R;
    if (!(R * R.transpose()).isIdentity(kRotationTolerance) || R.determinant() < 0) {
      fail(rot, where + ", rot", message("expected a rotation matrix (orthogonal to 1e-6, determinant +1)"));
    }
    return cell;
  }

  std::vector<NeighborReport> readNeighbors(const pugi::xml_node& node, CellId cell, const std::string& where) const {
    const unsigned id = wholeAttribute(node, "id", where + ", neighbors");
    if (id != cell.value()) fail(node, where + ", neighbors", message("expected id=\"{}\", found {}", cell, id));
    std::vector<NeighborReport> neighbors;
    std::set<PortNumber> ports;
    for (const pugi::xml_node item : node.children("neighbor")) {
      const PortNumber port(wholeAttribute(item, "port", where + ", neighbor"));
      const std::string at = where + ", neighbor at port " + toString(port);
      if (!ports.insert(port).second) fail(item, at, message("expected each port once, found it again"));
      neighbors.push_back({port, CellId(wholeAttribute(item, "id", at)), std::nullopt});
    }
    const unsigned size = wholeAttribute(node, "size", where + ", neighbors");
    if (size != neighbors.size()) {
      fail(node, where + ", neighbors", message("expected size=\"{}\" neighbors, found {}", size, neighbors.size()));
    }
    return neighbors;
  }

  template <int Rows, int Cols>
  Eigen::Matrix<double, Rows, Cols> readMatrix(const pugi::xml_node& parent, const std::string& where) const {
    const pugi::xml_node node = child(parent, "matrix", where);
    const unsigned rows = wholeAttribute(node, "rows", where);
    const unsigned cols = wholeAttribute(node, "cols", where);
    if (rows != Rows || cols != Cols) {
      fail(node, where, message("expected a matrix of {} x {}, found {} x {}", Rows, Cols, rows, cols));
    }
    Eigen::Matrix<double, Rows, Cols> matrix;
    std::array<bool, static_cast<std::size_t>(Rows * Cols)> is_set{};
    for (const pugi::xml_node element : node.children("element")) {
      const unsigned row = wholeAttribute(element, "row", where);
      const unsigned col = wholeAttribute(element, "col", where);
      const std::string name = "element row " + std::to_string(row) + " col " + std::to_string(col);
      if (row >= Rows || col >= Cols) {
        fail(element, where, located(name, message("lies outside the matrix of {} x {}", Rows, Cols)));
      }
      bool& seen = is_set.at(row * Cols + col);
      if (seen) fail(element, where, located(name, message("expected each element once, found it again")));
      seen = true;
      matrix(static_cast<int>(row), static_cast<int>(col)) =
          parse(element, where, name, element.child_value(), parseNumber);
    }
    if (!std::ranges::all_of(is_set, [](bool set) { return set; })) {
      fail(node, where, message("expected {} elements, but some are missing", Rows * Cols));
    }
    return matrix;
  }

  std::string_view text_;
  const std::string& file_;
  pugi::xml_document document_;
};

NeighborList neighborList(const TumSkinConfig& config) {
  NeighborList neighbors;
  for (const TumSkinConfig::Cell& cell : config.cells) neighbors.push_back(cell.report);
  return neighbors;
}

SourceDescription sourceDescription(const TumSkinConfig& config, const std::string& file, bool with_placements) {
  const std::string name = std::filesystem::path(file).filename().string();
  return {with_placements ? message("Placements of the TUM skin configuration {}", name)
                          : message("Topology of the TUM skin configuration {}", name),
          name, config.sha256};
}

/// The placements of a configuration as a calibration.
class Importer {
 public:
  Importer(const TumSkinConfig& config, const CellModel& model) : model_(model), graph_(model, neighborList(config)) {
    for (const TumSkinConfig::Cell& cell : config.cells) cells_.emplace(cell.report.id, &cell);
    findings_ = graph_.findings();
    muteLinksBetweenFrames();
  }

  std::vector<PatchReconstruction> patches() {
    std::vector<PatchReconstruction> patches;
    for (const std::vector<std::size_t>& members : graph_.patches()) patches.push_back(patchOf(members));
    for (const GraphLink& link : graph_.links()) {
      patches[graph_.cells()[link.source].patch.value()].links.push_back(estimateOf(link));
    }
    return patches;
  }

  [[nodiscard]] std::vector<Finding> takeFindings() { return std::move(findings_); }

 private:
  [[nodiscard]] const TumSkinConfig::Cell& cellAt(std::size_t index) const {
    return *cells_.at(graph_.cells()[index].id);
  }
  [[nodiscard]] bool shareFrame(const GraphLink& link) const {
    return cellAt(link.source).root == cellAt(link.target).root;
  }

  /// The file does not tell the relative placement of two cells that are placed in frames of different root cells.
  void muteLinksBetweenFrames() {
    std::vector<std::size_t> between;
    for (std::size_t k = 0; k < graph_.links().size(); ++k) {
      const GraphLink& link = graph_.links()[k];
      if (link.muted() || shareFrame(link)) continue;
      between.push_back(k);
      const LinkEnd source = graph_.sourceEnd(link);
      const LinkEnd target = graph_.targetEnd(link);
      findings_.push_back(
          makeFinding(FindingCode::BodyPartBoundary,
                      message("The {} joins cells that the file places in different frames (root cells {} and {}); the "
                              "patch ends there.",
                              linkText(source, target), cellAt(link.source).root, cellAt(link.target).root),
                      {source.cell, target.cell}, {source.port, target.port}));
    }
    if (!between.empty()) graph_.mute(between, FindingCode::BodyPartBoundary);
  }

  PatchReconstruction patchOf(const std::vector<std::size_t>& members) const {
    PatchReconstruction patch;
    patch.id = graph_.cells()[members.front()].patch;
    const CellId root = cellAt(members.front()).root;
    const auto found = std::ranges::find_if(members, [&](std::size_t k) { return graph_.cells()[k].id == root; });
    const TumSkinConfig::Cell& origin = cellAt(found != members.end() ? *found : members.front());
    patch.origin = origin.report.id;
    const SE3 T_o_root = origin.T_root_u.inverse();
    for (const std::size_t k : members) {
      CellPlacement placement;
      placement.cell = graph_.cells()[k].id;
      placement.body_part = graph_.cells()[k].body_part;
      if (placement.cell != patch.origin) placement.T_o_u = T_o_root * cellAt(k).T_root_u;
      for (const CellSensor& sensor : model_.sensors) {
        placement.sensors.push_back({sensor.name, sensor.type, placement.T_o_u * sensor.T_u_s});
      }
      patch.cells.push_back(std::move(placement));
    }
    return patch;
  }

  LinkEstimate estimateOf(const GraphLink& link) {
    LinkEstimate estimate;
    estimate.source = graph_.sourceEnd(link);
    estimate.target = graph_.targetEnd(link);
    estimate.muted_by = link.muted_by;
    estimate.used = !link.muted();
    const Port& source = model_.port(link.source_port);
    const Port& target = model_.port(link.target_port);
    if (!shareFrame(link)) {
      estimate.R_c_n = nominalAlignment(source, target);
      return estimate;
    }
    estimate.R_c_n = cellAt(link.source).T_root_u.R.transpose() * cellAt(link.target).T_root_u.R;
    const LinkAngles angles = linkAngles(estimate.R_c_n, source, target);
    estimate.bend_rad = angles.bend_rad;
    estimate.twist_rad = angles.twist_rad;
    estimate.yaw_rad = angles.yaw_rad;
    if (estimate.used) {
      std::ranges::move(judgeLinkAngles(angles, estimate.source, estimate.target, model_, SolverOptions{}, {}),
                        std::back_inserter(findings_));
    }
    return estimate;
  }

  const CellModel& model_;
  SkinGraph graph_;
  std::unordered_map<CellId, const TumSkinConfig::Cell*> cells_;
  std::vector<Finding> findings_;
};

}  // namespace

TumSkinConfig parseTumXml(std::string_view text, const std::string& file) { return TumReader(text, file).read(); }

TumSkinConfig readTumXml(const std::filesystem::path& path) { return parseTumXml(readFile(path), path.string()); }

Session sessionFromTum(const TumSkinConfig& config, const CellModel& model, const std::string& file) {
  return {model, neighborList(config), sourceDescription(config, file, false)};
}

std::shared_ptr<const Reconstruction> calibrationFromTum(const TumSkinConfig& config, const CellModel& model,
                                                         const std::string& file) {
  Reconstruction result;
  result.solver = "imported";
  result.source = sourceDescription(config, file, true);
  result.model = std::make_shared<const CellModel>(model);
  Importer importer(config, *result.model);
  result.patches = importer.patches();
  result.findings = importer.takeFindings();
  result.assessment.level = VerdictLevel::Usable;
  result.assessment.reason = message("Imported placements; nothing was measured here.");
  result.assessment.next_action = message("Check the findings, then export, or take poses of this skin to measure it.");
  result.layout = computeFlatLayout(*result.model, result.patches);
  return std::make_shared<const Reconstruction>(std::move(result));
}

}  // namespace hexoderm
