#include "hexoderm/base/limits.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/robots/mesh_input.h"

#include <pugixml.hpp>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

/// Each takes 100 bytes beside its text.
constexpr std::ptrdiff_t kMaxColladaElements = 4'000'000;
/// A controller may be made of another.
constexpr int kMaxColladaControllers = 10;

/// Calls `take` for every word of an element's own text.
template <class Take>
void eachColladaWord(const pugi::xml_node& element, Take take) {
  for (const pugi::xml_node piece : element.children()) {
    if (piece.type() != pugi::node_pcdata && piece.type() != pugi::node_cdata) continue;
    std::string_view text = piece.value();
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) take(word);
  }
}

/// The points of a source: components x, y and z of each lie `stride` numbers apart.
struct ColladaPoints {
  const std::vector<double>* numbers = nullptr;
  std::array<std::uint64_t, 3> first{};
  std::uint64_t stride = 0;
};

class ColladaReader {
 public:
  explicit ColladaReader(MeshBuilder& mesh) : mesh_(mesh) {}

  void read(std::string& bytes) {
    const auto markup = std::ranges::count_if(bytes, [](char c) { return c == '<' || c == '='; });
    if (markup > kMaxColladaElements)
      mesh_.fail(message("has more than {} elements and attributes", kMaxColladaElements));
    // Entities of a document type are not expanded.
    const pugi::xml_parse_result parsed = document_.load_buffer_inplace(bytes.data(), bytes.size());
    if (!parsed)
      mesh_.fail(message("this is not well-formed XML ({}; truncated?), expected COLLADA", parsed.description()));
    const pugi::xml_node root = document_.document_element();
    if (std::string_view(root.name()) != "COLLADA") {
      mesh_.fail(message("expected COLLADA, whose root element is <COLLADA>, found <{}>", excerptOf(root.name())));
    }
    Collector collector(*this);
    document_.traverse(collector);
    for (const auto& [element, index] : node_index_) nodes_[index] = nodeOf(element);

    const pugi::xml_node scene = root.child("scene").child("instance_visual_scene");
    if (!scene) mesh_.fail(message("expected a scene, but it has none"));
    MeshNode in_metres;
    in_metres.T_parent_node.linear() *= unitOf(root);
    in_metres.children.push_back(node_index_.at(target("visual_scene", scene.attribute("url"))));
    nodes_.push_back(std::move(in_metres));
    addScene(mesh_, nodes_, {nodes_.size() - 1},
             [this](std::size_t geometry, MeshBuilder& part) { readGeometry(geometries_[geometry], part); });
  }

 private:
  /// Finds the elements that others refer to, and the nodes of all scenes.
  class Collector : public pugi::xml_tree_walker {
   public:
    explicit Collector(ColladaReader& reader) : reader_(reader) {}
    bool for_each(pugi::xml_node& element) override {
      static const std::set<std::string_view> kReferredTo = {"controller", "float_array", "geometry",    "node",
                                                             "source",     "vertices",    "visual_scene"};
      const std::string_view name = element.name();
      if (!kReferredTo.contains(name)) return true;
      const std::string_view id = element.attribute("id").value();
      if (!id.empty()) reader_.by_id_.try_emplace(std::string(name).append("#").append(id), element);
      if (name != "node" && name != "visual_scene") return true;
      if (reader_.nodes_.size() == kMaxMeshNodes) failTooManyNodes(reader_.mesh_);
      reader_.node_index_.emplace(element, reader_.nodes_.size());
      reader_.nodes_.emplace_back();
      return true;
    }

   private:
    ColladaReader& reader_;
  };

  /// The element of this name that an address such as "#ID" means.
  [[nodiscard]] pugi::xml_node target(const std::string& name, const pugi::xml_attribute& address) const {
    const auto found = by_id_.find(name + address.value());
    if (found == by_id_.end()) {
      mesh_.fail(message("no <{}> in the file has the address \"{}\"", name, excerptOf(address.value())));
    }
    return found->second;
  }

  [[noreturn]] void failNumbers(const pugi::xml_node& element) const {
    mesh_.fail(message("<{}> has too few, too many or malformed numbers", element.name()));
  }
  [[nodiscard]] std::vector<double> numbers(const pugi::xml_node& element) const {
    std::vector<double> values;
    eachColladaWord(element, [&](std::string_view word) {
      const std::optional<double> value = meshNumber(word);
      if (!value) failNumbers(element);
      mesh_.requireFewPoints(values.size() / 3);
      values.push_back(*value);
    });
    return values;
  }
  [[nodiscard]] std::vector<double> numbers(const pugi::xml_node& element, std::size_t count) const {
    std::vector<double> values = numbers(element);
    if (values.size() != count) failNumbers(element);
    return values;
  }
  [[nodiscard]] std::vector<std::uint32_t> indices(const pugi::xml_node& element) const {
    std::vector<std::uint32_t> values;
    eachColladaWord(element, [&](std::string_view word) {
      const std::optional<std::uint32_t> value = meshIndex(word);
      if (!value) failNumbers(element);
      values.push_back(*value);
    });
    return values;
  }
  [[nodiscard]] std::uint64_t attribute(const pugi::xml_node& element, const char* name,
                                        std::uint32_t otherwise) const {
    const pugi::xml_attribute found = element.attribute(name);
    if (!found) return otherwise;
    const std::optional<std::uint32_t> value = meshIndex(found.value());
    if (!value) failNumbers(element);
    return *value;
  }

