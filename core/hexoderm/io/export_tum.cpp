#include "hexoderm/io/export_formats.h"

#include "hexoderm/io/export_selection.h"
#include "hexoderm/io/export_support.h"
#include "hexoderm/util/text.h"

#include <map>
#include <pugixml.hpp>
#include <sstream>

namespace hexoderm {
namespace {

constexpr int kTumDecimals = 12;
/// The tool counts patches from 1.
std::uint32_t tumPatchId(const PatchReconstruction& patch) { return patch.id.value() + 1; }

template <class Matrix>
void appendMatrix(pugi::xml_node parent, const char* name, const Matrix& values) {
  pugi::xml_node matrix = parent.append_child(name).append_child("matrix");
  matrix.append_attribute("rows") = static_cast<int>(values.rows());
  matrix.append_attribute("cols") = static_cast<int>(values.cols());
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    for (Eigen::Index col = 0; col < values.cols(); ++col) {
      pugi::xml_node element = matrix.append_child("element");
      element.append_attribute("row") = static_cast<int>(row);
      element.append_attribute("col") = static_cast<int>(col);
      element.text().set(formatFixed(values(row, col) + 0.0, kTumDecimals).c_str());
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
  pugi::xml_node extrinsics = root.append_child("patchExtrinsics");
  extrinsics.append_attribute("patchId") = tumPatchId(patch);
  extrinsics.append_attribute("baseFrame") = place != nullptr ? place->link.c_str() : options.parent_link.c_str();
  extrinsics.append_attribute("dhFrame") = "";
  extrinsics.append_attribute("jointId") = "0";
  appendTransform(extrinsics.append_child("tf_rootCell_base"), place != nullptr ? rigid(place->T_l_o) : SE3{});
  appendTransform(extrinsics.append_child("tf_base_dh"), {});
}

}  // namespace

std::string tumBytes(const Reconstruction& reconstruction, const ExportOptions& options) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  document.append_child(pugi::node_doctype).set_value("scfg");
  pugi::xml_node root = document.append_child("SkinConfig");
  const auto patches = static_cast<unsigned>(reconstruction.patches.size());
  root.append_attribute("numberOfCells") = static_cast<unsigned>(reconstruction.cellCount());
  root.append_attribute("numberOfPatchDriverSettings") = patches;
  root.append_attribute("numberOfPatchExtrinsics") = patches;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    pugi::xml_node driver = root.append_child("patchDriverSettings");
    driver.append_attribute("patchId") = tumPatchId(patch);
    driver.append_attribute("prefix") = "/";
  }
  for (const PatchReconstruction& patch : reconstruction.patches) appendExtrinsics(root, patch, options);

  const auto neighbors = neighborsOf(reconstruction);
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& placement : patch.cells) {
      pugi::xml_node cell = root.append_child("cell");
      cell.append_attribute("id") = placement.cell.value();
      cell.append_attribute("patch") = tumPatchId(patch);
      cell.append_attribute("segment") = "1";
      cell.append_child("rootCellId").text().set(patch.origin.value());
      pugi::xml_node list = cell.append_child("neighbors");
      list.append_attribute("id") = placement.cell.value();
      list.append_attribute("size") = static_cast<unsigned>(reconstruction.model->ports.size());
      for (const Port& port : reconstruction.model->ports) {
        const auto found = neighbors.find({placement.cell, port.number});
        pugi::xml_node neighbor = list.append_child("neighbor");
        neighbor.append_attribute("port") = port.number.value();
        neighbor.append_attribute("id") = found == neighbors.end() ? 0U : found->second.value();
      }
      appendTransform(cell, rigid(placement.T_o_u));
    }
  }
  std::ostringstream out;
  document.save(out, "    ");
  return std::move(out).str();
}

}  // namespace hexoderm
