#include "hexoderm/io/export_transforms.h"

#include "hexoderm/io/export_support.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"

#include <array>
#include <pugixml.hpp>
#include <set>
#include <sstream>

namespace hexoderm {
namespace {

/// x y z qx qy qz qw, as TF's programs take them.
std::array<double, 7> transformNumbers(const SE3& T) {
  const Eigen::Quaterniond q = quaternionOf(T.R);
  std::array<double, 7> numbers = {T.t.x(), T.t.y(), T.t.z(), q.x(), q.y(), q.z(), q.w()};
  for (double& number : numbers) number += 0.0;  // no "-0"
  return numbers;
}

/// The names of nodes in ROS have letters, digits and underscores only; no two are the same.
class NodeNames {
 public:
  std::string of(const std::string& frame) {
    std::string name = "static_tf_";
    for (const char c : frame) name += (c == '-' || c == '.' || c == '/') ? '_' : c;
    std::string unique = name;
    for (int k = 2; !taken_.insert(unique).second; ++k) unique = name + "_" + std::to_string(k);
    return unique;
  }

 private:
  std::set<std::string> taken_;
};

/// YAML 1.1 takes "1e-05" as a text: a number with an exponent needs a point, and one without looks whole.
std::string yamlNumber(double value) {
  std::string text = formatExact(value);
  if (text.find('.') != std::string::npos) return text;
  const std::size_t exponent = text.find('e');
  return exponent == std::string::npos ? text + ".0" : text.insert(exponent, ".0");
}

double readNumber(std::string_view text, const std::string& file) {
  try {
    return parseNumber(text, "number");
  } catch (const InvalidArgument& error) {
    throw FormatError(file + ": " + error.what());
  }
}

/// The next frame that was read is the next one that was meant.
class FrameCheck {
 public:
  FrameCheck(const std::vector<SkinFrame>& frames, const std::string& file) : frames_(frames), file_(file) {}

  void add(const std::string& parent, const std::string& name, const std::array<double, 7>& n) {
    requireMeant(next_ < frames_.size(), file_, "expected no further frame than those of the skin, found " + name);
    const SkinFrame& meant = frames_[next_++];
    requireMeant(meant.name == name && meant.parent == parent, file_,
                 "expected frame " + meant.name + " in " + meant.parent + ", found " + name + " in " + parent);
    const SE3 found{Eigen::Quaterniond(n[6], n[3], n[4], n[5]).toRotationMatrix(), {n[0], n[1], n[2]}};
    requireMeant(near(found, meant.T_parent_frame), file_, "frame " + name + " is elsewhere");
  }
  void finish() const { requireMeant(next_ == frames_.size(), file_, "frames are missing"); }

 private:
  const std::vector<SkinFrame>& frames_;
  const std::string& file_;
  std::size_t next_ = 0;
};

/// The texts between double quotes in a line.
std::vector<std::string> quotedTexts(const std::string& line) {
  const std::vector<std::string> parts = split(line, '"');
  std::vector<std::string> texts;
  for (std::size_t k = 1; k < parts.size(); k += 2) texts.push_back(parts[k]);
  return texts;
}

/// The number after `key` in a line such as "translation: {x: 1.0, y: 2.0}".
double numberAfter(const std::string& line, const std::string& key, const std::string& file) {
  const std::size_t at = line.find(key);
  requireMeant(at != std::string::npos, file, "expected " + key + " in \"" + line + "\"");
  const std::size_t begin = at + key.size();
  return readNumber(line.substr(begin, line.find_first_of(",}", begin) - begin), file);
}

}  // namespace

std::string rosLaunchText(const std::vector<SkinFrame>& frames) {
  pugi::xml_document document;
  pugi::xml_node launch = document.append_child("launch");
  launch.append_child(pugi::node_comment)
      .set_value(
          " Metres; x y z qx qy qz qw parent child. A node for each frame: of many cells, one link per patch, or "
          "the list of transforms in YAML, starts faster. ");
  NodeNames names;
  for (const SkinFrame& frame : frames) {
    std::string args;
    for (const double number : transformNumbers(frame.T_parent_frame)) args += formatExact(number) + " ";
    pugi::xml_node node = launch.append_child("node");
    node.append_attribute("pkg") = "tf2_ros";
    node.append_attribute("type") = "static_transform_publisher";
    node.append_attribute("name") = names.of(frame.name).c_str();
    node.append_attribute("args") = (args + frame.parent + " " + frame.name).c_str();
  }
  std::ostringstream out;
  document.save(out, "  ");
  return std::move(out).str();
}

void verifyRosLaunch(std::string_view bytes, const std::vector<SkinFrame>& frames, const std::string& file) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
  if (!parsed) throw FormatError(file + ": cannot be read back as XML: " + parsed.description());
  FrameCheck check(frames, file);
  std::set<std::string> names;
  for (const pugi::xml_node node : document.child("launch").children("node")) {
    const std::vector<std::string> words = split(node.attribute("args").value(), ' ');
    requireMeant(words.size() == 9, file, "expected nine words in args");
    requireMeant(names.insert(node.attribute("name").value()).second, file, "a node's name is there twice");
    std::array<double, 7> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = readNumber(words[k], file);
    check.add(words[7], words[8], numbers);
  }
  check.finish();
}

