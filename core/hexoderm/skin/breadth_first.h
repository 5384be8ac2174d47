#pragma once

// Private: breadth-first searches by the Boost Graph Library that can refuse edges, end early, and be repeated.

#include <boost/graph/breadth_first_search.hpp>

#include <cstddef>
#include <vector>

namespace hexoderm {

/// Searches of one graph. A vertex that was reached once is not reached again before forget(), so that a graph can be
/// searched part by part.
template <class Graph>
class BreadthFirst {
 public:
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Edge = typename boost::graph_traits<Graph>::edge_descriptor;

  explicit BreadthFirst(const Graph& graph) : graph_(graph), color_(num_vertices(graph), boost::white_color) {}

  /// `start` and the vertices that are reached from it, in the order in which they are reached; valid until the next
  /// search. `along(edge)` is called for each edge to a vertex that is not reached yet; if it returns false, the search
  /// does not go along this edge.
  template <class Along>
  const std::vector<Vertex>& searchFrom(Vertex start, const Along& along) {
    reached_.clear();
    next_ = 0;
    is_accepted_ = true;
    Visitor<Along> visitor(*this, along);
    boost::breadth_first_visit(graph_, start, *this, visitor, colors());
    return reached_;
  }
  const std::vector<Vertex>& searchFrom(Vertex start) {
    return searchFrom(start, [](const Edge& /*edge*/) { return true; });
  }

  /// To be called by `along`: the search ends with this vertex.
  void end() { next_ = kEnd; }

  [[nodiscard]] bool isReached(Vertex vertex) const { return get(colors(), vertex) != boost::white_color; }
  /// What the last search reached can be reached again.
  void forget() {
    for (const Vertex vertex : reached_) put(colors(), vertex, boost::white_color);
  }

  // The buffer of breadth_first_visit(). It keeps what has been taken out of it, and drops what was refused.
  [[nodiscard]] bool empty() const { return next_ >= reached_.size(); }
  [[nodiscard]] Vertex top() const { return reached_[next_]; }
  void pop() { ++next_; }
  void push(Vertex vertex) {
    if (is_accepted_) {
      reached_.push_back(vertex);
    } else {
      put(colors(), vertex, boost::white_color);
    }
  }

 private:
  static constexpr std::size_t kEnd = static_cast<std::size_t>(-1);

  template <class Along>
  struct Visitor : boost::default_bfs_visitor {
    BreadthFirst& search;
    const Along& along;

    Visitor(BreadthFirst& of, const Along& by) : search(of), along(by) {}
    void tree_edge(const Edge& edge, const Graph& /*graph*/) {
      search.is_accepted_ = search.next_ != kEnd && along(edge);
    }
  };

  [[nodiscard]] auto colors() const {
    return boost::make_iterator_property_map(color_.begin(), get(boost::vertex_index, graph_));
  }
  [[nodiscard]] auto colors() {
    return boost::make_iterator_property_map(color_.begin(), get(boost::vertex_index, graph_));
  }

  const Graph& graph_;
  std::vector<boost::default_color_type> color_;
  std::vector<Vertex> reached_;
  std::size_t next_ = 0;  ///< in reached_
  bool is_accepted_ = true;
};

}  // namespace hexoderm
