#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/text.h"
#include "hexoderm/io/export_selection.h"
#include "hexoderm/io/xml_writing.h"

#include <map>
#include <pugixml.hpp>

namespace hexoderm {
namespace {

constexpr int kTumDecimals = 12;
/// The tool counts patches from 1.
std::string tumPatchId(const PatchReconstruction& patch) { return std::to_string(patch.id.value() + 1); }

template <class Matrix>
void appendMatrix(pugi::xml_node parent, const char* name, const Matrix& values) {
  pugi::xml_node matrix =
      appendElement(parent.append_child(name), "matrix",
                    {{"rows", std::to_string(values.rows())}, {"cols", std::to_string(values.cols())}});
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    for (Eigen::Index col = 0; col < values.cols(); ++col) {
      appendElement(matrix, "element", {{"row", std::to_string(row)}, {"col", std::to_string(col)}})
          .text()
          .set(formatFixed(values(row, col) + 0.0, kTumDecimals).c_str());
    }
  }
}

void appendTransform(pugi::xml_node parent, const SE3& T) {
  appendMatrix(parent, "pos", T.t);
  appendMatrix(parent, "rot", T.R);
}

using PortKey = std::pair<CellId, PortNumber>;

/// The neighbour at each port that has one, of links within the skin, used or not: the wires are there.
std::map<PortKey, CellId> neighborsOf(const Reconstruction& reconstruction) {
  std::map<PortKey, CellId> neighbors;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      neighbors.emplace(PortKey{link.source.cell, link.source.port}, link.target.cell);
      neighbors.emplace(PortKey{link.target.cell, link.target.port}, link.source.cell);
    }
  }
  return neighbors;
}

void appendExtrinsics(pugi::xml_node root, const PatchReconstruction& patch, const ExportOptions& options) {
  const PatchOnLink* place = placementOf(patch, options);
  pugi::xml_node extrinsics = appendElement(root, "patchExtrinsics",
                                            {{"patchId", tumPatchId(patch)},
                                             {"baseFrame", place != nullptr ? place->link : options.parent_link},
                                             {"dhFrame", ""},
                                             {"jointId", "0"}});
  appendTransform(extrinsics.append_child("tf_rootCell_base"), place != nullptr ? rigid(place->T_l_o) : SE3{});
  appendTransform(extrinsics.append_child("tf_base_dh"), {});
}

}  // namespace

std::string tumBytes(const Reconstruction& reconstruction, const ExportOptions& options) {
  pugi::xml_document document;
  declareXml(document);
  document.append_child(pugi::node_doctype).set_value("scfg");
  const std::string patches = std::to_string(reconstruction.patches.size());
  pugi::xml_node root = appendElement(document, "SkinConfig",
                                      {{"numberOfCells", std::to_string(reconstruction.cellCount())},
                                       {"numberOfPatchDriverSettings", patches},
                                       {"numberOfPatchExtrinsics", patches}});
  for (const PatchReconstruction& patch : reconstruction.patches) {
    appendElement(root, "patchDriverSettings", {{"patchId", tumPatchId(patch)}, {"prefix", "/"}});
  }
  for (const PatchReconstruction& patch : reconstruction.patches) appendExtrinsics(root, patch, options);

  const auto neighbors = neighborsOf(reconstruction);
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& placement : patch.cells) {
      const std::string id = toString(placement.cell);
      pugi::xml_node cell = appendElement(root, "cell", {{"id", id}, {"patch", tumPatchId(patch)}, {"segment", "1"}});
      cell.append_child("rootCellId").text().set(patch.origin.value());
      pugi::xml_node list =
          appendElement(cell, "neighbors", {{"id", id}, {"size", std::to_string(reconstruction.model->ports.size())}});
      for (const Port& port : reconstruction.model->ports) {
        const auto found = neighbors.find({placement.cell, port.number});
        appendElement(
            list, "neighbor",
            {{"port", toString(port.number)}, {"id", found == neighbors.end() ? "0" : toString(found->second)}});
      }
      appendTransform(cell, rigid(placement.T_o_u));
    }
  }
  return xmlText(document, "    ");
}

}  // namespace hexoderm
