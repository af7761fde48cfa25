#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/import_text.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

NumberRow icebergRow(const RowWords& words, const QString& unit, double Iceberg::*member,
                     const Limits& limits)
{
    const auto number = [member](auto& iceberg) -> auto&
    {
        return iceberg.*member;
    };
    return {.words = words,
            .unit = unit,
            .decimals = {.least = 0, .most = 1},
            .read = reading<Iceberg>(number),
            .write = writing<Iceberg>(number),
            .range = always(limits)};
}

std::vector<InspectorRow> driftRows()
{
    const auto component = [](const QString& key, const QString& label, const QString& toolTip,
                              auto number) {
        return NumberRow{.words = {.key = key,
                                   .label = label,
                                   .toolTip = toolTip,
                                   .undoText = InspectorRows::tr("Change drift")},
                         .unit = {},
                         .decimals = {.least = 2, .most = 3},
                         .step = kVelocityStep_mps,
                         .read = reading<Iceberg>(number),
                         .write = writing<Iceberg>(number),
                         .range = always(limits::kVelocity_mps)};
    };
    std::vector<InspectorRow> rows = velocityRows(
        {.east = component(
             u"icebergVelocityEast"_s, InspectorRows::tr("Drift east"),
             InspectorRows::tr("Known drift to the east; the current comes on top."),
             [](auto& iceberg) -> auto& { return iceberg.velocity_mps.x(); }),
         .north = component(
             u"icebergVelocityNorth"_s, InspectorRows::tr("Drift north"),
             InspectorRows::tr("Known drift to the north; the current comes on top."),
             [](auto& iceberg) -> auto& { return iceberg.velocity_mps.y(); }),
         .key = u"icebergVelocity"_s,
         .speedLabel = InspectorRows::tr("Drift"),
         .speedToolTip = InspectorRows::tr("Known drift; the current comes on top."),
         .directionLabel = InspectorRows::tr("Drift towards"),
         .directionToolTip = InspectorRows::tr("Where it drifts to, clockwise from north."),
         .componentLimit_mps = kLargestVelocity_mps,
         .speeds_mps = always(limits::kSpeed_mps),
         .direction = {
             .key = u"icebergDrift"_s,
             .text = [](const Scenario& scenario, const std::string& id, const QLocale& locale) {
                 const Iceberg* iceberg = objectOf(scenario.icebergs, id);
                 return iceberg == nullptr ? QString() : towardsText(iceberg->velocity_mps, locale);
             }}});
    NumberRow deviation = asSpeed(
        icebergRow({.key = u"icebergVelocitySd"_s,
                    .label = InspectorRows::tr("Drift error"),
                    .toolTip = InspectorRows::tr(
                        "Standard deviation of the known drift, along each axis: its true drift "
                        "differs from it by as much."),
                    .undoText = InspectorRows::tr("Change drift error"),
                    .isShown = isFiltered},
                   {}, &Iceberg::velocitySd_mps, limits::kSpeed_mps));
    deviation.decimals = {.least = 2, .most = 3};
    deviation.step = kVelocityStep_mps;
    NumberRow spread = asSpeed(
        icebergRow({.key = u"icebergVelocitySpread"_s,
                    .label = InspectorRows::tr("Drift variation"),
                    .toolTip = InspectorRows::tr(
                        "Standard deviation of its drift in the long run, along each axis, about "
                        "that of the current. A beacon off Canada: 0.15 m/s."),
                    .undoText = InspectorRows::tr("Change drift variation"),
                    .isShown = isFiltered},
                   {}, &Iceberg::velocitySpread_mps, limits::kSpeed_mps));
    spread.decimals = deviation.decimals;
    spread.step = deviation.step;
    NumberRow time = icebergRow(
        {.key = u"icebergVelocityTime"_s,
         .label = InspectorRows::tr("Drift changes in"),
         .toolTip = InspectorRows::tr("Time in which a drift that was known is known no more: it "
                                      "fades to the current. 0: the drift is constant. A beacon "
                                      "off Canada: 36,000 s."),
         .undoText = InspectorRows::tr("Change time of drift"),
         .isShown = isFiltered},
        u" s"_s, &Iceberg::velocityTime_s, limits::kTime_s);
    time.step = 3600;
    append(rows, {deviation, spread, time});
    return rows;
}

