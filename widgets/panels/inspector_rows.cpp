#include "core/base/angles.h"
#include "core/base/geodesy.h"
#include "widgets/panels/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr Limits kCoordinate_m{.low = -kLargestCoordinate_m, .high = kLargestCoordinate_m};
constexpr double kPositionStep_m = 10;

} // namespace

template <class Object>
TextRow nameRow(const QString& key)
{
    return {.words = {.key = key,
                      .label = InspectorRows::tr("Name"),
                      .toolTip = InspectorRows::tr("Shown on the map in place of the id."),
                      .undoText = InspectorRows::tr("Change name")},
            .read =
                [](const Scenario& scenario, const std::string& id) {
                    const Object* object = objectOf(listOf<Object>(scenario), id);
                    return object == nullptr ? std::string() : object->name;
                },
            .write =
                [](Scenario& scenario, const std::string& id, const std::string& name) {
                    for (Object& object : listOf<Object>(scenario))
                        if (object.id == id)
                            object.name = name;
                }};
}

template <class Object>
std::vector<InspectorRow> positionRows(const QString& kind)
{
    const auto row = [&](const QString& key, const QString& label, const QString& toolTip,
                         auto number) {
        return NumberRow{.words = {.key = kind + key,
                                   .label = label,
                                   .toolTip = toolTip,
                                   .undoText = InspectorRows::tr("Change position")},
                         .unit = u" m"_s,
                         .decimals = {.least = 0, .most = 1},
                         .step = kPositionStep_m,
                         .read = reading<Object>(number),
                         .write = writing<Object>(number),
                         .range = always(kCoordinate_m)};
    };
    const auto place = [](const Scenario& scenario, const std::string& id, const QLocale& locale) {
        const Object* object = objectOf(listOf<Object>(scenario), id);
        if (object == nullptr)
            return QString();
        const LatLon at = LocalFrame(scenario.origin).toGeographic(object->position_m);
        return u"%1\n%2"_s.arg(latitudeText(at.latitude_deg, 3, locale),
                               longitudeText(at.longitude_deg, 3, locale));
    };
    return {row(
                u"East"_s, InspectorRows::tr("East"),
                InspectorRows::tr("Position at the start, east of the scenario's origin."),
                [](auto& object) -> auto& { return object.position_m.x(); }),
            row(
                u"North"_s, InspectorRows::tr("North"),
                InspectorRows::tr("Position at the start, north of the scenario's origin."),
                [](auto& object) -> auto& { return object.position_m.y(); }),
            InfoRow{.key = kind + u"Place"_s, .text = place}};
}

template TextRow nameRow<Iceberg>(const QString& key);
template TextRow nameRow<Uav>(const QString& key);
template std::vector<InspectorRow> positionRows<Iceberg>(const QString& kind);
template std::vector<InspectorRow> positionRows<Uav>(const QString& kind);

QString towardsText(const Point& velocity_mps, const QLocale& locale)
{
    const double speed_mps = velocity_mps.norm();
    if (speed_mps == 0)
        return InspectorRows::tr("stands still");
    const double psi_rad = std::atan2(velocity_mps.y(), velocity_mps.x());
    const int heading_deg = static_cast<int>(std::lround(headingFromPsi(psi_rad))) % 360;
    return InspectorRows::tr("%1 m/s towards %2°")
        .arg(significantText(speed_mps, 2, locale))
        .arg(heading_deg, 3, 10, QChar(u'0'));
}

} // namespace berg
