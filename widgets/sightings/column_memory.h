#pragma once

#include "core/io/import/fields/import_table.h"

#include <QString>
#include <QStringList>

#include <vector>

class QSettings;

namespace berg {

/** Column mapping used for an imported table, identified by its header. */
struct RememberedColumns
{
    QString fingerprint;
    QStringList header;
    ColumnMapping mapping;
};

/**
 * Returns the key of a header. Headers have the same key if their names and order are equal,
 * ignoring case and surrounding blanks.
 */
[[nodiscard]] QString headerFingerprint(const QStringList& header);

/** Returns all remembered mappings, latest first. */
[[nodiscard]] std::vector<RememberedColumns> rememberedColumns(const QSettings& settings);
/** Returns the mapping remembered for this header, or an empty one. */
[[nodiscard]] ColumnMapping columnsFor(const QSettings& settings, const QStringList& header);

/** Stores the mapping for the next table with this header; only the fifty latest are stored. */
void rememberColumns(QSettings& settings, const QStringList& header, const ColumnMapping& mapping);
/** Removes the mapping with this fingerprint. */
void forgetColumns(QSettings& settings, const QString& fingerprint);

} // namespace berg
