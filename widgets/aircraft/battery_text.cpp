#include "widgets/aircraft/battery_text.h"

#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QStringList>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

struct BatteryWords
{
    Q_DECLARE_TR_FUNCTIONS(BatteryText)
};

} // namespace

bool isBatteryShort(const BatteryReadout& readout)
{
    return readout.left_s && readout.wayHome_s && *readout.left_s < *readout.wayHome_s;
}

QString batteryText(const BatteryReadout& readout, const QLocale& locale)
{
    QStringList parts;
    if (readout.battery.remaining)
        parts << u"%1 %"_s.arg(qRound(100 * *readout.battery.remaining));
    if (readout.battery.voltage_v)
        parts << u"%1 V"_s.arg(fixedText(*readout.battery.voltage_v, 1, locale));
    if (readout.left_s)
        parts << (readout.isComputed ? BatteryWords::tr("about %1 left")
                                     : BatteryWords::tr("%1 left"))
                     .arg(clockText(*readout.left_s));
    if (readout.wayHome_s)
        parts << BatteryWords::tr("way home %1").arg(clockText(*readout.wayHome_s));
    if (readout.endurance_s)
        parts << BatteryWords::tr("planned endurance left %1").arg(clockText(*readout.endurance_s));
    return parts.join(u", "_s);
}

QString batteryWarning(const BatteryReadout& readout)
{
    return BatteryWords::tr("Battery for %1, way home %2")
        .arg(clockText(readout.left_s.value_or(0)), clockText(readout.wayHome_s.value_or(0)));
}

} // namespace berg
