#include "hexoderm/io/export_dot.h"

#include "hexoderm/io/export_support.h"
#include "hexoderm/reconstruction/result/quality_colors.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/hex.h"
#include "hexoderm/util/text.h"

#include <algorithm>
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

/// Recursive descent over what dotText writes.
class DotReader {
 public:
  DotReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  DotGraph graph() {
    DotGraph graph;
    expectWord("digraph");
    graph.name = string();
    expect("{");
    graph.graph_defaults = defaults("graph");
    graph.node_defaults = defaults("node");
    graph.edge_defaults = defaults("edge");
    while (nextIs("subgraph")) graph.clusters.push_back(cluster());
    while (!nextIs("}")) {
      DotEdge edge;
      edge.tail = string();
      expect("->");
      edge.head = string();
      edge.attributes = attributes();
      graph.edges.push_back(std::move(edge));
    }
    expect("}");
    skipSpace();
    if (at_ != bytes_.size()) fail("nothing after the closing brace");
    return graph;
  }

 private:
  DotCluster cluster() {
    DotCluster cluster;
    expectWord("subgraph");
    cluster.name = string();
    expect("{");
    cluster.attributes = defaults("graph");
    while (!nextIs("}")) {
      DotNode node;
      node.name = string();
      node.attributes = attributes();
      cluster.nodes.push_back(std::move(node));
    }
    expect("}");
    return cluster;
  }

  DotAttributes defaults(std::string_view of) {
    expectWord(of);
    return attributes();
  }

  DotAttributes attributes() {
    DotAttributes result;
    expect("[");
    while (!nextIs("]")) {
      if (!result.empty()) expect(",");
      const std::string name = word();
      expect("=");
      if (!result.emplace(name, string()).second) fail("attribute " + name + " only once");
    }
    expect("]");
    expect(";");
    return result;
  }

  void skipSpace() {
    while (at_ < bytes_.size() && (bytes_[at_] == ' ' || bytes_[at_] == '\n')) {
      if (bytes_[at_++] == '\n') ++line_;
    }
  }
  bool nextIs(std::string_view text) {
    skipSpace();
    return bytes_.substr(at_).starts_with(text);
  }
  void expect(std::string_view text) {
    if (!nextIs(text)) fail("'" + std::string(text) + "'");
    at_ += text.size();
  }
  std::string word() {
    skipSpace();
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && bytes_[at_] >= 'a' && bytes_[at_] <= 'z') ++at_;
    if (at_ == begin) fail("a word");
    return std::string(bytes_.substr(begin, at_ - begin));
  }
  void expectWord(std::string_view expected) {
    if (word() != expected) fail("'" + std::string(expected) + "'");
  }
  std::string string() {
    expect("\"");
    std::string result;
    while (at_ < bytes_.size() && bytes_[at_] != '"') {
      const std::string_view rest = bytes_.substr(at_);
      if (rest.starts_with('\\')) {
        static constexpr std::array<std::pair<std::string_view, char>, 3> kEscapes = {
            {{"\\\"", '"'}, {"\\\\", '\\'}, {"\\n", '\n'}}};
        const auto* escape = std::ranges::find(kEscapes, rest.substr(0, 2), &std::pair<std::string_view, char>::first);
        if (escape == kEscapes.end()) fail("a known escape after the backslash");
        result += escape->second;
        at_ += 2;
      } else if (rest.starts_with('&')) {
        if (!rest.starts_with("&amp;")) fail("'&amp;'");
        result += '&';
        at_ += 5;
      } else {
        if (rest.front() == '\n') ++line_;
        result += bytes_[at_++];
      }
    }
    expect("\"");
    return result;
  }
  [[noreturn]] void fail(const std::string& expected) const {
    throw FormatError(file_ + ": line " + std::to_string(line_) + ": expected " + expected);
  }

  std::string_view bytes_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

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

DotGraph parseDot(std::string_view bytes, const std::string& file) { return DotReader(bytes, file).graph(); }

void verifyDot(std::string_view bytes, const DotGraph& graph, const std::string& file) {
  const DotGraph found = parseDot(bytes, file);
  requireMeant(found.name == graph.name && found.graph_defaults == graph.graph_defaults &&
                   found.node_defaults == graph.node_defaults && found.edge_defaults == graph.edge_defaults,
               file, "the graph's name or defaults differ");
  requireMeant(found.clusters == graph.clusters, file, "the cells or patches differ");
  requireMeant(found.edges == graph.edges, file, "the links differ");
}

}  // namespace hexoderm
