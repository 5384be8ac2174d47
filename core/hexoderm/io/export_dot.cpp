#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/text.h"
#include "hexoderm/solve/result/quality_colors.h"
#include "hexoderm/solve/result/result_graph.h"

#include <fmt/format.h>
#include <boost/graph/graphviz.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <map>
#include <sstream>
#include <string_view>
#include <unordered_map>

namespace hexoderm {
namespace {

constexpr double kInch_m = 0.0254;

/// By name, values unescaped.
using DotAttributes = std::map<std::string, std::string>;

std::string colorName(std::uint32_t rgb) { return fmt::format("#{:06X}", rgb & 0xFFFFFFU); }

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
  attributes["style"] = link.quality == EdgeQuality::Undefined   ? "dotted"
                        : link.quality == EdgeQuality::Partially ? "dashed"
                                                                 : "solid";
  // DOT draws a list of colours as parallel lines.
  if (link.quality == EdgeQuality::Over) attributes["color"] = color + ":" + color;
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

/// A quoted string. DOT itself only knows the escaped quote; labels read backslashes and HTML entities on top of it.
std::string inQuotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    result += c == '"' ? "\\\"" : c == '\\' ? "\\\\" : c == '\n' ? "\\n" : c == '&' ? "&amp;" : std::string(1, c);
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
  return text + "]";
}

DotAttributes cellAttributes(const ResultCell& cell, const FlatCell* place) {
  const CellPlacement& placement = *cell.placement;
  DotAttributes attributes;
  attributes["label"] = toString(placement.cell);
  if (!placement.body_part.empty()) attributes["label"] += "\n" + printable(placement.body_part);
  if (placement.cell == cell.patch->origin) attributes["peripheries"] = "2";
  if (place != nullptr) {
    attributes["pos"] = formatExact(place->center.x() / kInch_m) + "," + formatExact(place->center.y() / kInch_m) + "!";
  }
  return attributes;
}

/// What holds for all cells and links, and which cells are in which patch.
void writeHead(std::ostream& out, const Reconstruction& reconstruction) {
  out << "graph" << attributeList({{"layout", "neato"}, {"outputorder", "edgesfirst"}, {"charset", "UTF-8"}}) << ";\n";
  // A hexagon of this width has about the size of the real cell's.
  const std::string width = formatFixed(1.7 * reconstruction.model->side_m / kInch_m, 3);
  out << "node"
      << attributeList({{"shape", "hexagon"},
                        {"style", "filled"},
                        {"fillcolor", "white"},
                        {"width", width},
                        {"height", width},
                        {"fixedsize", "true"},
                        {"margin", "0"},
                        {"fontsize", "10"},
                        {"fontname", "sans-serif"}})
      << ";\nedge" << attributeList({{"fontsize", "8"}, {"fontname", "sans-serif"}, {"arrowsize", "0.5"}}) << ";\n";
  for (const PatchReconstruction& patch : reconstruction.patches) {
    const std::string label = "patch " + toString(patch.id) + ", origin cell " + toString(patch.origin);
    out << "subgraph \"cluster_" << patch.id << "\" {\n  graph" << attributeList({{"label", label}}) << ";\n ";
    for (const CellPlacement& cell : patch.cells) out << ' ' << cell.cell << ';';
    out << "\n}\n";
  }
}

}  // namespace

std::string dotText(const Reconstruction& reconstruction) {
  std::unordered_map<CellId, const FlatCell*> flat;
  for (const FlatCell& cell : reconstruction.layout.cells) flat[cell.cell] = &cell;
  const ResultGraph::Graph& graph = reconstruction.graph().graph();
  const auto writeCell = [&](std::ostream& out, ResultGraph::Vertex vertex) {
    const auto place = flat.find(graph[vertex].placement->cell);
    out << attributeList(cellAttributes(graph[vertex], place == flat.end() ? nullptr : place->second));
  };
  const auto writeEdge = [&](std::ostream& out, const ResultGraph::Edge& edge) {
    DotAttributes attributes = linkAttributes(*graph[edge].link);
    attributes["taillabel"] = toString(graph[edge].tail().port);
    attributes["headlabel"] = toString(graph[edge].head().port);
    out << attributeList(attributes);
  };
  const auto idOf = [&](ResultGraph::Vertex vertex) { return graph[vertex].placement->cell; };
  std::ostringstream out;
  boost::write_graphviz(
      out, graph, writeCell, writeEdge, [&](std::ostream& head) { writeHead(head, reconstruction); },
      boost::make_function_property_map<ResultGraph::Vertex>(idOf));
  return out.str();
}

}  // namespace hexoderm
