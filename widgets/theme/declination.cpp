#include "widgets/theme/declination.h"

#include "core/earth/magnetic_field.h"
#include "widgets/theme/unit_settings.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace berg {
namespace {

std::atomic<double> declinationInUse_deg{0};

/** Year with fraction: 2026.5 in the middle of 2026. */
double decimalYear(SunTime time)
{
    using namespace std::chrono;
    const year_month_day date(floor<days>(time));
    const sys_days begin = date.year() / January / 1;
    const sys_days end = (date.year() + years(1)) / January / 1;
    return static_cast<int>(date.year()) +
           duration<double>(time - begin) / duration<double>(end - begin);
}

} // namespace

double readDeclination_deg(const QSettings& settings)
{
    const double typed_deg = settings.value(kDeclinationKey).toDouble();
    return std::isfinite(typed_deg)
               ? std::clamp<double>(typed_deg, -kMostDeclination_deg, kMostDeclination_deg)
               : 0;
}

double typedDeclination_deg()
{
    return declinationInUse_deg.load();
}

void setTypedDeclination(double declination_deg)
{
    declinationInUse_deg.store(declination_deg);
}

std::optional<double> shownDeclination_deg(LatLon place, const std::optional<SunTime>& time)
{
    switch (shownUnits().north) {
    case NorthForm::True:
        break;
    case NorthForm::Typed:
        return typedDeclination_deg();
    case NorthForm::Model:
        if (time)
            return magneticDeclination_deg(place, decimalYear(*time));
        break;
    }
    return std::nullopt;
}

} // namespace berg
