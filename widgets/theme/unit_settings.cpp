#include "widgets/theme/unit_settings.h"

#include <atomic>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

// A byte for each choice: the whole is too large for an atomic without a lock.
constexpr std::uint32_t kByte = 8;
constexpr std::uint32_t kOne = 0xff;

template <class Enum>
constexpr std::uint32_t packed(Enum value, std::uint32_t place)
{
    return static_cast<std::uint32_t>(value) << (place * kByte);
}

template <class Enum>
constexpr Enum unpacked(std::uint32_t all, std::uint32_t place)
{
    return static_cast<Enum>((all >> (place * kByte)) & kOne);
}

std::atomic<std::uint32_t> unitsInUse{0}; // the defaults

} // namespace

Units shownUnits()
{
    const std::uint32_t all = unitsInUse.load();
    return {.distance = unpacked<DistanceUnit>(all, 0),
            .speed = unpacked<SpeedUnit>(all, 1),
            .coordinates = unpacked<CoordinateForm>(all, 2),
            .vectors = unpacked<VectorForm>(all, 3)};
}

void setShownUnits(const Units& units)
{
    unitsInUse.store(packed(units.distance, 0) | packed(units.speed, 1) |
                     packed(units.coordinates, 2) | packed(units.vectors, 3));
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
    return units;
}

} // namespace berg
