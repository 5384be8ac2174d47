#include "app/python/skin_arrays.h"

#include "app/python/given.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/is_rotation.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace hexoderm::python {

namespace py = pybind11;

std::uint32_t idFrom(std::int64_t value, const char* what) {
  if (value >= 0 && value <= UINT32_MAX) return static_cast<std::uint32_t>(value);
  throw InvalidArgument(std::string(what) + ": expected a whole number from 0 to 4294967295, found " +
                        std::to_string(value));
}

NeighborList neighborsFrom(const Numbers& cells, const Numbers& links, const std::vector<std::string>& parts) {
  requireShape(cells, {"cells"}, "cells");
  requireShape(links, {"links", 4}, "links");
  NeighborList neighbors;
  std::map<std::int64_t, std::size_t> index;
  for (py::ssize_t k = 0; k < cells.size(); ++k) {
    const std::int64_t id = cells.data()[k];
    if (!index.emplace(id, neighbors.size()).second) {
      throw InvalidArgument("cells: cell " + std::to_string(id) + " is named twice");
    }
    neighbors.push_back({CellId(idFrom(id, "cells")), "", {}});
  }
  if (!parts.empty() && parts.size() != neighbors.size()) {
    throw InvalidArgument("body_parts: expected one for each of " + std::to_string(neighbors.size()) +
                          " cells, found " + std::to_string(parts.size()));
  }
  for (std::size_t k = 0; k < parts.size(); ++k) neighbors[k].body_part = parts[k];
  for (py::ssize_t k = 0; k < links.shape(0); ++k) {
    const std::int64_t* const link = links.data(k, 0);
    for (const auto& [from, to] : {std::pair(0, 2), std::pair(2, 0)}) {
      const auto found = index.find(link[from]);
      if (found == index.end()) {
        throw InvalidArgument("links: row " + std::to_string(k) + " names cell " + std::to_string(link[from]) +
                              ", which is not among the cells");
      }
      neighbors[found->second].neighbors.push_back({PortNumber(idFrom(link[from + 1], "links")),
                                                    CellId(idFrom(link[to], "links")),
                                                    PortNumber(idFrom(link[to + 1], "links"))});
    }
  }
  for (CellReport& cell : neighbors) std::ranges::stable_sort(cell.neighbors, {}, &NeighborReport::port);
  return neighbors;
}

Numbers linksOf(const Session& session) {
  std::vector<std::array<std::int64_t, 4>> rows;
  std::set<std::array<std::int64_t, 4>> known;
  for (const CellReport& cell : session.neighbors()) {
    for (const NeighborReport& link : cell.neighbors) {
      if (link.cell == CellId()) continue;
      const std::int64_t other = link.cell_port ? static_cast<std::int64_t>(link.cell_port->value()) : -1;
      const std::array<std::int64_t, 4> row = {cell.id.value(), link.port.value(), link.cell.value(), other};
      if (known.contains({row[2], row[3], row[0], row[1]})) continue;
      if (known.insert(row).second) rows.push_back(row);
    }
  }
  Numbers array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{4}});
  std::int64_t* out = array.mutable_data();
  for (const auto& row : rows) out = std::ranges::copy(row, out).out;
  return array;
}

GroundTruth truthFrom(const py::object& truth, const NeighborList& skin) {
  const char* const expected = "(cells, positions, rotations), as Session.truth has it";
  if (!py::isinstance<py::sequence>(truth) || py::len(truth) != 3) failFor("truth", expected, truth);
  const auto parts = py::reinterpret_borrow<py::sequence>(truth);
  const Numbers cells = wholeNumbers(parts[0], "truth[0]");
  const auto positions = Doubles::ensure(parts[1]);
  const auto rotations = Doubles::ensure(parts[2]);
  if (!positions || !rotations) failFor("truth", expected, truth);
  requireShape(cells, {"cells"}, "truth[0]");
  const Axis each("cells", cells.size());
  requireShape(positions, {each, 3}, "truth[1]");
  requireShape(rotations, {each, 3, 3}, "truth[2]");
  GroundTruth known;
  std::set<CellId> named;
  for (py::ssize_t k = 0; k < cells.size(); ++k) {
    TrueCellPlacement placed;
    placed.id = CellId(idFrom(cells.data()[k], "truth[0]"));
    placed.T_b_u.t = Eigen::Map<const Eigen::Vector3d>(positions.data(k, 0));
    placed.T_b_u.R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotations.data(k, 0, 0));
    const std::string place = "[" + std::to_string(k) + "]";
    if (std::ranges::find(skin, placed.id, &CellReport::id) == skin.end() || !named.insert(placed.id).second) {
      throw InvalidArgument("truth[0]" + place + ": expected each cell of the session once, found cell " +
                            toString(placed.id));
    }
    if (!placed.T_b_u.t.allFinite()) throw InvalidArgument("truth[1]" + place + ": expected finite numbers");
    if (!isRotation(placed.T_b_u.R)) {
      throw InvalidArgument("truth[2]" + place + ": expected a rotation matrix (orthogonal to 1e-6, determinant +1)");
    }
    known.cells.push_back(placed);
  }
  return known;
}

py::object truthOf(const Session& session) {
  if (!session.truth()) return py::none();
  const auto& cells = session.truth()->cells;
  return py::make_tuple(numbersOf(cells, &TrueCellPlacement::id),
                        stacked(cells, [](const TrueCellPlacement& cell) { return cell.T_b_u.t; }),
                        stacked(cells, [](const TrueCellPlacement& cell) { return cell.T_b_u.R; }));
}

}  // namespace hexoderm::python
