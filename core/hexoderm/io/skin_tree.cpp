#include "hexoderm/io/skin_tree.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/result/quality_colors.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace hexoderm {
namespace {

constexpr const char* kMaterialPrefix = "hexoderm_";

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// A user's text as part of a name: what URDF does not take becomes one underscore.
std::string sanitised(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (isNameCharacter(c)) {
      name += c;
    } else if (!name.ends_with('_')) {
      name += '_';
    }
  }
  return name.empty() ? "sensor" : name;
}

/// Gives each name once; a second one of the same spelling gets a number.
class Names {
 public:
  explicit Names(std::vector<std::string> links) : taken_(links.begin(), links.end()), links_(taken_) {}

  /// The name of a patch or a cell, which no link of the robot may have.
  std::string ofOwnLink(const std::string& wanted) {
    if (links_.contains(wanted)) {
      throw InvalidArgument("parent_link", message("\"{}\" is also the name of a link of the skin", wanted));
    }
    return unique(wanted);
  }
  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int k = 2; !taken_.insert(name).second; ++k) name = wanted + "_" + std::to_string(k);
    return name;
  }

 private:
  std::set<std::string> taken_;
  std::set<std::string> links_;
};

}  // namespace

SkinTree skinTree(const CellModel& model, const std::vector<ExportMount>& mounted, const Reconstruction& reconstruction,
                  const ExportOptions& options) {
  const auto quality = worstUsedQuality(reconstruction);
  SkinTree tree;
  tree.model = options.model_name;
  tree.side_m = model.side_m;
  tree.thickness_m = model.thickness_m;
  tree.side_angle_rad = model.side_angle_rad;
  for (const ExportMount& mount : mounted) {
    if (std::ranges::find(tree.links, mount.link) == tree.links.end()) tree.links.push_back(mount.link);
  }
  if (tree.links.empty()) tree.links.push_back(options.parent_link);

  Names names(tree.links);
  for (const ExportMount& mount : mounted) {
    SkinTreePatch& patch = tree.patches.emplace_back();
    patch.name = names.ofOwnLink(options.prefix + "patch" + toString(mount.patch->id));
    patch.link = mount.link;
    patch.T_l_o = rigid(mount.T_l_o);
    patch.placed = mount.placed;
    patch.origin = mount.patch->origin;
    for (const CellPlacement& placement : mount.patch->cells) {
      SkinTreeCell& cell = patch.cells.emplace_back();
      cell.cell = placement.cell;
      cell.name = names.ofOwnLink(options.prefix + "cell" + toString(placement.cell));
      const auto found = quality.find(placement.cell);
      cell.material = kMaterialPrefix + std::string(found == quality.end() ? "no_link" : qualityName(found->second));
      cell.T_o_u = rigid(placement.T_o_u);
      for (const SensorPlacement& sensor : placement.sensors) {
        cell.sensors.push_back(
            {names.unique(cell.name + "_" + sanitised(sensor.name)), sensor.type, rigid(sensor.T_o_s)});
      }
    }
  }
  return tree;
}

std::vector<SkinFrame> skinFrames(const SkinTree& tree, bool cells) {
  std::vector<SkinFrame> frames;
  for (const SkinTreePatch& patch : tree.patches) {
    frames.push_back({patch.name, patch.link, patch.T_l_o});
    if (!cells) continue;
    for (const SkinTreeCell& cell : patch.cells) {
      frames.push_back({cell.name, patch.name, cell.T_o_u});
      const SE3 T_u_o = cell.T_o_u.inverse();
      for (const SkinTreeSensor& sensor : cell.sensors) {
        frames.push_back({sensor.name, cell.name, T_u_o * sensor.T_o_s});
      }
    }
  }
  return frames;
}

CellBoxes cellBoxes(const SkinTree& tree) {
  CellBoxes boxes;
  boxes.size_m = {std::sqrt(3.0) * tree.side_m, tree.side_m, tree.thickness_m};
  for (std::size_t k = 0; k < boxes.T_u_box.size(); ++k) {
    // A corner lies at the side angle, the middles of the sides 30 degrees on from the corners.
    const double angle_rad = tree.side_angle_rad + (30.0 + 60.0 * static_cast<double>(k)) * kDegree;
    boxes.T_u_box[k] = {expSO3(angle_rad * Eigen::Vector3d::UnitZ()), {0, 0, -tree.thickness_m / 2}};
  }
  return boxes;
}

std::string boxName(const SkinTreeCell& cell, std::size_t box) { return cell.name + "_" + std::to_string(box + 1); }

std::vector<SkinMaterial> skinMaterials() {
  std::vector<SkinMaterial> list;
  for (const EdgeQuality quality :
       {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully, EdgeQuality::Over}) {
    list.push_back({kMaterialPrefix + std::string(qualityName(quality)), qualityColor(quality, Background::Light)});
  }
  list.push_back({kMaterialPrefix + std::string("no_link"), unusedColor(Background::Light)});
  return list;
}

std::string rgbText(std::uint32_t rgb) {
  return inARow(
      std::array{16U, 8U, 0U}, [&](unsigned shift) { return formatFixed(((rgb >> shift) & 0xFFU) / 255.0, 4); }, " ");
}
std::string rgbaText(std::uint32_t rgb) { return rgbText(rgb) + " 1"; }

std::string vectorText(const Eigen::Vector3d& v) {
  const Eigen::Vector3d w = v.array() + 0.0;  // no "-0"
  return formatExact(w.x()) + " " + formatExact(w.y()) + " " + formatExact(w.z());
}

Eigen::Quaterniond quaternionOf(const Eigen::Matrix3d& R) {
  Eigen::Quaterniond q(R);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return q.normalized();
}

bool isLinkName(std::string_view name) {
  return !name.empty() && name.front() != '/' &&
         std::ranges::all_of(name, [](char c) { return isNameCharacter(c) || c == '-' || c == '.' || c == '/'; });
}

}  // namespace hexoderm
