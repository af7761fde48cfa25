#pragma once

#include "core/base/issue.h"

#include <QLocale>
#include <QString>

namespace berg {

/** What the window calls the field of a finding, by its path in the file; unknown ones as there. */
[[nodiscard]] QString fieldName(const std::string& field);

/** A number of that field, in SI, in the unit that the window shows it in. */
[[nodiscard]] QString fieldValue(const std::string& field, const IssueArgument& value,
                                 const QLocale& locale);

} // namespace berg
