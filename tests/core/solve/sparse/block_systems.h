#pragma once

// Graphs, and random systems of equations on them, with blocks of 6 x 6.

#include "hexoderm/solve/sparse/block_cholesky.h"
#include "tests/support/testing.h"

#include <numeric>
#include <ostream>

namespace hexoderm {

using Couples = std::vector<BlockCouple>;

/// Relative to the largest element.
MATCHER_P2(MatrixNear, expected, tolerance, "") {
  if (arg.rows() != expected.rows() || arg.cols() != expected.cols()) {
    *result_listener << arg.rows() << " x " << arg.cols();
    return false;
  }
  if (arg.size() == 0) return true;
  const double error = (arg - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
  *result_listener << "off by " << error;
  return arg.allFinite() && error <= tolerance;
}

struct Graph {
  std::string name;
  std::size_t size = 0;
  Couples couples;
};

inline void PrintTo(const Graph& graph, std::ostream* out) { *out << graph.name << " of " << graph.size; }

inline Graph chain(std::size_t size) {
  Graph graph{"Chain", size, {}};
  for (std::size_t k = 1; k < size; ++k) graph.couples.push_back({k - 1, k});
  return graph;
}

inline Graph ring(std::size_t size) {
  Graph graph = chain(size);
  graph.name = "Ring";
  graph.couples.push_back({0, size - 1});
  return graph;
}

/// `closed`: the rows are rings.
inline Graph lattice(std::size_t width, std::size_t height, bool closed = false) {
  Graph graph{closed ? "Tube" : "Lattice", width * height, {}};
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t cell = y * width + x;
      if (x + 1 < width) graph.couples.push_back({cell, cell + 1});
      if (closed && x + 1 == width) graph.couples.push_back({cell, y * width});
      if (y + 1 < height) graph.couples.push_back({cell + width, cell});
    }
  }
  return graph;
}

inline Graph randomGraph(std::size_t size, std::size_t couples, unsigned seed) {
  Graph graph{"Random" + std::to_string(couples), size, {}};
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = a + 1; b < size; ++b) graph.couples.push_back({a, b});
  }
  std::mt19937 random(seed);
  std::shuffle(graph.couples.begin(), graph.couples.end(), random);
  graph.couples.resize(std::min(couples, graph.couples.size()));
  return graph;
}

/// The first cells of a ring are all joined to each other.
inline Graph cliqueInARing(std::size_t joined, std::size_t size) {
  Graph graph = ring(size);
  graph.name = "CliqueInARing";
  for (std::size_t a = 0; a < joined; ++a) {
    for (std::size_t b = a + 2; b < joined; ++b) graph.couples.push_back({a, b});
  }
  return graph;
}

/// Two lattices, a chain and two cells alone.
inline Graph parts() {
  Graph graph{"Parts", 0, {}};
  for (const Graph& part : {lattice(4, 3), chain(1), chain(7), lattice(2, 5), chain(1)}) {
    for (const BlockCouple& c : part.couples) graph.couples.push_back({c.row + graph.size, c.column + graph.size});
    graph.size += part.size;
  }
  return graph;
}

/// Cells named at random, couples either way round.
inline Graph shuffled(Graph graph, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::size_t> name(graph.size);
  std::iota(name.begin(), name.end(), std::size_t{0});
  std::shuffle(name.begin(), name.end(), random);
  for (BlockCouple& c : graph.couples) {
    c = {name[c.row], name[c.column]};
    if (random() % 2 == 0) std::swap(c.row, c.column);
  }
  std::shuffle(graph.couples.begin(), graph.couples.end(), random);
  return graph;
}

/// A random positive definite matrix: a sum of squares per couple, as of a residual between two cells.
struct System {
  System(const Graph& of, unsigned seed) : graph(of), diagonal(of.size, 0.1 * Matrix6d::Identity()) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (const BlockCouple& c : graph.couples) {
      const Matrix6d J = Matrix6d::NullaryExpr([&] { return normal(random); });
      const Matrix6d K = Matrix6d::NullaryExpr([&] { return normal(random); });
      diagonal[c.row] += J.transpose() * J;
      diagonal[c.column] += K.transpose() * K;
      couples.push_back(J.transpose() * K);
    }
  }

  [[nodiscard]] Eigen::MatrixXd dense() const {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6 * graph.size, 6 * graph.size);
    for (std::size_t k = 0; k < graph.size; ++k) A.block<6, 6>(6 * k, 6 * k) = diagonal[k];
    for (std::size_t k = 0; k < couples.size(); ++k) {
      const BlockCouple& c = graph.couples[k];
      A.block<6, 6>(6 * c.row, 6 * c.column) = couples[k];
      A.block<6, 6>(6 * c.column, 6 * c.row) = couples[k].transpose();
    }
    return A;
  }

  [[nodiscard]] Eigen::MatrixXd times(const Eigen::MatrixXd& X) const {
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(X.rows(), X.cols());
    for (std::size_t k = 0; k < graph.size; ++k) B.middleRows<6>(6 * k) += diagonal[k] * X.middleRows<6>(6 * k);
    for (std::size_t k = 0; k < couples.size(); ++k) {
      const BlockCouple& c = graph.couples[k];
      B.middleRows<6>(6 * c.row) += couples[k] * X.middleRows<6>(6 * c.column);
      B.middleRows<6>(6 * c.column) += couples[k].transpose() * X.middleRows<6>(6 * c.row);
    }
    return B;
  }

  Graph graph;
  std::vector<Matrix6d> diagonal;
  std::vector<Matrix6d> couples;
};

inline Eigen::MatrixXd someColumns(const System& system, Eigen::Index count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(6 * system.graph.size, count, [&] { return uniform(random); });
}

}  // namespace hexoderm
