#include "hexoderm/io/export_dot.h"

#include "hexoderm/io/export_support.h"
#include "hexoderm/reconstruction/result/quality_colors.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/hex.h"
#include "hexoderm/util/text.h"

#include <array>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kInch_m = 0.0254;

std::string colorName(std::uint32_t rgb) {
  const std::array<std::uint8_t, 3> bytes = {static_cast<std::uint8_t>(rgb >> 16U),
                                             static_cast<std::uint8_t>(rgb >> 8U), static_cast<std::uint8_t>(rgb)};
  return "#" + hexDigits(bytes, HexCase::Upper);
}

/// Other control characters than the line feed have no meaning in a label.
std::string printable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n') c = ' ';
  }
  return text;
}

DotAttributes linkAttributes(const LinkEstimate& link) {
  DotAttributes attributes;
  const std::string color = colorName(qualityColor(link.quality, Background::Light));
  attributes["tooltip"] = std::string(qualityName(link.quality));
  attributes["color"] = color;
  switch (link.quality) {
    case EdgeQuality::Undefined:
      attributes["style"] = "dotted";
      break;
    case EdgeQuality::Partially:
      attributes["style"] = "dashed";
      break;
    case EdgeQuality::Fully:
      attributes["style"] = "solid";
      break;
    case EdgeQuality::Over:  // DOT draws a list of colours as parallel lines
      attributes["style"] = "solid";
      attributes["color"] = color + ":" + color;
      break;
  }
  if (link.in_tree) attributes["penwidth"] = "2";
  if (!link.used) {
    attributes["color"] = colorName(unusedColor(Background::Light));
    attributes["style"] = "dashed";
    attributes["label"] = "x";
    attributes["tooltip"] = "muted";
    if (link.muted_by) attributes["tooltip"] += ": " + std::string(codeName(*link.muted_by));
  }
  return attributes;
}

DotEdge directedEdge(LinkEnd from, LinkEnd to, DotAttributes attributes) {
  attributes["taillabel"] = toString(from.port);
  attributes["headlabel"] = toString(to.port);
  return {toString(from.cell), toString(to.cell), std::move(attributes)};
}

/// A quoted string. DOT itself only knows the escaped quote; labels read backslashes and HTML entities on top of it.
std::string inQuotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        result += "\\\"";
        break;
      case '\\':
        result += "\\\\";
        break;
      case '\n':
        result += "\\n";
        break;
      case '&':
        result += "&amp;";
        break;
      default:
        result += c;
    }
  }
  return result + '"';
}

std::string attributeList(const DotAttributes& attributes) {
  std::string text = " [";
  for (const auto& [name, value] : attributes) {
    if (text.size() > 2) text += ", ";
    text += name;
    text += '=';
    text += inQuotes(value);
  }
  return text + "];\n";
}

}  // namespace

DotGraph dotGraph(const Reconstruction& reconstruction) {
  std::unordered_map<CellId, const FlatCell*> flat;
  for (const FlatCell& cell : reconstruction.layout.cells) flat[cell.cell] = &cell;

  DotGraph graph;
  graph.name = "skin";
  graph.graph_defaults = {{"layout", "neato"}, {"outputorder", "edgesfirst"}, {"charset", "UTF-8"}};
  // A hexagon of this width has about the size of the real cell's.
  const std::string width = formatFixed(1.7 * reconstruction.model->side_m / kInch_m, 3);
  graph.node_defaults = {{"shape", "hexagon"}, {"style", "filled"}, {"fillcolor", "white"},
                         {"width", width},     {"height", width},   {"fixedsize", "true"},
                         {"margin", "0"},      {"fontsize", "10"},  {"fontname", "sans-serif"}};
  graph.edge_defaults = {{"fontsize", "8"}, {"fontname", "sans-serif"}, {"arrowsize", "0.5"}};
  std::unordered_set<CellId> cells;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    DotCluster cluster;
    cluster.name = "cluster_" + toString(patch.id);
    cluster.attributes["label"] = "patch " + toString(patch.id) + ", origin cell " + toString(patch.origin);
    for (const CellPlacement& cell : patch.cells) {
      cells.insert(cell.cell);
      DotNode node{toString(cell.cell), {}};
      node.attributes["label"] = node.name;
      if (!cell.body_part.empty()) node.attributes["label"] += "\n" + printable(cell.body_part);
      if (cell.cell == patch.origin) node.attributes["peripheries"] = "2";
      const auto place = flat.find(cell.cell);
      if (place != flat.end()) {
        const Vector2d& center = place->second->center;
        node.attributes["pos"] = formatExact(center.x() / kInch_m) + "," + formatExact(center.y() / kInch_m) + "!";
      }
      cluster.nodes.push_back(std::move(node));
    }
    graph.clusters.push_back(std::move(cluster));
  }
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      // Graphviz would make up a cell that is not there, as of a patch that is left out.
      if (!cells.contains(link.source.cell) || !cells.contains(link.target.cell)) continue;
      const DotAttributes attributes = linkAttributes(link);
      graph.edges.push_back(directedEdge(link.source, link.target, attributes));
      graph.edges.push_back(directedEdge(link.target, link.source, attributes));
    }
  }
  return graph;
}

std::string dotText(const DotGraph& graph) {
  std::string text = "digraph " + inQuotes(graph.name) + " {\n";
  text += "  graph" + attributeList(graph.graph_defaults);
  text += "  node" + attributeList(graph.node_defaults);
  text += "  edge" + attributeList(graph.edge_defaults);
  for (const DotCluster& cluster : graph.clusters) {
    text += "  subgraph " + inQuotes(cluster.name) + " {\n    graph" + attributeList(cluster.attributes);
    for (const DotNode& node : cluster.nodes) text += "    " + inQuotes(node.name) + attributeList(node.attributes);
    text += "  }\n";
  }
  for (const DotEdge& edge : graph.edges) {
    text += "  " + inQuotes(edge.tail) + " -> " + inQuotes(edge.head) + attributeList(edge.attributes);
  }
  return text + "}\n";
}

}  // namespace hexoderm
