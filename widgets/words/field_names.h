#pragma once

#include "core/base/issue.h"

#include <QLocale>
#include <QString>

namespace berg {

/** Returns the translation of the English words of a row of `fieldsOf`. */
[[nodiscard]] QString fieldWords(const char* english);

/** Returns the window's label of a finding's field by its path in the file; empty if it has none.
 */
[[nodiscard]] QString fieldName(const std::string& field);

/** Returns a value of that field, or of its own quantity, in the unit that the window uses. */
[[nodiscard]] QString fieldValue(const std::string& field, const IssueArgument& value,
                                 const QLocale& locale);

} // namespace berg
