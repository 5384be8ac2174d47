#include "hexoderm/robots/joint_angles_csv.h"

#include "hexoderm/base/csv.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/spelling_suggestion.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace hexoderm {
namespace {

constexpr std::size_t kMaxRows = 1'000'000;
constexpr std::size_t kMaxColumns = 10'000;
constexpr std::size_t kMaxNumbers = 20'000'000;  // rows times columns, of 50 bytes each in memory

/// A unit as columns name it.
struct ColumnUnit {
  std::string_view name;
  double factor;  ///< to rad, m or s
  enum class Of { Angle, Length, Time } of;
};
constexpr std::array<ColumnUnit, 11> kColumnUnits = {{{"rad", 1, ColumnUnit::Of::Angle},
                                                      {"radians", 1, ColumnUnit::Of::Angle},
                                                      {"deg", kDegree, ColumnUnit::Of::Angle},
                                                      {"degrees", kDegree, ColumnUnit::Of::Angle},
                                                      {"°", kDegree, ColumnUnit::Of::Angle},
                                                      {"m", 1, ColumnUnit::Of::Length},
                                                      {"mm", kMillimetre, ColumnUnit::Of::Length},
                                                      {"s", 1, ColumnUnit::Of::Time},
                                                      {"ms", 1e-3, ColumnUnit::Of::Time},
                                                      {"us", 1e-6, ColumnUnit::Of::Time},
                                                      {"ns", 1e-9, ColumnUnit::Of::Time}}};

const ColumnUnit* unitNamed(std::string_view name) {
  const auto found = std::ranges::find(kColumnUnits, name, &ColumnUnit::name);
  return found == kColumnUnits.end() ? nullptr : &*found;
}

/// A column's title taken apart: "elbow[deg]", "elbow (deg)", "elbow_deg".
struct ColumnTitle {
  std::string name;
  std::string unit;  ///< empty: not said
};

std::optional<ColumnTitle> titleInBrackets(std::string_view title) {
  for (const std::string_view brackets : {"[]", "()"}) {
    const std::size_t open = title.rfind(brackets[0]);
    if (!title.ends_with(brackets[1]) || open == std::string_view::npos || open == 0) continue;
    return ColumnTitle{std::string(trimmed(title.substr(0, open))),
                       std::string(trimmed(title.substr(open + 1, title.size() - open - 2)))};
  }
  return std::nullopt;
}

std::optional<ColumnTitle> titleWithSuffix(std::string_view title) {
  const std::size_t underscore = title.rfind('_');
  if (underscore == std::string_view::npos || underscore == 0) return std::nullopt;
  const std::string_view unit = title.substr(underscore + 1);
  if (unitNamed(unit) == nullptr) return std::nullopt;
  return ColumnTitle{std::string(title.substr(0, underscore)), std::string(unit)};
}

enum class RowKey { Pose, Time };

class JointAnglesReader {
 public:
  JointAnglesReader(std::string_view text, const std::string& file, const RobotModel& robot,
                    JointAnglesCsvOptions options)
      : rest_(text), file_(file), robot_(robot), options_(options) {}

  JointAnglesTable read() {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
    readHeader();
    JointAnglesTable table;
    while (nextLine()) {
      table.rows.push_back(readRow());
      if (table.rows.size() > kMaxRows || table.rows.size() * columns_.size() > kMaxNumbers) {
        fail(message("the table is too large"));
      }
    }
    if (table.rows.empty()) throw FormatError(file_, message("expected a line for each pose, but there is none"));
    return table;
  }

 private:
  struct Column {
    std::string title;
    std::optional<std::size_t> joint;  ///< none: the key
    double factor = 1;
  };

  [[noreturn]] void fail(Message what) const {
    throw FormatError(file_, located(message("line {}", line_number_), std::move(what)));
  }
  [[noreturn]] void failIn(std::string_view column, Message what) const {
    fail(located(message("column {}", excerptOf(column)), std::move(what)));
  }