  [[nodiscard]] double unitOf(const pugi::xml_node& root) const {
    const pugi::xml_node unit = root.child("asset").child("unit");
    const pugi::xml_attribute metres = unit.attribute("meter");
    if (!metres) return 1;
    const std::optional<double> value = meshNumber(metres.value());
    if (!value || !(*value > 0 && *value <= kMaxLength_m)) failNumbers(unit);
    return *value;
  }

  MeshNode nodeOf(const pugi::xml_node& element) {
    MeshNode node;
    for (const pugi::xml_node child : element.children()) {
      const std::string_view name = child.name();
      if (name == "node") {
        node.children.push_back(node_index_.at(child));
      } else if (name == "instance_node") {
        node.children.push_back(node_index_.at(target("node", child.attribute("url"))));
      } else if (name == "instance_geometry") {
        node.parts.push_back(partOf(target("geometry", child.attribute("url"))));
      } else if (name == "instance_controller") {
        node.parts.push_back(partOf(controlledGeometry(child.attribute("url"))));
      } else {
        node.T_parent_node = node.T_parent_node * transformOf(child, name);
      }
    }
    return node;
  }

  std::size_t partOf(const pugi::xml_node& geometry) {
    const auto [part, is_new] = part_index_.try_emplace(geometry, geometries_.size());
    if (is_new) geometries_.push_back(geometry);
    return part->second;
  }

  /// The geometry at an address, or that which a skin or a morph there changes, as it is before.
  pugi::xml_node controlledGeometry(const pugi::xml_attribute& address, int depth = 0) {
    const auto controller = by_id_.find(std::string("controller") + address.value());
    if (controller == by_id_.end()) return target("geometry", address);
    const auto [known, is_new] = controlled_.try_emplace(controller->second);
    if (is_new && depth < kMaxColladaControllers) {
      const pugi::xml_node skin = controller->second.child("skin");
      const pugi::xml_node morph = controller->second.child("morph");
      known->second = controlledGeometry((skin ? skin : morph).attribute("source"), depth + 1);
    }
    if (!known->second) failTooManyNodes(mesh_);
    return known->second;
  }

  /// The identity for an element that is no transformation.
  [[nodiscard]] Eigen::Affine3d transformOf(const pugi::xml_node& element, std::string_view name) const {
    Eigen::Affine3d T = Eigen::Affine3d::Identity();
    if (name == "matrix") {
      const std::vector<double> m = numbers(element, 16);
      T.affine() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(m.data()).topRows<3>();
    } else if (name == "translate") {
      T.translation() = Eigen::Vector3d(numbers(element, 3).data());
    } else if (name == "scale") {
      T.linear() = Eigen::Vector3d(numbers(element, 3).data()).asDiagonal();
    } else if (name == "rotate") {
      const std::vector<double> turn = numbers(element, 4);
      T.linear() = Eigen::AngleAxisd(turn[3] * kDegree, Eigen::Vector3d(turn.data()).normalized()).toRotationMatrix();
    } else if (name == "lookat") {
      const std::vector<double> look = numbers(element, 9);
      const Eigen::Map<const Eigen::Matrix3d> places(look.data());  // the eye, what it looks at, and what is up
      const Eigen::Vector3d back = (places.col(0) - places.col(1)).normalized();
      const Eigen::Vector3d right = places.col(2).cross(back).normalized();
      T.linear() << right, back.cross(right), back;
      T.translation() = places.col(0);
    } else if (name == "skew") {
      mesh_.fail(message("expected nodes without <skew>, which is not read"));
    }
    return T;
  }

  void readGeometry(const pugi::xml_node& geometry, MeshBuilder& part) {
    for (const pugi::xml_node primitive : geometry.child("mesh").children()) {
      const std::string_view kind = primitive.name();
      if (kind == "triangles" || kind == "polylist" || kind == "polygons" || kind == "trifans" || kind == "tristrips") {
        readPrimitive(primitive, kind, part);
      }
    }
  }

