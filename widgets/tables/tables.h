#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <QAbstractTableModel>
#include <memory>

namespace hexoderm {

/// Base of the item models: all show one Reconstruction and have the one entrance.
class ReconstructionTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reconstruction() const { return reconstruction_; }

 protected:
  /// Called between beginResetModel and endResetModel.
  virtual void rebuild() = 0;

 private:
  std::shared_ptr<const Reconstruction> reconstruction_;
};

/// Pose | Label | Cells | Noise mg | New by | Residual. Row k is Reconstruction::poses[k]; disabled poses are greyed
/// and their mark says so.
class PoseTable : public ReconstructionTable {
  Q_OBJECT

 public:
  using ReconstructionTable::ReconstructionTable;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 protected:
  void rebuild() override {}
};

/// Link | Quality | Residual | Predicted | Bend | Twist | Yaw | State, one row a link, muted ones included.
class LinkTable : public ReconstructionTable {
  Q_OBJECT

 public:
  using ReconstructionTable::ReconstructionTable;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  [[nodiscard]] const LinkEstimate& linkAt(int row) const;
  [[nodiscard]] int rowOf(LinkEnd source, LinkEnd target) const;  ///< -1 if there is none

 protected:
  void rebuild() override;

 private:
  std::vector<std::pair<std::size_t, std::size_t>> rows_;  ///< patch, link
};

/// Severity | What | Where, worst first.
class FindingTable : public ReconstructionTable {
  Q_OBJECT

 public:
  using ReconstructionTable::ReconstructionTable;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  [[nodiscard]] const Finding& findingAt(int row) const;

 protected:
  void rebuild() override;

 private:
  std::vector<std::size_t> rows_;
};

}  // namespace hexoderm
