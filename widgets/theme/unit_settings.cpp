#include "widgets/theme/unit_settings.h"

#include <atomic>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

std::atomic<Units> unitsInUse{Units{}};
// Any thread reads the units, many times per frame.
static_assert(decltype(unitsInUse)::is_always_lock_free);

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
    if (settings.value(kVectorFormKey).toString() == u"components"_s)
        units.vectors = VectorForm::Components;
    if (settings.value(kHeightUnitKey).toString() == u"feet"_s)
        units.height = HeightUnit::Feet;
    const QString north = settings.value(kNorthFormKey).toString();
    if (north == u"model"_s)
        units.north = NorthForm::Model;
    else if (north == u"typed"_s)
        units.north = NorthForm::Typed;
    if (settings.value(kTimeFormKey).toString() == u"elapsed"_s)
        units.times = TimeForm::Elapsed;
    if (settings.value(kUncertaintyFormKey).toString() == u"radius"_s)
        units.uncertainty = UncertaintyForm::Radius95;
    return units;
}

} // namespace berg
