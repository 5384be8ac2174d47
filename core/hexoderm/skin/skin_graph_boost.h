#pragma once

// Private: SkinGraph, and one patch of it, as graphs of the Boost Graph Library. Boost types stay out of the headers
// that programs include. Nothing is copied: a vertex is the index of a cell, an edge is a link as it leaves one of its
// cells, and muted links are no edges.

#include "hexoderm/skin/skin_graph.h"

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace hexoderm {

/// A link as it leaves the cell `from`; the same link from its other end is the same edge.
struct SkinEdge {
  std::size_t link = 0;
  std::size_t from = 0;
  friend bool operator==(const SkinEdge& a, const SkinEdge& b) { return a.link == b.link; }
};

/// One patch of a graph: its cells, indexed by their place in it, and their links.
struct PatchGraph {
  const SkinGraph* graph = nullptr;
  std::size_t patch = 0;

  [[nodiscard]] const std::vector<std::size_t>& cells() const { return graph->patches()[patch]; }
};

namespace boost_graph {

struct IsUsed {
  const GraphLink* links = nullptr;
  bool operator()(std::size_t link) const { return !links[link].muted(); }
};
struct EdgeFrom {
  std::size_t from = 0;
  SkinEdge operator()(std::size_t link) const { return {link, from}; }
};
struct EdgeFromSource {
  const GraphLink* links = nullptr;
  SkinEdge operator()(std::size_t link) const { return {link, links[link].source}; }
};
using OutEdges =
    boost::transform_iterator<EdgeFrom, boost::filter_iterator<IsUsed, std::span<const std::size_t>::iterator>>;
using Edges =
    boost::transform_iterator<EdgeFromSource, boost::filter_iterator<IsUsed, boost::counting_iterator<std::size_t>>>;

/// What both graphs have in common.
struct Traits {
  using vertex_descriptor = std::size_t;
  using edge_descriptor = SkinEdge;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  struct traversal_category : boost::incidence_graph_tag, boost::vertex_list_graph_tag, boost::edge_list_graph_tag {};
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using out_edge_iterator = OutEdges;
  using in_edge_iterator = OutEdges;  // boost::filtered_graph names it; the edges are undirected
  using edge_iterator = Edges;
  static vertex_descriptor null_vertex() { return static_cast<std::size_t>(-1); }
};

}  // namespace boost_graph
}  // namespace hexoderm

template <>
struct boost::graph_traits<hexoderm::SkinGraph> : hexoderm::boost_graph::Traits {
  using vertex_iterator = boost::counting_iterator<std::size_t>;
};
template <>
struct boost::graph_traits<hexoderm::PatchGraph> : hexoderm::boost_graph::Traits {
  struct traversal_category : boost::incidence_graph_tag, boost::vertex_list_graph_tag {};
  using vertex_iterator = std::vector<std::size_t>::const_iterator;
};
// Some visitors of the library ask for the traits of the type that they are passed, which is const.
template <>
struct boost::graph_traits<const hexoderm::SkinGraph> : boost::graph_traits<hexoderm::SkinGraph> {};
template <>
struct boost::graph_traits<const hexoderm::PatchGraph> : boost::graph_traits<hexoderm::PatchGraph> {};

namespace hexoderm {

inline std::size_t source(const SkinEdge& edge, const SkinGraph& /*graph*/) { return edge.from; }
inline std::size_t target(const SkinEdge& edge, const SkinGraph& graph) {
  return graph.links()[edge.link].other(edge.from);
}
inline std::pair<boost_graph::OutEdges, boost_graph::OutEdges> out_edges(std::size_t cell, const SkinGraph& graph) {
  const boost_graph::IsUsed used{graph.links().data()};
  const std::span<const std::size_t> at = graph.linksAt(cell);
  return {{{used, at.begin(), at.end()}, {cell}}, {{used, at.end(), at.end()}, {cell}}};
}
inline std::size_t out_degree(std::size_t cell, const SkinGraph& graph) {
  const auto [begin, end] = out_edges(cell, graph);
  return static_cast<std::size_t>(std::distance(begin, end));
}
inline auto vertices(const SkinGraph& graph) {
  using Vertices = boost::counting_iterator<std::size_t>;
  return std::pair(Vertices(0), Vertices(graph.cells().size()));
}
inline std::size_t num_vertices(const SkinGraph& graph) { return graph.cells().size(); }
inline std::pair<boost_graph::Edges, boost_graph::Edges> edges(const SkinGraph& graph) {
  const boost_graph::IsUsed used{graph.links().data()};
  const boost::counting_iterator<std::size_t> begin(0);
  const boost::counting_iterator<std::size_t> end(graph.links().size());
  return {{{used, begin, end}, {used.links}}, {{used, end, end}, {used.links}}};
}
inline std::size_t num_edges(const SkinGraph& graph) {
  const auto [begin, end] = edges(graph);
  return static_cast<std::size_t>(std::distance(begin, end));
}
inline boost::typed_identity_property_map<std::size_t> get(boost::vertex_index_t /*tag*/, const SkinGraph& /*graph*/) {
  return {};
}
inline std::size_t get(boost::vertex_index_t /*tag*/, const SkinGraph& /*graph*/, std::size_t cell) { return cell; }

inline std::size_t source(const SkinEdge& edge, const PatchGraph& /*view*/) { return edge.from; }
inline std::size_t target(const SkinEdge& edge, const PatchGraph& view) { return target(edge, *view.graph); }
inline auto out_edges(std::size_t cell, const PatchGraph& view) { return out_edges(cell, *view.graph); }
inline std::size_t out_degree(std::size_t cell, const PatchGraph& view) { return out_degree(cell, *view.graph); }
inline auto vertices(const PatchGraph& view) { return std::pair(view.cells().begin(), view.cells().end()); }
inline std::size_t num_vertices(const PatchGraph& view) { return view.cells().size(); }

/// The place of a cell in its patch.
struct PlaceInPatch : boost::put_get_helper<std::size_t, PlaceInPatch> {
  using category = boost::readable_property_map_tag;
  using key_type = std::size_t;
  using value_type = std::size_t;
  using reference = std::size_t;

  const GraphCell* cells = nullptr;

  explicit PlaceInPatch(const SkinGraph& graph) : cells(graph.cells().data()) {}
  std::size_t operator[](std::size_t cell) const { return cells[cell].place; }
};
inline PlaceInPatch get(boost::vertex_index_t /*tag*/, const PatchGraph& view) { return PlaceInPatch(*view.graph); }
inline std::size_t get(boost::vertex_index_t tag, const PatchGraph& view, std::size_t cell) {
  return get(tag, view)[cell];
}

/// One value for each link of a graph, as a property map of edges.
template <class Iterator>
struct PerLink : boost::put_get_helper<typename std::iterator_traits<Iterator>::reference, PerLink<Iterator>> {
  using category = boost::lvalue_property_map_tag;
  using key_type = SkinEdge;
  using value_type = typename std::iterator_traits<Iterator>::value_type;
  using reference = typename std::iterator_traits<Iterator>::reference;

  Iterator values;

  explicit PerLink(Iterator first) : values(first) {}
  reference operator[](const SkinEdge& edge) const { return values[static_cast<std::ptrdiff_t>(edge.link)]; }
};

}  // namespace hexoderm

template <>
struct boost::property_map<hexoderm::SkinGraph, boost::vertex_index_t> {
  using type = boost::typed_identity_property_map<std::size_t>;
  using const_type = type;
};
template <>
struct boost::property_map<hexoderm::PatchGraph, boost::vertex_index_t> {
  using type = hexoderm::PlaceInPatch;
  using const_type = type;
};