std::string ros2LaunchText(const std::vector<SkinFrame>& frames) {
  std::string text =
      "# Static transforms of the skin, metres.\n"
      "from launch import LaunchDescription\n"
      "from launch_ros.actions import Node\n"
      "\n"
      "TRANSFORMS = [\n"
      "    # node, x, y, z, qx, qy, qz, qw, frame, child frame\n";
  NodeNames names;
  for (const SkinFrame& frame : frames) {
    text += "    (\"" + names.of(frame.name) + "\"";
    for (const double number : transformNumbers(frame.T_parent_frame)) text += ", \"" + formatExact(number) + "\"";
    text += ", \"" + frame.parent + "\", \"" + frame.name + "\"),\n";
  }
  return text +
         "]\n"
         "OPTIONS = [\"--x\", \"--y\", \"--z\", \"--qx\", \"--qy\", \"--qz\", \"--qw\", \"--frame-id\", "
         "\"--child-frame-id\"]\n"
         "\n"
         "\n"
         "def generate_launch_description():\n"
         "    return LaunchDescription([\n"
         "        Node(\n"
         "            package=\"tf2_ros\",\n"
         "            executable=\"static_transform_publisher\",\n"
         "            name=name,\n"
         "            arguments=[word for pair in zip(OPTIONS, values) for word in pair],\n"
         "        )\n"
         "        for name, *values in TRANSFORMS\n"
         "    ])\n";
}

void verifyRos2Launch(std::string_view bytes, const std::vector<SkinFrame>& frames, const std::string& file) {
  FrameCheck check(frames, file);
  for (const std::string& line : split(bytes, '\n')) {
    if (!line.starts_with("    (\"")) continue;
    const std::vector<std::string> words = quotedTexts(line);
    requireMeant(words.size() == 10, file, "expected ten texts in a row");
    std::array<double, 7> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = readNumber(words[k + 1], file);
    check.add(words[8], words[9], numbers);
  }
  check.finish();
  requireMeant(bytes.ends_with("for name, *values in TRANSFORMS\n    ])\n"), file, "its end is missing");
}

std::string transformsYaml(const std::vector<SkinFrame>& frames) {
  std::string text = "# geometry_msgs/TransformStamped of each frame of the skin, metres.\n";
  if (frames.empty()) return text + "[]\n";
  for (const SkinFrame& frame : frames) {
    const std::array<double, 7> n = transformNumbers(frame.T_parent_frame);
    text += "- header:\n    stamp: {sec: 0, nanosec: 0}\n    frame_id: \"" + frame.parent + "\"\n  child_frame_id: \"" +
            frame.name + "\"\n  transform:\n    translation: {x: " + yamlNumber(n[0]) + ", y: " + yamlNumber(n[1]) +
            ", z: " + yamlNumber(n[2]) + "}\n    rotation: {x: " + yamlNumber(n[3]) + ", y: " + yamlNumber(n[4]) +
            ", z: " + yamlNumber(n[5]) + ", w: " + yamlNumber(n[6]) + "}\n";
  }
  return text;
}

void verifyTransformsYaml(std::string_view bytes, const std::vector<SkinFrame>& frames, const std::string& file) {
  FrameCheck check(frames, file);
  std::string parent;
  std::string name;
  std::array<double, 7> n{};
  const auto textIn = [&](const std::string& line) {
    const std::vector<std::string> texts = quotedTexts(line);
    requireMeant(texts.size() == 1, file, "expected one text in \"" + line + "\"");
    return texts[0];
  };
  for (const std::string& line : split(bytes, '\n')) {
    if (line.starts_with("    frame_id: ")) parent = textIn(line);
    if (line.starts_with("  child_frame_id: ")) name = textIn(line);
    if (line.starts_with("    translation: ")) {
      n[0] = numberAfter(line, "{x: ", file);
      n[1] = numberAfter(line, ", y: ", file);
      n[2] = numberAfter(line, ", z: ", file);
    }
    if (!line.starts_with("    rotation: ")) continue;
    n[3] = numberAfter(line, "{x: ", file);
    n[4] = numberAfter(line, ", y: ", file);
    n[5] = numberAfter(line, ", z: ", file);
    n[6] = numberAfter(line, ", w: ", file);
    check.add(parent, name, n);
  }
  check.finish();
}

}  // namespace hexoderm
