#include "hexoderm/device/skinwire/description.h"

#include "hexoderm/base/error.h"
#include "hexoderm/device/skinwire/codec.h"

#include <algorithm>
#include <iterator>

namespace hexoderm::skinwire {

Hello helloOf(const SkinDescription& skin, double rate_hz, std::uint32_t stream) {
  const std::vector<std::string> names = builtInCellModelNames();
  const std::string json = cellModelToJson(*skin.model);
  const bool is_built_in = std::ranges::find(names, skin.model->name) != names.end() &&
                           cellModelToJson(builtInCellModel(skin.model->name)) == json;
  return {kMinor,
          skin.device.english(),
          is_built_in ? skin.model->name : json,
          skin.can_light_cells,
          skin.can_turn,
          rate_hz,
          stream};
}

CellModel cellModelOf(const Hello& hello) {
  const std::size_t first = hello.cell_model.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && hello.cell_model[first] == '{')
    return cellModelFromJson(hello.cell_model, "the device's cell model");
  return builtInCellModel(hello.cell_model);
}

std::vector<Topology> topologyParts(const NeighborList& cells, std::uint32_t id, std::size_t max_body) {
  std::vector<Topology> parts;
  // Both numbers of every part are assumed as large as they can get; then no cell changes place at the end.
  const auto sizeOf = [&](const NeighborList& some) {
    return encodeBody(Topology{id, UINT16_MAX, UINT16_MAX + 1U, some}).size();
  };
  const std::size_t empty = sizeOf({});
  std::size_t size = empty;
  parts.push_back({id, 0, 1, {}});
  for (const CellReport& cell : cells) {
    const std::size_t own = sizeOf({cell}) - empty;
    if (empty + own > max_body) {
      throw InvalidArgument("cell " + toString(cell.id) + " of a topology takes " + std::to_string(own) +
                            " bytes, a message may have " + std::to_string(max_body));
    }
    if (size + own > max_body) {
      parts.push_back({id, static_cast<std::uint32_t>(parts.size()), 1, {}});
      size = empty;
    }
    parts.back().cells.push_back(cell);
    size += own;
  }
  for (Topology& part : parts) part.parts = static_cast<std::uint32_t>(parts.size());
  return parts;
}

void TopologyAssembler::clear() {
  parts_.clear();
  cell_count_ = 0;
}

std::optional<NeighborList> TopologyAssembler::add(Topology part) {
  if (part.id != id_ || part.parts != part_count_) {
    clear();
    id_ = part.id;
    part_count_ = part.parts;
  }
  const std::size_t cells = part.cells.size();
  if (cell_count_ + cells > kMaxCells) {
    clear();
    return std::nullopt;
  }
  if (!parts_.try_emplace(part.part, std::move(part.cells)).second) return std::nullopt;
  cell_count_ += cells;
  if (parts_.size() < part_count_) return std::nullopt;
  NeighborList whole;
  whole.reserve(cell_count_);
  for (auto& [number, some] : parts_) std::move(some.begin(), some.end(), std::back_inserter(whole));
  clear();
  return whole;
}

}  // namespace hexoderm::skinwire
