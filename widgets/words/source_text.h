#pragma once

#include "core/tracking/position_error.h"

#include <QLocale>
#include <QString>

namespace berg {

/** "ship's radar", in the middle of a sentence. */
[[nodiscard]] QString sourceName(SightingSource source);

/** "ship's radar, 95 % within 367 m". */
[[nodiscard]] QString sourceText(SightingSource source, const QLocale& locale);

} // namespace berg
