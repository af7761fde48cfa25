#include "widgets/panels/icebergs/iceberg_table_columns.h"

#include "widgets/document/scenario_edits.h"
#include "widgets/panels/inspector/field_inputs.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct IcebergColumnText
{
    Q_DECLARE_TR_FUNCTIONS(IcebergColumnText)
};

constexpr Limits kDirection_deg{.low = 0, .high = 360};

/** Returns the Inspector's row that edits this number. */
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

/** Returns the columns of the closest point of approach and the time to it. */
std::array<IcebergColumnSpec, 2> assetColumns()
{
    const ShownUnit unit = distanceUnit();
    const QString distance = IcebergColumnText::tr("CPA, %1").arg(unit.name);
    IcebergColumnSpec nearest =
        ofAsset(u"assetDistance"_s, distance, distance,
                IcebergColumnText::tr("Closest point of approach: smallest predicted distance from "
                                      "the asset within the next hour. A warning sign beside the "
                                      "name means that the iceberg will enter the inner ring"));
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
            .toolTip = IcebergColumnText::tr("Position, in flight the estimate. Type or paste any "
                                             "form; a whole coordinate sets both"),
            .isInEditor = true,
            .isInFlight = true,
            .half = half};
}

/** Returns the columns of speed and direction or of the components; two of them are shown. */
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
              IcebergColumnText::tr("Known drift; in flight it includes the current"),
              u"icebergVelocitySpeed"_s, !isComponents);
    speed.isInFlight = true;
    IcebergColumnSpec direction =
        drift(u"direction"_s, IcebergColumnText::tr("Direction, °"),
              IcebergColumnText::tr("Drift direction, degrees clockwise from north"),
              u"icebergVelocityDirection"_s, !isComponents);
    direction.unit = {};
    if (direction.number)
        direction.number->range = always(kDirection_deg);
    return {speed, direction,
            drift(u"driftEast"_s, IcebergColumnText::tr("Drift east, %1"),
                  IcebergColumnText::tr("Known drift to the east, without the current"),
                  u"icebergVelocityEast"_s, isComponents),
            drift(u"driftNorth"_s, IcebergColumnText::tr("Drift north, %1"),
                  IcebergColumnText::tr("Known drift to the north, without the current"),
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
    IcebergColumnSpec uav =
        inFlight(u"uav"_s, u"UAV"_s, u"UAV"_s, IcebergColumnText::tr("UAV that plans to visit it"));
    uav.isOfFleet = true;
    IcebergColumnSpec name{
        .key = u"name"_s,
        .title = IcebergColumnText::tr("Iceberg"),
        .copied = IcebergColumnText::tr("Iceberg"),
        .toolTip = IcebergColumnText::tr("Name of the iceberg, or its id if it has none"),
        .isInEditor = true,
        .isInFlight = true};
    return {
        name,
        inFlight(u"sigma"_s, u"σ, m²"_s, u"σ, m²"_s,
                 IcebergColumnText::tr(
                     "Uncertainty of the position now; the bar is on the scale of the map")),
        inFlight(u"radius95"_s, u"95 %"_s, IcebergColumnText::tr("95 % radius, m"),
                 IcebergColumnText::tr("Radius around the present position that contains the "
                                       "iceberg with a probability of 95 %")),
        assetDistance,
        assetTime,
        inFlight(u"state"_s, IcebergColumnText::tr("State"), IcebergColumnText::tr("State"),
                 IcebergColumnText::tr("In view, next target, or its place in the visiting order")),
        uav,
        inFlight(u"unseen"_s, IcebergColumnText::tr("Unseen for"),
                 IcebergColumnText::tr("Unseen for, s"),
                 IcebergColumnText::tr("Time since it was last in view, or since it became known")),
        inFlight(u"arrival"_s, IcebergColumnText::tr("Arrival"),
                 IcebergColumnText::tr("Arrival in, s"),
                 IcebergColumnText::tr("Time until the UAV arrives, by the present plan")),
        inFlight(u"visits"_s, IcebergColumnText::tr("Visits"), IcebergColumnText::tr("Visits"),
                 IcebergColumnText::tr("Number of times it was reached as the target")),
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
        like(u"sigma0"_s, u"σ₀, m²"_s, u"icebergs.sigma0_m2"_s),
        like(u"growth"_s, u"q, m²/s"_s, u"icebergs.q_m2ps"_s),
        like(u"observed"_s, IcebergColumnText::tr("Last seen, s ago"), u"icebergs.observed_s"_s),
        like(u"appears"_s, IcebergColumnText::tr("Appears at, s"), u"icebergs.appears_s"_s),
        ofPlace(u"latitude"_s, IcebergColumnText::tr("Latitude"), PlaceHalf::Latitude),
        ofPlace(u"longitude"_s, IcebergColumnText::tr("Longitude"), PlaceHalf::Longitude),
    };
}

namespace {

/** A column that holds a number of the iceberg itself; speed and direction are derived. */
struct HeldNumber
{
    IcebergColumn column;
    std::string_view field; ///< name in files
    int axis = 0;           ///< axis of a pair
};

constexpr std::array kHeldNumbers{HeldNumber{IcebergColumn::East, "position_m", 0},
                                  HeldNumber{IcebergColumn::North, "position_m", 1},
                                  HeldNumber{IcebergColumn::DriftEast, "velocity_mps", 0},
                                  HeldNumber{IcebergColumn::DriftNorth, "velocity_mps", 1},
                                  HeldNumber{IcebergColumn::Sigma0, "sigma0_m2"},
                                  HeldNumber{IcebergColumn::Growth, "q_m2ps"},
                                  HeldNumber{IcebergColumn::Observed, "observed_s"},
                                  HeldNumber{IcebergColumn::Appears, "appears_s"}};

/**
 * Calls `use` with the field of the iceberg and the axis. Returns false if the column holds no
 * field.
 */
template <class I, class Use>
bool withHeldNumber(I& iceberg, IcebergColumn column, const Use& use)
{
    const auto* const held = std::ranges::find(kHeldNumbers, column, &HeldNumber::column);
    if (held == kHeldNumbers.end())
        return false;
    withField(between(fieldsOf<Iceberg>(), held->field, held->field).front(), iceberg,
              [&](auto& number) { use(number, held->axis); });
    return true;
}

} // namespace

std::optional<double> icebergNumber(const Iceberg& iceberg, IcebergColumn column)
{
    if (column == IcebergColumn::Speed)
        return iceberg.velocity_mps.norm();
    if (column == IcebergColumn::Direction && !iceberg.velocity_mps.isZero(0))
        return directionOf(iceberg.velocity_mps);
    std::optional<double> number;
    withHeldNumber(iceberg, column,
                   [&](const auto& held, int axis) { number = shownNumber(held, axis, 0); });
    return number;
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
    const bool isHeld = withHeldNumber(
        iceberg, column, [&](auto& held, int axis) { setNumber(held, value, axis, 0, 0); });
    require(isHeld, "not a number of an iceberg that can be set");
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
