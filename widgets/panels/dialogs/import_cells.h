#pragma once

#include "widgets/model/cell_model.h"
#include "widgets/model/import_preview.h"

#include <QLocale>

class QTableView;

namespace berg {

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
