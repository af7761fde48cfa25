#pragma once

#include "widgets/model/import_preview.h"

#include <QAbstractTableModel>
#include <QLocale>

#include <functional>

class QTableView;

namespace berg {

/** A table to look at: cells are asked for when they are shown. */
struct CellSheet
{
    QStringList titles;
    int rows = 0;
    std::function<QString(int row, int column)> text;
    std::function<QVariant(int row, int column)> sortKey; ///< null: the text
};

/** Shows a sheet; sorted by whatever proxy is put on it. */
class CellModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Role
    {
        SortRole = Qt::UserRole
    };

    using QAbstractTableModel::QAbstractTableModel;

    void setSheet(CellSheet sheet);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    CellSheet m_sheet;
};

using PreviewPointer = std::shared_ptr<const ImportPreview>;

/** What becomes of each iceberg of the file. */
[[nodiscard]] CellSheet icebergSheet(const PreviewPointer& preview, const QLocale& locale);
/** Line, reason and text of what was rejected. */
[[nodiscard]] CellSheet rejectedSheet(const PreviewPointer& preview, const QLocale& locale);
/** The first rows of the file; what a column serves as is below its name. */
[[nodiscard]] CellSheet headSheet(const PreviewPointer& preview);

/** A table for such sheets: sorted by a click, selected rows copied by the usual keys. */
[[nodiscard]] QTableView* newCellTable(CellModel& model, const QString& name,
                                       const QString& accessibleName);

} // namespace berg
