#include "hexoderm/base/text.h"
#include "hexoderm/robots/mesh_input.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

/// No header has more lines; each is an element or a property.
constexpr int kMaxPlyHeaderLines = 10'000;
constexpr int kPlyStripEnd = -1;

template <class Number>
double readPlyNumber(MeshBytes& in) {
  return static_cast<double>(in.number<Number>());
}

struct PlyType {
  std::string_view name;
  std::string_view other_name;
  std::size_t size;
  double (*read)(MeshBytes&);
};
constexpr std::array<PlyType, 8> kPlyTypes = {{{"char", "int8", 1, readPlyNumber<std::int8_t>},
                                               {"uchar", "uint8", 1, readPlyNumber<std::uint8_t>},
                                               {"short", "int16", 2, readPlyNumber<std::int16_t>},
                                               {"ushort", "uint16", 2, readPlyNumber<std::uint16_t>},
                                               {"int", "int32", 4, readPlyNumber<std::int32_t>},
                                               {"uint", "uint32", 4, readPlyNumber<std::uint32_t>},
                                               {"float", "float32", 4, readPlyNumber<float>},
                                               {"double", "float64", 8, readPlyNumber<double>}}};

struct PlyProperty {
  std::string name;
  const PlyType* type;
  const PlyType* count;  ///< of a list; null for a single number
};
struct PlyElement {
  std::string name;
  std::uint32_t count;
  std::vector<PlyProperty> properties;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, MeshBuilder& mesh) : text_(bytes, mesh), mesh_(mesh) {}

  void read() {
    readHeader();
    for (const PlyElement& element : elements_) {
      if (element.name == "vertex") {
        readPoints(element);
      } else if (!element.properties.empty()) {  // otherwise rows of no bytes, and there may be billions
        if (element.count > MeshBuilder::kMaxOfAKind) {
          mesh_.failTooMany(element.count, message("rows of the element \"{}\"", excerptOf(element.name)));
        }
        readLists(element);
      }
    }
  }

 private:
  void readHeader() {
    std::string_view format;
    for (int line = 0; line < kMaxPlyHeaderLines; ++line) {
      const std::string_view keyword = text_.wordInLine();
      if (keyword == "format") {
        format = text_.wordInLine();
      } else if (keyword == "element") {
        const std::string_view name = text_.wordInLine();
        const std::string_view count = text_.wordInLine();
        const std::optional<std::uint32_t> number = meshIndex(count);
        if (!number) text_.failAt(count, message("a whole number"));
        elements_.push_back({std::string(name), *number, {}});
      } else if (keyword == "property" && !elements_.empty()) {
        const std::string_view word = text_.wordInLine();
        const PlyType* count = word == "list" ? typeOf(text_.wordInLine()) : nullptr;
        const PlyType* type = typeOf(count != nullptr ? text_.wordInLine() : word);
        elements_.back().properties.push_back({std::string(text_.wordInLine()), type, count});
      } else if (keyword == "end_header") {
        text_.nextLine();
        return beginBody(format);
      }
      if (!text_.nextLine()) failTruncated(mesh_);
    }
    text_.fail(message("expected the end of the header, end_header"));
  }

  const PlyType* typeOf(std::string_view name) const {
    for (const PlyType& type : kPlyTypes) {
      if (name == type.name || name == type.other_name) return &type;
    }
    text_.failAt(name, message("a number type"));
  }

  void beginBody(std::string_view format) {
    if (format == "ascii") return;
    const bool is_big = format == "binary_big_endian";
    if (!is_big && format != "binary_little_endian") {
      mesh_.fail(message("expected {}, found \"{}\"",
                         message("PLY of ascii, binary_little_endian or binary_big_endian"), excerptOf(format)));
    }
    bytes_.emplace(text_.rest(), mesh_, is_big ? std::endian::big : std::endian::little);
  }

  double number(const PlyType& type) { return bytes_ ? type.read(*bytes_) : text_.number(); }

  /// A list's length, or an index.
  std::int64_t wholeNumber(const PlyType& type, double min = 0) {
    const double value = number(type);
    if (!(value >= min && value <= UINT32_MAX) || value != std::floor(value)) {
      mesh_.fail(message("expected {}, found \"{}\"", message("a whole number"), formatExact(value)));
    }
    return static_cast<std::int64_t>(value);
  }

  /// How many numbers follow; a single one is a list of one.
  std::uint64_t lengthOf(const PlyProperty& property) {
    return property.count != nullptr ? static_cast<std::uint64_t>(wholeNumber(*property.count)) : 1;
  }
  void skip(const PlyProperty& property) {
    const std::uint64_t count = lengthOf(property);
    if (bytes_) {
      bytes_->take(count * property.type->size);
    } else {
      for (std::uint64_t k = 0; k < count; ++k) text_.number();
    }
  }

  void readPoints(const PlyElement& element) {
    constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
    for (const std::string_view axis : kAxes) {
      const auto isAxis = [&](const PlyProperty& property) {
        return property.name == axis && property.count == nullptr;
      };
      if (std::ranges::none_of(element.properties, isAxis)) {
        mesh_.fail(message("expected the properties x, y and z of each vertex"));
      }
    }
    mesh_.requireFewPoints(points_.size() + element.count);
    for (std::uint32_t k = 0; k < element.count; ++k) {
      Eigen::Vector3d& point = points_.emplace_back();
      for (const PlyProperty& property : element.properties) {
        const auto axis = std::ranges::find(kAxes, property.name) - kAxes.begin();
        if (axis < 3 && property.count == nullptr) {
          point[axis] = number(*property.type);
        } else {
          skip(property);
        }
      }
    }
  }

  void readLists(const PlyElement& element) {
    const bool are_strips = element.name == "tristrips";
    for (std::uint32_t k = 0; k < element.count; ++k) {
      for (const PlyProperty& property : element.properties) {
        const bool is_of_points = property.name == "vertex_indices" || property.name == "vertex_index";
        if (!is_of_points || (!are_strips && element.name != "face")) {
          skip(property);
          continue;
        }
        readCorners(property, are_strips);
        if (are_strips) {
          addStrip();
        } else {
          mesh_.addFan(corners_.size(), [&](std::size_t corner) { return points_[corners_[corner]]; });
        }
      }
    }
  }

  /// Into corners_, without the strips that end on the way.
  void readCorners(const PlyProperty& property, bool are_strips) {
    corners_.clear();
    const std::uint64_t count = lengthOf(property);
    mesh_.requireFewCorners(count);
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::int64_t corner = wholeNumber(*property.type, are_strips ? kPlyStripEnd : 0);
      if (corner == kPlyStripEnd) {
        addStrip();
        continue;
      }
      if (static_cast<std::size_t>(corner) >= points_.size()) mesh_.fail(noSuchPoint(corner, points_.size()));
      corners_.push_back(static_cast<std::size_t>(corner));
    }
  }

  void addStrip() {
    mesh_.addStrip(corners_.size(), [&](std::size_t corner) { return points_[corners_[corner]]; });
    corners_.clear();
  }

  MeshText text_;
  MeshBuilder& mesh_;
  std::optional<MeshBytes> bytes_;  ///< of a binary file, behind the header
  std::vector<PlyElement> elements_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::size_t> corners_;
};

}  // namespace

void readPly(std::string_view bytes, MeshBuilder& mesh) { PlyReader(bytes, mesh).read(); }

}  // namespace hexoderm
