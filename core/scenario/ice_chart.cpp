#include "core/scenario/ice_chart.h"

#include "core/scenario/text_checks.h"

#include <array>

namespace berg {

IceClass classOf(const IceArea& area)
{
    if (area.isFast)
        return IceClass::Fast;
    if (!area.concentration_tenths)
        return IceClass::Unknown;
    const double tenths = *area.concentration_tenths;
    if (tenths <= 0)
        return IceClass::IceFree;
    if (tenths < 1)
        return IceClass::OpenWater;
    if (tenths < 4)
        return IceClass::VeryOpen;
    if (tenths < 7)
        return IceClass::Open;
    return tenths < 9 ? IceClass::Close : IceClass::VeryClose;
}

std::uint32_t wmoColour(IceClass iceClass)
{
    constexpr std::array<std::uint32_t, kIceClasses> kColours{
        0x0064FF, 0x96C8FF, 0x8CFFA0, 0xFFFF00, 0xFF7D07, 0xFF0000, 0x969696, 0xD2D2D2};
    return kColours[static_cast<std::size_t>(iceClass)];
}

std::optional<double> tenthsOfSigrid(int code)
{
    if (code == 0 || code == 55)
        return 0;
    if (code == 1 || code == 2)
        return 0.5;
    if (code == 91)
        return 9.5;
    if (code == 92)
        return 10;
    const int first = code / 10;
    const int second = code == 81 ? 10 : code % 10; // a digit has no room for 10
    if (code < 10 || code > 90)
        return std::nullopt;
    if (code % 10 == 0)
        return first;
    return second > first ? std::optional((first + second) / 2.0) : std::nullopt;
}

std::optional<double> ageOf_s(const IceChart& chart, std::string_view startUtc)
{
    if (!isUtcTime(chart.dateUtc) || !isUtcTime(startUtc))
        return std::nullopt;
    return utcSeconds(startUtc) - utcSeconds(chart.dateUtc);
}

} // namespace berg
