#include "widgets/panels/icebergs/iceberg_table_columns.h"

#include "core/base/error.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/panels/inspector/inspector_row_makers.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct IcebergColumnText
{
    Q_DECLARE_TR_FUNCTIONS(IcebergColumnText)
};

constexpr Limits kDirection_deg{.low = 0, .high = 360};

/** The row of the inspector that edits this number. */
NumberRow inspectorRow(const std::vector<InspectorRow>& rows, const QString& key)
{
    for (const InspectorRow& row : rows)
        if (const auto* number = std::get_if<NumberRow>(&row))
            if (number->words.key == key)
                return *number;
    require(false, "the inspector has no such row");
    return {};
}

IcebergColumnSpec inFlight(const QString& key, const QString& title, const QString& copied,
                           const QString& toolTip)
{
    return {.key = key, .title = title, .copied = copied, .toolTip = toolTip, .isInFlight = true};
}

IcebergColumnSpec inBoth(IcebergColumnSpec spec, const ShownUnit& unit)
{
    spec.isInFlight = true;
    spec.title = spec.copied = spec.title.arg(unit.name);
    spec.unit = unit;
    return spec;
}

IcebergColumnSpec ofAsset(const QString& key, const QString& title, const QString& copied,
                          const QString& toolTip)
{
    return {.key = key,
            .title = title,
            .copied = copied,
            .toolTip = toolTip,
            .isInEditor = true,
            .isInFlight = true,
            .isOfAsset = true};
}

/** Closest point of approach and time to it. */
std::array<IcebergColumnSpec, 2> assetColumns()
{
    const ShownUnit unit = distanceUnit();
    const QString distance = IcebergColumnText::tr("CPA, %1").arg(unit.name);
    IcebergColumnSpec nearest = ofAsset(
        u"assetDistance"_s, distance, distance,
        IcebergColumnText::tr("Closest point of approach: least distance from the asset "
                              "within the next hour, by the estimate. A warning sign beside "
                              "the name: it comes into the inner ring"));
    nearest.unit = unit;
    return {nearest,
            ofAsset(u"assetTime"_s, IcebergColumnText::tr("TCPA"), IcebergColumnText::tr("TCPA, s"),
                    IcebergColumnText::tr("Time to the closest point of approach"))};
}

IcebergColumnSpec inEditor(const QString& key, const QString& title, const QString& toolTip,
                           const NumberRow& number)
{
    return {.key = key,
            .title = title,
            .copied = title,
            .toolTip = toolTip,
            .isInEditor = true,
            .number = number};
}

IcebergColumnSpec ofPlace(const QString& key, const QString& title, PlaceHalf half)
{
    return {.key = key,
            .title = title,
            .copied = title,
            .toolTip = IcebergColumnText::tr("Where it is, in flight the estimate; typed and "
                                             "pasted in any form, a whole coordinate sets both"),
            .isInEditor = true,
            .isInFlight = true,
            .half = half};
}

/** Speed and direction, drift to the east and north: two of them are there, by the form chosen. */
std::array<IcebergColumnSpec, 4> driftColumns(const std::vector<InspectorRow>& rows)
{
    const bool isComponents = shownUnits().vectors == VectorForm::Components;
    const auto drift = [&](const QString& key, const QString& title, const QString& toolTip,
                           const QString& inspectorKey, bool isThere) {
        IcebergColumnSpec spec =
            inEditor(key, title.contains(u'%') ? title.arg(speedUnit().name) : title, toolTip, {});
        spec.isInEditor = isThere;
        if (isThere)
            spec.number = inspectorRow(rows, inspectorKey);
        spec.unit = speedUnit();
        return spec;
    };
    IcebergColumnSpec speed =
        drift(u"speed"_s, IcebergColumnText::tr("Speed, %1"),
              IcebergColumnText::tr("Known drift; in flight the current is in it"),
              u"icebergVelocitySpeed"_s, !isComponents);
    speed.isInFlight = true;
    IcebergColumnSpec direction =
        drift(u"direction"_s, IcebergColumnText::tr("Direction, °"),
              IcebergColumnText::tr("Where it drifts to, degrees clockwise from north"),
              u"icebergVelocityDirection"_s, !isComponents);
    direction.unit = {};
    if (direction.number)
        direction.number->range = always(kDirection_deg);
    return {speed, direction,
            drift(u"driftEast"_s, IcebergColumnText::tr("Drift east, %1"),
                  IcebergColumnText::tr("Known drift to the east; the current comes on top"),
                  u"icebergVelocityEast"_s, isComponents),
            drift(u"driftNorth"_s, IcebergColumnText::tr("Drift north, %1"),
                  IcebergColumnText::tr("Known drift to the north; the current comes on top"),
                  u"icebergVelocityNorth"_s, isComponents)};
}

} // namespace