  /// The next line that holds something; what stands behind "# unit:" is kept.
  bool nextLine() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      line_ = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++line_number_;
      if (line_.starts_with('#')) {
        readComment(trimmed(line_.substr(1)));
      } else if (!line_.empty()) {
        return true;
      }
    }
    return false;
  }

  void readComment(std::string_view comment) {
    for (const std::string_view word : {"units:", "unit:"}) {
      if (!comment.starts_with(word)) continue;
      const std::string_view name = trimmed(comment.substr(word.size()));
      const ColumnUnit* unit = unitNamed(name);
      if (unit == nullptr || unit->of != ColumnUnit::Of::Angle) {
        fail(message("expected the unit of the angles, deg or rad, found {}", excerptOf(name)));
      }
      if (!columns_.empty()) fail(message("expected the unit above the line with the names of the joints"));
      angle_unit_ = unit;
    }
  }

  std::vector<std::string> fields() const {
    std::optional<std::vector<std::string>> result = csvFields(line_, separator_);
    if (!result) fail(message("expected fields separated by commas; a quote is not closed"));
    for (std::string& field : *result) field = std::string(trimmed(field));
    return std::move(*result);
  }

  void readHeader() {
    if (!nextLine()) throw FormatError(file_, message("is empty; expected a line with the names of the joints"));
    for (const char separator : {',', ';', '\t'}) {
      if (line_.find(separator) == std::string_view::npos) continue;
      separator_ = separator;
      break;
    }
    const std::vector<std::string> titles = fields();
    if (titles.size() > kMaxColumns) fail(message("there are more than {} columns", kMaxColumns));
    std::set<std::string> seen;
    for (const std::string& title : titles) {
      Column column = columnOf(title);
      const std::string name = column.joint ? robot_.joints()[*column.joint].name : "";
      if (!seen.insert(name).second) {
        failIn(title, column.joint ? message("joint {} has a column already", name)
                                   : message("expected one column pose or time, this is a second one"));
      }
      columns_.push_back(std::move(column));
    }
    if (!seen.contains("")) fail(message("expected a column pose (the poses' numbers) or time (s since 1970, UTC)"));
    requireAllJoints(seen);
  }

  void requireAllJoints(const std::set<std::string>& seen) const {
    if (options_.missing_are_zero) return;
    std::vector<std::string> missing;
    for (const std::string& name : robot_.freeJointNames()) {
      if (!seen.contains(name)) missing.push_back(name);
    }
    if (missing.empty()) return;
    constexpr std::size_t kMaxNamed = 10;
    const Message what = missing.size() <= kMaxNamed ? message("these joints of the robot have no column: {}", missing)
                                                     : message("{} joints of the robot have no column, {} among them",
                                                               missing.size(), missing[0]);
    fail(inRow({what, message("expected one for each joint that can move (0 where it did not)")}, "; "));
  }

  /// A title may be just a joint's name, even one that ends like a unit; or a joint's name and a unit.
  Column columnOf(const std::string& title) {
    if (title.empty()) fail(message("expected the name of a joint above every column"));
    ColumnTitle parts{title, ""};
    if (!robot_.findJoint(title)) {
      if (auto bracketed = titleInBrackets(title)) {
        parts = std::move(*bracketed);
      } else if (auto with_suffix = titleWithSuffix(title)) {
        parts = std::move(*with_suffix);
      }
    }
    if (!robot_.findJoint(parts.name)) {
      if (parts.name == "pose") return keyColumn(title, RowKey::Pose, 1);
      if (parts.name == "time")
        return keyColumn(title, RowKey::Time, factorOf(title, parts.unit, ColumnUnit::Of::Time));
    }
    Column column{title, jointOf(title, parts.name), 1};
    const RobotJoint& joint = robot_.joints()[*column.joint];
    const bool slides = joint.type == JointType::Prismatic;
    column.factor = factorOf(title, parts.unit, slides ? ColumnUnit::Of::Length : ColumnUnit::Of::Angle);
    return column;
  }

  Column keyColumn(const std::string& title, RowKey key, double factor) {
    key_ = key;
    return {title, std::nullopt, factor};
  }

  std::size_t jointOf(const std::string& title, const std::string& name) const {
    const std::optional<std::size_t> joint = robot_.findJoint(name);
    if (joint && robot_.joints()[*joint].type != JointType::Fixed) return *joint;
    if (joint) failIn(title, message("this joint of the robot is fixed and has no angle"));
    std::vector<std::string> names{"pose", "time"};
    for (const RobotJoint& known : robot_.joints()) names.push_back(known.name);
    const std::optional<std::string> meant = spellingSuggestion(name, names);
    failIn(title, inRow({message("the robot {} has no joint {}", robot_.name(), excerptOf(name)),
                         meant ? message("did you mean {}?", *meant)
                               : message("columns of anything else have to be taken out")},
                        "; "));
  }

  double factorOf(const std::string& title, const std::string& name, ColumnUnit::Of of) const {
    if (!name.empty()) {
      const ColumnUnit* unit = unitNamed(name);
      if (unit != nullptr && unit->of == of) return unit->factor;
      failIn(title, of == ColumnUnit::Of::Angle ? message("expected the unit deg or rad, found {}", excerptOf(name))
                    : of == ColumnUnit::Of::Length
                        ? message("expected the unit m or mm, found {}", excerptOf(name))
                        : message("expected the unit s, ms, us or ns, found {}", excerptOf(name)));
    }
    if (of == ColumnUnit::Of::Time) return 1;
    if (of == ColumnUnit::Of::Length) failIn(title, message("expected the unit in the title, as in lift[m]"));
    if (angle_unit_ == nullptr) {
      failIn(title, message("expected the unit in the title, as in {}[deg] or {}[rad], or a first line \"# unit: deg\"",
                            excerptOf(title), excerptOf(title)));
    }
    return angle_unit_->factor;
  }

  JointAnglesRow readRow() {
    const std::vector<std::string> texts = fields();
    if (texts.size() != columns_.size()) {
      fail(message("expected {} columns as in the first line, found {}", columns_.size(), texts.size()));
    }
    JointAnglesRow row;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const Column& column = columns_[k];
      if (column.joint) {
        const double position = column.factor * numberIn(column, texts[k]);
        if (std::abs(position) > kMaxJointPosition) failIn(column.title, message("{} is no joint's angle", texts[k]));
        row.angles.positions[robot_.joints()[*column.joint].name] = position;
      } else if (key_ == RowKey::Pose) {
        row.pose = poseIn(column, texts[k]);
      } else {
        row.time_s = timeIn(column, texts[k]);
      }
    }
    return row;
  }

  template <class Parse>
  auto parsed(const Column& column, const std::string& text, Parse parse) const {
    try {
      return parse(text, std::string("\"") + excerptOf(column.title) + "\"");
    } catch (const InvalidArgument&) {
      failIn(column.title, text.empty() ? message("expected a number, but there is none")
                                        : message("expected a number, found {}", excerptOf(text)));
    }
  }
  double numberIn(const Column& column, std::string text) const {
    // Programs that separate columns otherwise may write 1,5 for one and a half.
    if (separator_ != ',' && std::ranges::count(text, ',') == 1 && text.find('.') == std::string::npos) {
      std::ranges::replace(text, ',', '.');
    }
    return parsed(column, text, parseNumber);
  }

  PoseId poseIn(const Column& column, const std::string& text) {
    const PoseId pose(parsed(column, text, parseUnsigned));
    const auto [earlier, is_first] = line_of_pose_.emplace(pose, line_number_);
    if (!is_first) failIn(column.title, message("pose {} was given already, in line {}", pose, earlier->second));
    return pose;
  }

  double timeIn(const Column& column, const std::string& text) {
    const double time_s = column.factor * numberIn(column, text);
    if (!(time_s > last_time_s_)) failIn(column.title, message("expected times that ascend; {} does not", text));
    last_time_s_ = time_s;
    return time_s;
  }

  std::string_view rest_;
  const std::string& file_;
  const RobotModel& robot_;
  JointAnglesCsvOptions options_;
  std::string_view line_;
  std::size_t line_number_ = 0;
  char separator_ = ',';
  const ColumnUnit* angle_unit_ = nullptr;
  RowKey key_ = RowKey::Pose;
  std::vector<Column> columns_;
  std::map<PoseId, std::size_t> line_of_pose_;
  double last_time_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<JointAngles> JointAnglesTable::of(PoseId pose, std::optional<std::int64_t> taken_at_ms,
                                                double within_s) const {
  const JointAnglesRow* best = nullptr;
  double best_s = within_s;
  for (const JointAnglesRow& row : rows) {
    if (row.pose == pose) return row.angles;
    if (!row.time_s || !taken_at_ms) continue;
    const double away_s = std::abs(*row.time_s - 1e-3 * static_cast<double>(*taken_at_ms));
    if (away_s > best_s) continue;
    best_s = away_s;
    best = &row;
  }
  return best == nullptr ? std::nullopt : std::optional(best->angles);
}

