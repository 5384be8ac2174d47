#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/units.h"
#include "hexoderm/robots/joint_check.h"
#include "hexoderm/robots/robot_model.h"
#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QAbstractTableModel>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {

/// Where the free joints of a robot stand in the poses of a session, as far as it is known.
struct JointSheet {
  struct Row {
    PoseId pose;
    JointAngles angles;
  };
  std::vector<RobotJoint> joints;  ///< one a column
  std::vector<Row> rows;
};

/// What was typed for one joint in one pose.
struct TypedAngle {
  std::size_t row = 0;  ///< of the sheet
  std::string joint;
  std::optional<double> position;  ///< rad, of a joint that slides m; nothing: not known
};

/// A row for each pose, a column for each joint: degrees, of joints that slide millimetres; empty where it is not
/// known. The table keeps nothing that is typed: it says it by typed(), and shows what setSheet() brings.
class JointTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// The cell that the keyboard is in stays where poses and joints are the same.
  void setSheet(JointSheet sheet) {
    if (!isSameShape(sheet, sheet_)) {
      beginResetModel();
      sheet_ = std::move(sheet);
      endResetModel();
      return;
    }
    sheet_ = std::move(sheet);
    if (rowCount() > 0 && columnCount() > 0) {
      emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
  }

  [[nodiscard]] const JointSheet& sheet() const { return sheet_; }

  /// Takes a block of numbers as spreadsheets put it on the clipboard, its upper left corner at `at`. All of it or,
  /// where a part is no number or does not fit into the table, nothing.
  void paste(const QModelIndex& at, const QString& block) {
    const QList<QStringList> cells = cellsOfBlock(block);
    if (!checkIndex(at, CheckIndexOption::IndexIsValid) || cells.isEmpty()) return;
    const auto widest = std::ranges::max(cells, {}, &QStringList::size).size();
    const int rows = rowCount() - at.row();
    const int columns = columnCount() - at.column();
    if (cells.size() > rows || widest > columns) {
      emit refused(tr("The block has %1 rows and %2 columns, and from here there is room for %3 and %4.")
                       .arg(cells.size())
                       .arg(widest)
                       .arg(rows)
                       .arg(columns));
      return;
    }
    std::vector<TypedAngle> angles;
    for (int row = 0; row < cells.size(); ++row) {
      for (int column = 0; column < cells[row].size(); ++column) {
        if (!read(index(at.row() + row, at.column() + column), cells[row][column], angles)) return;
      }
    }
    if (!angles.empty()) emit typed(angles);
  }

  /// Makes joints unknown.
  void clear(const QModelIndexList& cells) {
    std::vector<TypedAngle> angles;
    for (const QModelIndex& cell : cells) read(cell, {}, angles);
    if (!angles.empty()) emit typed(angles);
  }

  /// The rectangle around these, as a block.
  [[nodiscard]] QString block(const QModelIndexList& cells) const {
    if (cells.isEmpty()) return {};
    const auto [top, bottom] = std::ranges::minmax(cells, {}, &QModelIndex::row);
    const auto [left, right] = std::ranges::minmax(cells, {}, &QModelIndex::column);
    QString text;
    for (int row = top.row(); row <= bottom.row(); ++row) {
      QStringList line;
      for (int column = left.column(); column <= right.column(); ++column) line << textAt(index(row, column));
      text += line.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return text;
  }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(sheet_.rows.size());
  }

  int columnCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(sheet_.joints.size());
  }

  QVariant data(const QModelIndex& index, int role) const override {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const RobotJoint& joint = jointOf(index);
    const std::optional<double> position = positionAt(index);
    const std::optional<Message> beyond = position ? beyondLimits(joint, *position) : std::nullopt;
    constexpr int kDecimals = 2;
    switch (role) {
      case Qt::DisplayRole:
        return position ? figureText(*position / unitOf(joint), kDecimals) : QString();
      case Qt::EditRole:
        return textAt(index);
      case kRawRole:
        return position ? QVariant(*position / unitOf(joint)) : QVariant();
      case Qt::TextAlignmentRole:
        return alignment(true);
      case Qt::DecorationRole:
        return beyond ? QVariant(severityMark(Severity::Warning)) : QVariant();
      case Qt::ToolTipRole:
        return beyond ? words(*beyond) : headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole).toString();
      case Qt::AccessibleTextRole: {
        const QString where = tr("Pose %1, joint %2")
                                  .arg(sheet_.rows[static_cast<std::size_t>(index.row())].pose.value())
                                  .arg(QString::fromStdString(joint.name));
        const QString what = position ? textAt(index) + QLatin1Char(' ') + signOf(joint) : tr("not known");
        QStringList parts{where, what};
        if (beyond) parts << words(*beyond);
        return parts.join(QStringLiteral(", "));
      }
      default:
        return {};
    }
  }

  bool setData(const QModelIndex& index, const QVariant& value, int role) override {
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid)) return false;
    std::vector<TypedAngle> angles;
    if (!read(index, value.toString(), angles)) return false;
    if (!angles.empty()) emit typed(angles);
    return true;
  }

  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation == Qt::Vertical) {
      if (role != Qt::DisplayRole || section < 0 || section >= rowCount()) return {};
      return tr("Pose %1").arg(sheet_.rows[static_cast<std::size_t>(section)].pose.value());
    }
    if (section < 0 || section >= columnCount()) return {};
    const RobotJoint& joint = sheet_.joints[static_cast<std::size_t>(section)];
    const QString name = QString::fromStdString(joint.name);
    switch (role) {
      case Qt::DisplayRole:
        return name + QLatin1Char(' ') + signOf(joint);
      case kNameRole:
        return name;
      case kUnitRole:
        return slides(joint) ? QStringLiteral("mm") : QStringLiteral("deg");
      case Qt::ToolTipRole:
        return joint.limits ? tr("Joint %1, %2").arg(name, limitsText(joint))
                            : tr("Joint %1, without limits").arg(name);
      default:
        return {};
    }
  }

  Qt::ItemFlags flags(const QModelIndex& index) const override {
    return QAbstractTableModel::flags(index) | (index.isValid() ? Qt::ItemIsEditable : Qt::NoItemFlags);
  }

 signals:
  void typed(const std::vector<hexoderm::TypedAngle>& angles);
  /// Why something that was typed or pasted is not taken, one sentence.
  void refused(const QString& why);

 private:
  [[nodiscard]] const RobotJoint& jointOf(const QModelIndex& index) const {
    return sheet_.joints[static_cast<std::size_t>(index.column())];
  }

  [[nodiscard]] std::optional<double> positionAt(const QModelIndex& index) const {
    const auto& positions = sheet_.rows[static_cast<std::size_t>(index.row())].angles.positions;
    const auto found = positions.find(jointOf(index).name);
    return found == positions.end() ? std::nullopt : std::optional(found->second);
  }

  /// With all the digits that were typed.
  [[nodiscard]] QString textAt(const QModelIndex& index) const {
    const std::optional<double> position = positionAt(index);
    if (!position) return {};
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    constexpr int kDigits = 10;
    return locale.toString(*position / unitOf(jointOf(index)), 'g', kDigits);
  }

  /// Appends what a text says of a cell, where that is new; false: it says nothing, and refused() said so.
  bool read(const QModelIndex& index, const QString& text, std::vector<TypedAngle>& angles) {
    // An editor that was left as it was is no edit, whatever digits it does not show.
    if (text == textAt(index)) return true;
    const RobotJoint& joint = jointOf(index);
    const auto row = static_cast<std::size_t>(index.row());
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty() || trimmed == noValue()) {
      if (positionAt(index)) angles.push_back({row, joint.name, std::nullopt});
      return true;
    }
    const std::optional<double> number = numberIn(trimmed, signOf(joint));
    const QString name = QString::fromStdString(joint.name);
    if (!number) {
      emit refused((slides(joint) ? tr("\"%1\" is no number: joint %2 in pose %3 takes millimetres.")
                                  : tr("\"%1\" is no number: joint %2 in pose %3 takes degrees."))
                       .arg(trimmed, name, QString::number(sheet_.rows[row].pose.value())));
      return false;
    }
    const double position = *number * unitOf(joint);
    if (std::abs(position) > kMaxJointPosition) {
      emit refused(tr("%1 is no position of joint %2.").arg(trimmed, name));
      return false;
    }
    angles.push_back({row, joint.name, position});
    return true;
  }

  JointSheet sheet_;

  static bool slides(const RobotJoint& joint) { return joint.type == JointType::Prismatic; }

  static double unitOf(const RobotJoint& joint) { return slides(joint) ? kMillimetre : kDegree; }

  static QString signOf(const RobotJoint& joint) { return slides(joint) ? QStringLiteral("mm") : QStringLiteral("°"); }

  static bool isSameShape(const JointSheet& a, const JointSheet& b) {
    return std::ranges::equal(a.joints, b.joints, {}, &RobotJoint::name, &RobotJoint::name) &&
           std::ranges::equal(a.rows, b.rows, {}, &JointSheet::Row::pose, &JointSheet::Row::pose);
  }

  /// A number as people write it here or as programs do, with or without its unit. No separators of thousands: "1.234"
  /// would be another number in another country.
  static std::optional<double> numberIn(QString text, const QString& unit) {
    text = text.trimmed();
    if (text.endsWith(unit)) text.chop(unit.size());
    text = text.trimmed().replace(QChar(0x2212), QLatin1Char('-'));
    for (QLocale locale : {QLocale(), QLocale::c()}) {
      locale.setNumberOptions(QLocale::RejectGroupSeparator);
      bool is_number = false;
      const double number = locale.toDouble(text, &is_number);
      if (is_number && std::isfinite(number)) return number;
    }
    return std::nullopt;
  }

  static QList<QStringList> cellsOfBlock(const QString& block) {
    QStringList lines = block.split(QLatin1Char('\n'));
    while (!lines.isEmpty() && lines.back().trimmed().isEmpty()) lines.removeLast();
    const QLatin1Char separator(block.contains(QLatin1Char('\t')) ? '\t' : ';');
    QList<QStringList> cells;
    for (QString& line : lines) {
      if (line.endsWith(QLatin1Char('\r'))) line.chop(1);
      cells << line.split(separator);
    }
    return cells;
  }

  static QString limitsText(const RobotJoint& joint) {
    const auto figure = [&](double position) {
      return figureText(position / unitOf(joint), 1) + (slides(joint) ? QStringLiteral(" mm") : QStringLiteral("°"));
    };
    return JointTable::tr("between %1 and %2").arg(figure(joint.limits->lower), figure(joint.limits->upper));
  }
};

}  // namespace hexoderm