IcebergColumnSpecs icebergColumnSpecs()
{
    const std::vector<InspectorRow> rows = icebergRows();
    const auto numberOf = [&](const QString& key) { return inspectorRow(rows, key); };
    const auto like = [&](const QString& key, const QString& title, const QString& inspectorKey) {
        const NumberRow number = numberOf(inspectorKey);
        return inEditor(key, title, number.words.toolTip, number);
    };
    const auto [speed, direction, driftEast, driftNorth] = driftColumns(rows);
    const auto [assetDistance, assetTime] = assetColumns();
    IcebergColumnSpec uav = inFlight(u"uav"_s, u"UAV"_s, u"UAV"_s,
                                     IcebergColumnText::tr("The UAV that has it in its plan"));
    uav.isOfFleet = true;
    IcebergColumnSpec name{
        .key = u"name"_s,
        .title = IcebergColumnText::tr("Iceberg"),
        .copied = IcebergColumnText::tr("Iceberg"),
        .toolTip = IcebergColumnText::tr("Name of the iceberg, its id where it has none"),
        .isInEditor = true,
        .isInFlight = true};
    return {
        name,
        inFlight(u"sigma"_s, u"σ, m²"_s, u"σ, m²"_s,
                 IcebergColumnText::tr(
                     "Uncertainty of the position now; the bar is on the scale of the map")),
        inFlight(u"radius95"_s, u"95 %"_s, IcebergColumnText::tr("95 % radius, m"),
                 IcebergColumnText::tr("With 95 % the iceberg is inside a circle of this radius "
                                       "round its position now")),
        assetDistance,
        assetTime,
        inFlight(u"state"_s, IcebergColumnText::tr("State"), IcebergColumnText::tr("State"),
                 IcebergColumnText::tr("In view, next target, or its place in the visiting order")),
        uav,
        inFlight(u"unseen"_s, IcebergColumnText::tr("Unseen for"),
                 IcebergColumnText::tr("Unseen for, s"),
                 IcebergColumnText::tr("Time since it was last in view, or since it is known")),
        inFlight(
            u"arrival"_s, IcebergColumnText::tr("Arrival"), IcebergColumnText::tr("Arrival in, s"),
            IcebergColumnText::tr("Time from now until the UAV is there, by the plan in force")),
        inFlight(u"visits"_s, IcebergColumnText::tr("Visits"), IcebergColumnText::tr("Visits"),
                 IcebergColumnText::tr("How often it was the target and was reached")),
        inBoth(inEditor(u"east"_s, IcebergColumnText::tr("East, %1"),
                        IcebergColumnText::tr(
                            "Position east of the scenario's origin: before take-off at the "
                            "start, in flight the estimate"),
                        numberOf(u"icebergEast"_s)),
               distanceUnit()),
        inBoth(inEditor(u"north"_s, IcebergColumnText::tr("North, %1"),
                        IcebergColumnText::tr(
                            "Position north of the scenario's origin: before take-off at "
                            "the start, in flight the estimate"),
                        numberOf(u"icebergNorth"_s)),
               distanceUnit()),
        speed,
        direction,
        driftEast,
        driftNorth,
        like(u"sigma0"_s, u"σ₀, m²"_s, u"icebergSigma0"_s),
        like(u"growth"_s, u"q, m²/s"_s, u"icebergGrowth"_s),
        like(u"observed"_s, IcebergColumnText::tr("Last seen, s ago"), u"icebergObserved"_s),
        like(u"appears"_s, IcebergColumnText::tr("Appears at, s"), u"icebergAppears"_s),
        ofPlace(u"latitude"_s, IcebergColumnText::tr("Latitude"), PlaceHalf::Latitude),
        ofPlace(u"longitude"_s, IcebergColumnText::tr("Longitude"), PlaceHalf::Longitude),
    };
}

