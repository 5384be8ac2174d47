#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/robots/robot_model.h"

#include <QAbstractTableModel>
#include <optional>
#include <string>
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
  void setSheet(JointSheet sheet);
  [[nodiscard]] const JointSheet& sheet() const { return sheet_; }

  /// Takes a block of numbers as spreadsheets put it on the clipboard, its upper left corner at `at`. All of it or,
  /// where a part is no number or does not fit into the table, nothing.
  void paste(const QModelIndex& at, const QString& block);
  /// Makes joints unknown.
  void clear(const QModelIndexList& cells);
  /// The rectangle around these, as a block.
  [[nodiscard]] QString block(const QModelIndexList& cells) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  void typed(const std::vector<hexoderm::TypedAngle>& angles);
  /// Why something that was typed or pasted is not taken, one sentence.
  void refused(const QString& why);

 private:
  [[nodiscard]] const RobotJoint& jointOf(const QModelIndex& index) const;
  [[nodiscard]] std::optional<double> positionAt(const QModelIndex& index) const;
  [[nodiscard]] QString textAt(const QModelIndex& index) const;
  /// Appends what a text says of a cell, where that is new; false: it says nothing, and refused() said so.
  bool read(const QModelIndex& index, const QString& text, std::vector<TypedAngle>& angles);

  JointSheet sheet_;
};

}  // namespace hexoderm
