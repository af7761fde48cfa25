#include "widgets/manual/manual_places.h"

#include <QWidget>

#include <algorithm>

namespace berg {

QString manualPlaceOf(const QWidget* widget)
{
    for (; widget != nullptr; widget = widget->parentWidget()) {
        const auto found =
            std::find_if(kManualPlaces.begin(), kManualPlaces.end(), [&](const ManualPlace& known) {
                return widget->objectName() == QLatin1String(known.widget) ||
                       QLatin1String(widget->metaObject()->className()) ==
                           QLatin1String(known.widget);
            });
        if (found != kManualPlaces.end())
            return QLatin1String(found->place);
    }
    return QStringLiteral("start");
}

} // namespace berg
