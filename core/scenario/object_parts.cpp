#include "core/base/translate_noop.h"
#include "core/scenario/fields.h"

#include <array>
#include <span>

namespace berg {

namespace {

constexpr auto kObjectParts = std::to_array<ObjectPart>({
    {"no_fly[]",
     QT_TRANSLATE_NOOP("berg::Fields", "Areas that UAVs stay out of if they start clear of them; "
                                       "with geofence and stand-off ring at "
                                       "most 200 corners at the altitude of a UAV.")},
    {"airspace[]",
     QT_TRANSLATE_NOOP("berg::Fields", "Airspace, for information: a check reports that the "
                                       "operation may enter it, but no UAV is "
                                       "kept out.")},
    {"ice_chart",
     QT_TRANSLATE_NOOP("berg::Fields", "Ice chart for the map, without effect on the flight.")},
    {"ice_chart.areas[]",
     QT_TRANSLATE_NOOP(
         "berg::Fields",
         "Areas of the chart, each with `outlines_m` (needed): outline and holes, each a list of "
         "corners.")},
    {"operation",
     QT_TRANSLATE_NOOP("berg::Fields", "Content of a permit application: constants of the "
                                       "operation volume, and texts for the flight "
                                       "brief.")},
    {"asset", QT_TRANSLATE_NOOP("berg::Fields", "Protected asset.")},
    {"weather", QT_TRANSLATE_NOOP("berg::Fields", "Missing values are not checked.")},
    {"forecast",
     QT_TRANSLATE_NOOP(
         "berg::Fields",
         "Forecast with `source`, `issued` (UTC), `columns` (1) and `places`; needs `start_utc`.")},
    {"forecast.places[]",
     QT_TRANSLATE_NOOP(
         "berg::Fields",
         "Grid of rows from south to north, each from west to east, with `columns` places.")},
    {"forecast.places[].series[]",
     QT_TRANSLATE_NOOP("berg::Fields",
                       "Values at a `time` (UTC; times rise); any may be missing.")},
    {"icebergs[].track",
     QT_TRANSLATE_NOOP(
         "berg::Fields",
         "`{\"time_s\": [...], \"position_m\": [[x, y], ...]}`: true positions, instead of random "
         "drift.")},
});

} // namespace

std::span<const ObjectPart> objectParts()
{
    return kObjectParts;
}

} // namespace berg
