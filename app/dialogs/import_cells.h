#pragma once

#include "widgets/sightings/import_preview.h"
#include "widgets/tables/cell_model.h"

#include <QLocale>

class QTableView;

namespace berg {

using PreviewPointer = std::shared_ptr<const ImportPreview>;

/** Returns a table of the icebergs of the file and their outcome. */
[[nodiscard]] CellSheet icebergSheet(const PreviewPointer& preview, const QLocale& locale);
/** Returns line, reason and text of the rows in one list of the result. */
[[nodiscard]] CellSheet rowSheet(const PreviewPointer& preview, Rejections ImportResult::*list,
                                 const QLocale& locale);
/** Returns the first rows of the file; below each column name is the field it is used for. */
[[nodiscard]] CellSheet headSheet(const PreviewPointer& preview);

/** Returns a table view of such a sheet: a click sorts, the copy keys copy the selected rows. */
[[nodiscard]] QTableView* newCellTable(CellModel& model, const QString& name,
                                       const QString& accessibleName);

} // namespace berg