std::vector<InspectorRow> uncertaintyRows()
{
    NumberRow sigma =
        icebergRow({.key = u"icebergSigma0"_s,
                    .label = InspectorRows::tr("Uncertainty σ₀"),
                    .toolTip = InspectorRows::tr("Variance of the position when it was last seen."),
                    .undoText = InspectorRows::tr("Change uncertainty")},
                   u" m²"_s, &Iceberg::sigma0_m2, limits::kSigma_m2);
    sigma.decimals = {.least = 0, .most = 3};
    NumberRow growth = icebergRow(
        {.key = u"icebergGrowth"_s,
         .label = InspectorRows::tr("Growth q"),
         .toolTip = InspectorRows::tr("What the uncertainty grows by in a second out of view."),
         .undoText = InspectorRows::tr("Change growth of uncertainty")},
        u" m²/s"_s, &Iceberg::q_m2ps, limits::kGrowth_m2ps);
    growth.decimals = {.least = 3, .most = 6};
    growth.step = 0.005;
    const auto deviation = [](const Scenario& scenario, const std::string& id,
                              const QLocale& locale) {
        const Iceberg* iceberg = objectOf(scenario.icebergs, id);
        return iceberg == nullptr
                   ? QString()
                   : InspectorRows::tr("standard deviation %1 m")
                         .arg(significantText(std::sqrt(iceberg->sigma0_m2), 3, locale));
    };
    return {sigma, InfoRow{.key = u"icebergDeviation"_s, .text = deviation}, growth};
}

PickRow visitorRow()
{
    return {.words = {.key = u"icebergUav"_s,
                      .label = InspectorRows::tr("Visited by"),
                      .toolTip = InspectorRows::tr("The UAV that alone is to visit it."),
                      .undoText = InspectorRows::tr("Change UAV of an iceberg"),
                      .isShown = hasUavsToldApart},
            .options =
                [](const Scenario& scenario) {
                    std::vector<PickRow::Option> options{
                        {.value = {}, .text = InspectorRows::tr("any UAV")}};
                    for (const Uav& uav : scenario.uavs)
                        options.push_back(
                            {.value = uav.id,
                             .text = QString::fromStdString(uav.name.empty() ? uav.id : uav.name)});
                    return options;
                },
            .read =
                [](const Scenario& scenario, const std::string& id) {
                    const Iceberg* iceberg = objectOf(scenario.icebergs, id);
                    return iceberg == nullptr ? std::string() : iceberg->uav;
                },
            .write =
                [](Scenario& scenario, const std::string& id, const std::string& uav) {
                    if (Iceberg* iceberg = objectOf(scenario.icebergs, id))
                        iceberg->uav = uav;
                }};
}

PartRow trackRow()
{
    return {.words = {.key = u"icebergTrackClear"_s,
                      .label = InspectorRows::tr("Recorded track"),
                      .toolTip = InspectorRows::tr(
                          "Its true motion follows this record, while the estimate follows the "
                          "drift above."),
                      .undoText = InspectorRows::tr("Clear recorded track")},
            .removeText = InspectorRows::tr("Clear"),
            .text = [](const Scenario& scenario, const std::string& id,
                       const QLocale& locale) -> QString {
                const Iceberg* iceberg = objectOf(scenario.icebergs, id);
                if (iceberg == nullptr || iceberg->track.empty())
                    return {};
                const std::vector<double>& time_s = iceberg->track.time_s;
                return u"%1, %2"_s.arg(
                    InspectorRows::tr("%n points", nullptr, static_cast<int>(time_s.size())),
                    ageText(time_s.back() - time_s.front(), locale));
            },
            .remove =
                [](Scenario& scenario, const std::string& id) {
                    if (Iceberg* iceberg = objectOf(scenario.icebergs, id)) {
                        iceberg->track = {};
                        iceberg->trackExtraJson.clear();
                    }
                }};
}

} // namespace

std::vector<InspectorRow> icebergRows()
{
    std::vector<InspectorRow> rows{nameRow<Iceberg>(u"icebergName"_s)};
    append(rows, positionRows<Iceberg>(u"iceberg"_s));
    append(rows, driftRows());
    append(rows, uncertaintyRows());
    rows.emplace_back(icebergRow(
        {.key = u"icebergObserved"_s,
         .label = InspectorRows::tr("Last seen"),
         .toolTip = InspectorRows::tr("How long before the start it was last seen; σ has grown "
                                      "since."),
         .undoText = InspectorRows::tr("Change time last seen")},
        InspectorRows::tr(" s ago", "unit after a number"), &Iceberg::observed_s, limits::kTime_s));
    NumberRow appears = icebergRow(
        {.key = u"icebergAppears"_s,
         .label = InspectorRows::tr("Appears at"),
         .toolTip = InspectorRows::tr("Time of the run from which on it is known; 0 is the start."),
         .undoText = InspectorRows::tr("Change time of appearing")},
        u" s"_s, &Iceberg::appears_s, limits::kTime_s);
    appears.step = 10;
    rows.emplace_back(appears);
    NumberRow radius =
        icebergRow({.key = u"icebergRadius"_s,
                    .label = InspectorRows::tr("Radius"),
                    .toolTip = InspectorRows::tr("Half its length; decides its size on the map."),
                    .undoText = InspectorRows::tr("Change radius")},
                   u" m"_s, &Iceberg::radius_m, limits::kLength_m);
    radius.step = 5;
    rows.emplace_back(radius);
    rows.emplace_back(visitorRow());
    rows.emplace_back(trackRow());
    return rows;
}

} // namespace berg
