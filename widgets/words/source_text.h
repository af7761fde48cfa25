#pragma once

#include "core/tracking/position_error.h"

#include <QLocale>
#include <QString>

namespace berg {

/** Returns the sensor's name for the middle of a sentence: "ship's radar". */
[[nodiscard]] QString sourceName(SightingSource source);

/** Returns the sensor with its accuracy: "ship's radar, 95 % within 367 m". */
[[nodiscard]] QString sourceText(SightingSource source, const QLocale& locale);

} // namespace berg