  void readPrimitive(const pugi::xml_node& primitive, std::string_view kind, MeshBuilder& part) {
    const ColladaPoints* points = nullptr;
    std::uint64_t offset = 0;
    std::uint64_t stride = 1;
    for (const pugi::xml_node input : primitive.children("input")) {
      const std::string_view semantic = input.attribute("semantic").value();
      const std::uint64_t at = attribute(input, "offset", 0);
      stride = std::max(stride, at + 1);
      if (points != nullptr || (semantic != "VERTEX" && semantic != "POSITION")) continue;
      offset = at;
      points = &pointsOf(input);
    }
    std::vector<std::uint32_t> lengths;  // of the polygons of a polylist
    for (const pugi::xml_node child : primitive.children()) {
      const std::string_view name = child.name();
      if (name == "vcount") lengths = indices(child);
      if (name == "ph") mesh_.fail(message("expected polygons without holes, which are not read"));
      if (name != "p") continue;
      if (points == nullptr) mesh_.fail(message("expected positions in <{}>", primitive.name()));
      const std::vector<std::uint32_t> all = indices(child);
      if (all.size() % stride != 0) failNumbers(child);
      const std::uint64_t corners = all.size() / stride;
      std::uint64_t start = 0;
      const auto corner = [&](std::uint64_t k) { return point(*points, all[(start + k) * stride + offset]); };
      if (kind == "tristrips") {
        part.addStrip(corners, corner);
      } else if (kind == "polylist") {
        for (const std::uint32_t length : std::exchange(lengths, {})) {  // all in one <p>
          if (length > corners - start) failNumbers(primitive);
          part.addFan(length, corner);
          start += length;
        }
        if (start != corners) failNumbers(primitive);
      } else if (kind == "triangles") {
        if (corners % 3 != 0) failNumbers(child);
        for (; start < corners; start += 3) part.addFan(3, corner);
      } else {
        part.addFan(corners, corner);
      }
    }
  }

  /// The points of a source, or of <vertices>, at an input.
  const ColladaPoints& pointsOf(const pugi::xml_node& input) {
    const bool is_of_vertices = std::string_view(input.attribute("semantic").value()) == "VERTEX";
    const pugi::xml_node element = target(is_of_vertices ? "vertices" : "source", input.attribute("source"));
    const auto [known, is_new] = points_.try_emplace(element);
    if (is_new && is_of_vertices) {
      const pugi::xml_node positions = element.find_child_by_attribute("input", "semantic", "POSITION");
      if (!positions) mesh_.fail(message("expected positions in <{}>", element.name()));
      known->second = pointsOf(positions);
    } else if (is_new) {
      known->second = pointsOfSource(element);
    }
    return known->second;
  }

  ColladaPoints pointsOfSource(const pugi::xml_node& source) {
    const pugi::xml_node accessor = source.child("technique_common").child("accessor");
    ColladaPoints points;
    std::uint64_t params = 0;
    std::array<bool, 3> named{};
    for (const pugi::xml_node param : accessor.children("param")) {
      constexpr std::array<std::string_view, 3> kAxes = {"X", "Y", "Z"};
      const auto axis = static_cast<std::size_t>(
          std::ranges::find(kAxes, std::string_view(param.attribute("name").value())) - kAxes.begin());
      if (axis < kAxes.size()) {
        points.first.at(axis) = params;
        named.at(axis) = true;
      }
      ++params;
    }
    if (named != std::array{true, true, true}) points.first = {0, 1, 2};
    points.stride = attribute(accessor, "stride", static_cast<std::uint32_t>(std::max(params, std::uint64_t{3})));
    if (points.stride <= std::ranges::max(points.first)) failNumbers(accessor);
    for (std::uint64_t& first : points.first) first += attribute(accessor, "offset", 0);
    points.numbers = &arrayAt(target("float_array", accessor.attribute("source")));
    return points;
  }

  const std::vector<double>& arrayAt(const pugi::xml_node& array) {
    const auto [known, is_new] = arrays_.try_emplace(array);
    if (is_new) known->second = numbers(array);
    return known->second;
  }

  [[nodiscard]] Eigen::Vector3d point(const ColladaPoints& points, std::uint32_t index) const {
    Eigen::Vector3d point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint64_t at = points.first[axis] + index * points.stride;
      if (at >= points.numbers->size()) mesh_.fail(noSuchPoint(index, points.numbers->size() / points.stride));
      point[static_cast<Eigen::Index>(axis)] = (*points.numbers)[at];
    }
    return point;
  }

  MeshBuilder& mesh_;
  pugi::xml_document document_;
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;  ///< by "NAME#ID"
  std::map<pugi::xml_node, std::size_t> node_index_;
  std::vector<MeshNode> nodes_;
  std::map<pugi::xml_node, std::size_t> part_index_;
  std::vector<pugi::xml_node> geometries_;
  std::map<pugi::xml_node, pugi::xml_node> controlled_;  ///< the geometries of controllers
  std::map<pugi::xml_node, ColladaPoints> points_;
  std::map<pugi::xml_node, std::vector<double>> arrays_;
};

}  // namespace

void readCollada(std::string& bytes, MeshBuilder& mesh) { ColladaReader(mesh).read(bytes); }

}  // namespace hexoderm