JointAnglesTable readJointAnglesCsv(const std::filesystem::path& path, const RobotModel& robot,
                                    JointAnglesCsvOptions options) {
  return parseJointAnglesCsv(readFile(path), path.string(), robot, options);
}

JointAnglesTable parseJointAnglesCsv(std::string_view text, const std::string& file, const RobotModel& robot,
                                     JointAnglesCsvOptions options) {
  return JointAnglesReader(text, file, robot, options).read();
}

std::string jointAnglesCsv(const JointAnglesTable& table, const RobotModel& robot) {
  if (table.rows.empty()) throw InvalidArgument("expected joint angles of at least one pose");
  const JointAngles& first = table.rows.front().angles;
  const bool by_pose = table.rows.front().pose.has_value();
  std::string text = by_pose ? "pose" : "time[s]";
  for (const auto& [name, position] : first.positions) {
    const RobotJoint& joint = robot.joints()[robot.jointNamed(name)];
    text += ',' + csvQuoted(name + (joint.type == JointType::Prismatic ? "[m]" : "[rad]"));
  }
  text += '\n';
  for (const JointAnglesRow& row : table.rows) {
    const auto same_name = [](const auto& a, const auto& b) { return a.first == b.first; };
    if (row.pose.has_value() != by_pose || row.time_s.has_value() == by_pose ||
        !std::ranges::equal(row.angles.positions, first.positions, same_name)) {
      throw InvalidArgument("expected rows with the same key and the same joints");
    }
    text += by_pose ? toString(*row.pose) : formatExact(*row.time_s);
    for (const auto& [name, position] : row.angles.positions) text += ',' + formatExact(position);
    text += '\n';
  }
  return text;
}

}  // namespace hexoderm
