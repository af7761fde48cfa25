#include "widgets/theme/unit_settings.h"

#include <atomic>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

std::atomic<Units> unitsInUse{Units()};

} // namespace

Units shownUnits()
{
    return unitsInUse.load();
}

void setShownUnits(const Units& units)
{
    unitsInUse.store(units);
}

Units readUnits(const QSettings& settings)
{
    Units units;
    if (settings.value(kDistanceUnitKey).toString() == u"nautical"_s)
        units.distance = DistanceUnit::Nautical;
    if (settings.value(kSpeedUnitKey).toString() == u"knots"_s)
        units.speed = SpeedUnit::Knots;
    const QString form = settings.value(kCoordinateFormKey).toString();
    if (form == u"decimal"_s)
        units.coordinates = CoordinateForm::DecimalDegrees;
    else if (form == u"seconds"_s)
        units.coordinates = CoordinateForm::DegreesMinutesSeconds;
    return units;
}

} // namespace berg
