#pragma once

#include "widgets/map/map_picture.h"
#include "widgets/model/flight_record.h"

#include <QLocale>

namespace berg {

/**
 * The map of a mission at its present time: everything flown and recorded, the plan in force, the
 * estimates of the icebergs that have appeared.
 */
[[nodiscard]] MapPicture missionPicture(const FlightRecord& record, const QLocale& locale);

/**
 * End of the sigma scale for map and charts, m^2: round, above every present sigma and above 95 %
 * of those recorded, so that one iceberg that was once very uncertain does not make all others
 * look alike. Cost: linear in the record.
 */
[[nodiscard]] double sigmaScaleEnd_m2(const FlightRecord& record);

} // namespace berg