namespace {

/** Of a constant iceberg or not: the number that the column holds as it is; null: none, or speed
 * and direction, which follow from it. */
template <class I>
auto* heldNumber(I& iceberg, IcebergColumn column)
{
    using Number = std::remove_reference_t<decltype((iceberg.sigma0_m2))>;
    switch (column) {
    case IcebergColumn::East:
        return &iceberg.position_m.x();
    case IcebergColumn::North:
        return &iceberg.position_m.y();
    case IcebergColumn::DriftEast:
        return &iceberg.velocity_mps.x();
    case IcebergColumn::DriftNorth:
        return &iceberg.velocity_mps.y();
    case IcebergColumn::Sigma0:
        return &iceberg.sigma0_m2;
    case IcebergColumn::Growth:
        return &iceberg.q_m2ps;
    case IcebergColumn::Observed:
        return &iceberg.observed_s;
    case IcebergColumn::Appears:
        return &iceberg.appears_s;
    case IcebergColumn::Name:
    case IcebergColumn::Sigma:
    case IcebergColumn::Radius95:
    case IcebergColumn::State:
    case IcebergColumn::Uav:
    case IcebergColumn::AssetDistance:
    case IcebergColumn::AssetTime:
    case IcebergColumn::Unseen:
    case IcebergColumn::Arrival:
    case IcebergColumn::Visits:
    case IcebergColumn::Speed:
    case IcebergColumn::Direction:
    case IcebergColumn::Latitude:
    case IcebergColumn::Longitude:
        break;
    }
    return static_cast<Number*>(nullptr);
}

} // namespace

std::optional<double> icebergNumber(const Iceberg& iceberg, IcebergColumn column)
{
    if (column == IcebergColumn::Speed)
        return iceberg.velocity_mps.norm();
    if (column == IcebergColumn::Direction && !iceberg.velocity_mps.isZero(0))
        return directionOf(iceberg.velocity_mps);
    const double* held = heldNumber(iceberg, column);
    return held != nullptr ? std::optional(*held) : std::nullopt;
}

bool isShownAs(const Iceberg& iceberg, IcebergColumn column, const IcebergColumnSpec& spec,
               double shown)
{
    const std::optional<double> held = icebergNumber(iceberg, column);
    return held && spec.unit.fromSi(*held) == shown;
}

void setIcebergNumber(Iceberg& iceberg, IcebergColumn column, double value)
{
    if (column == IcebergColumn::Speed)
        return setDrift(iceberg, {.speed_mps = value});
    if (column == IcebergColumn::Direction)
        return setDrift(iceberg, {.direction_deg = value});
    double* held = heldNumber(iceberg, column);
    require(held != nullptr, "not a number of an iceberg that can be set");
    *held = value;
}

void setDrift(Iceberg& iceberg, const Drift& drift)
{
    const double before_mps = iceberg.velocity_mps.norm();
    const double before_deg = icebergNumber(iceberg, IcebergColumn::Direction).value_or(0);
    const double speed_mps = drift.speed_mps.value_or(before_mps);
    const double direction_deg = drift.direction_deg.value_or(before_deg);
    if (speed_mps == before_mps && (speed_mps == 0 || direction_deg == before_deg))
        return;
    iceberg.velocity_mps = clampedVelocity(velocityTowards(speed_mps, direction_deg));
}

} // namespace berg
