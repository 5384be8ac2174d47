#pragma once

#include "hexoderm/skin/skin_graph.h"
#include "tests/benchmarks/cpu_time.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace hexoderm {

/// All pairs by the Boost Graph Library: from every vertex of a small skin, and from some of a large one, times how
/// many there are.
inline double boostAllPairs_ms(const SkinGraph& skin, const std::vector<double>& weights) {
  using Property = boost::property<boost::edge_weight_t, double>;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Property>;
  Graph graph(skin.cells().size());
  for (std::size_t k = 0; k < skin.links().size(); ++k) {
    const GraphLink& link = skin.links()[k];
    if (link.muted()) continue;
    boost::add_edge(link.source, link.target, Property(weights[k]), graph);
    boost::add_edge(link.target, link.source, Property(weights[k]), graph);
  }
  const std::size_t cells = skin.cells().size();
  const std::size_t step = std::max<std::size_t>(1, cells / 1000);
  std::vector<double> distance(cells);
  double sum = 0;
  std::size_t sources = 0;
  const double before = cpuTime_ms();
  for (std::size_t source = 0; source < cells; source += step, ++sources) {
    boost::dijkstra_shortest_paths_no_color_map(graph, source,
                                                boost::distance_map(boost::make_iterator_property_map(
                                                    distance.begin(), boost::get(boost::vertex_index, graph))));
    sum += distance.back();
  }
  const double took = cpuTime_ms() - before;
  if (sum == 0) std::abort();  // so that nothing is left out as unused
  return took * static_cast<double>(cells) / static_cast<double>(sources);
}

}  // namespace hexoderm
