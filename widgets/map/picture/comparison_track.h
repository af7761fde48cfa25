#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/model/compared_run.h"

#include <QLocale>

namespace berg {

/** Lays the tracks of another run over the map, up to `until_s`. */
void addComparison(MapPicture& picture, const ComparedRun& run, double until_s,
                   const QLocale& locale);

} // namespace berg
