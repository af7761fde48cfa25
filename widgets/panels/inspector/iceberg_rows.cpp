#include "core/tracking/position_error.h"
#include "widgets/model/scenario_document.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/import_text.h"
#include "widgets/words/source_text.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

std::vector<InspectorRow> driftRows()
{
    const auto component = [](const QString& key, const QString& label, const QString& toolTip,
                              auto number) {
        NumberRow row = objectRow<Iceberg>({.key = key,
                                            .label = label,
                                            .toolTip = toolTip,
                                            .undoText = InspectorRows::tr("Change drift")},
                                           {}, number, limits::kVelocity_mps, kVelocityStep_mps);
        row.decimals = {.least = 2, .most = 3};
        return row;
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
                 const Iceberg* iceberg = findById(scenario.icebergs, id);
                 return iceberg == nullptr ? QString() : towardsText(iceberg->velocity_mps, locale);
             }}});
    NumberRow deviation = asSpeed(objectRow<Iceberg>(
        {.key = u"icebergVelocitySd"_s,
         .label = InspectorRows::tr("Drift error"),
         .toolTip = InspectorRows::tr(
             "Standard deviation of the known drift, along each axis: its true drift "
             "differs from it by as much."),
         .undoText = InspectorRows::tr("Change drift error"),
         .isShown = isFiltered},
        {}, &Iceberg::velocitySd_mps, limits::kSpeed_mps, kVelocityStep_mps));
    deviation.decimals = {.least = 2, .most = 3};
    NumberRow spread = asSpeed(objectRow<Iceberg>(
        {.key = u"icebergVelocitySpread"_s,
         .label = InspectorRows::tr("Drift variation"),
         .toolTip = InspectorRows::tr(
             "Standard deviation of its drift in the long run, along each axis, about "
             "that of the current. A beacon off Canada: 0.15 m/s."),
         .undoText = InspectorRows::tr("Change drift variation"),
         .isShown = isFiltered},
        {}, &Iceberg::velocitySpread_mps, limits::kSpeed_mps, kVelocityStep_mps));
    spread.decimals = deviation.decimals;
    append(rows,
           {deviation, spread,
            objectRow<Iceberg>({.key = u"icebergVelocityTime"_s,
                                .label = InspectorRows::tr("Drift changes in"),
                                .toolTip = InspectorRows::tr(
                                    "Time in which a drift that was known is known no more: it "
                                    "fades to the current. 0: the drift is constant. A beacon "
                                    "off Canada: 36,000 s."),
                                .undoText = InspectorRows::tr("Change time of drift"),
                                .isShown = isFiltered},
                               u" s"_s, &Iceberg::velocityTime_s, limits::kTime_s, 3600)});
    return rows;
}

/** The other way of saying sigma, which can be typed as well. */
NumberRow radius95Row()
{
    return {.words = {.key = u"icebergRadius95"_s,
                      .label = InspectorRows::tr("95 % within"),
                      .toolTip = InspectorRows::tr(
                          "With 95 % the iceberg was inside a circle of this radius when it was "
                          "last seen: the square root of 5.99 σ₀."),
                      .undoText = InspectorRows::tr("Change uncertainty")},
            .unit = u" m"_s,
            .decimals = {.least = 0, .most = 2},
            .step = 10,
            .read = [](const Scenario& scenario, const std::string& id) -> double {
                const Iceberg* iceberg = findById(scenario.icebergs, id);
                return iceberg == nullptr ? 0 : radius95_m(iceberg->sigma0_m2);
            },
            .write =
                [](Scenario& scenario, const std::string& id, double radius_m) {
                    if (Iceberg* iceberg = findById(scenario.icebergs, id))
                        iceberg->sigma0_m2 = sigmaOfRadius95_m2(radius_m);
                },
            .range = always({.low = 0, .high = std::floor(radius95_m(limits::kSigma_m2.high))})};
}

/** Sets sigma to the usual one of a source; icebergs placed from then on have it, too. */
PickRow sourceRow()
{
    return {.words = {.key = u"icebergSource"_s,
                      .label = InspectorRows::tr("Seen by"),
                      .toolTip = InspectorRows::tr(
                          "Sets the uncertainty to the usual one of this source, for icebergs "
                          "placed from now on as well."),
                      .undoText = InspectorRows::tr("Change uncertainty")},
            .options =
                [](const Scenario&) {
                    std::vector<PickRow::Option> options{
                        {.value = {}, .text = InspectorRows::tr("as typed")}};
                    for (const SightingSource source : kSightingSources)
                        options.push_back({.value = std::string(errorOf(source).name),
                                           .text = sourceName(source)});
                    return options;
                },
            .read =
                [](const Scenario& scenario, const std::string& id) {
                    const Iceberg* iceberg = findById(scenario.icebergs, id);
                    const auto source =
                        iceberg != nullptr ? sourceWith(iceberg->sigma0_m2) : std::nullopt;
                    return source ? std::string(errorOf(*source).name) : std::string();
                },
            .write =
                [](Scenario& scenario, const std::string& id, const std::string& name) {
                    Iceberg* iceberg = findById(scenario.icebergs, id);
                    if (const auto source = sourceNamed(name); source && iceberg != nullptr)
                        iceberg->sigma0_m2 = errorOf(*source).sigma_m2();
                },
            .chosen =
                [](ScenarioDocument& document, const std::string& name) {
                    if (const auto source = sourceNamed(name))
                        document.setNewIcebergSource(*source);
                }};
}

std::vector<InspectorRow> uncertaintyRows()
{
    NumberRow sigma = objectRow<Iceberg>(
        {.key = u"icebergSigma0"_s,
         .label = InspectorRows::tr("Uncertainty σ₀"),
         .toolTip = InspectorRows::tr("Variance of the position when it was last seen."),
         .undoText = InspectorRows::tr("Change uncertainty")},
        u" m²"_s, &Iceberg::sigma0_m2, limits::kSigma_m2);
    sigma.decimals = {.least = 0, .most = 3};
    NumberRow growth = objectRow<Iceberg>(
        {.key = u"icebergGrowth"_s,
         .label = InspectorRows::tr("Growth q"),
         .toolTip = InspectorRows::tr("What the uncertainty grows by in a second out of view."),
         .undoText = InspectorRows::tr("Change growth of uncertainty")},
        u" m²/s"_s, &Iceberg::q_m2ps, limits::kGrowth_m2ps, 0.005);
    growth.decimals = {.least = 3, .most = 6};
    const auto deviation = [](const Scenario& scenario, const std::string& id,
                              const QLocale& locale) {
        const Iceberg* iceberg = findById(scenario.icebergs, id);
        return iceberg == nullptr
                   ? QString()
                   : InspectorRows::tr("standard deviation %1 m")
                         .arg(significantText(std::sqrt(iceberg->sigma0_m2), 3, locale));
    };
    std::vector<InspectorRow> rows;
    if (shownUnits().uncertainty == UncertaintyForm::Sigma)
        append(rows, {sigma, radius95Row()});
    else
        append(rows, {radius95Row(), sigma});
    append(rows, {growth, sourceRow(), InfoRow{.key = u"icebergDeviation"_s, .text = deviation}});
    return rows;
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
                    const Iceberg* iceberg = findById(scenario.icebergs, id);
                    return iceberg == nullptr ? std::string() : iceberg->uav;
                },
            .write =
                [](Scenario& scenario, const std::string& id, const std::string& uav) {
                    if (Iceberg* iceberg = findById(scenario.icebergs, id))
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
                const Iceberg* iceberg = findById(scenario.icebergs, id);
                if (iceberg == nullptr || iceberg->track.empty())
                    return {};
                const std::vector<double>& time_s = iceberg->track.time_s;
                return u"%1, %2"_s.arg(
                    InspectorRows::tr("%n points", nullptr, static_cast<int>(time_s.size())),
                    ageText(time_s.back() - time_s.front(), locale));
            },
            .remove =
                [](Scenario& scenario, const std::string& id) {
                    if (Iceberg* iceberg = findById(scenario.icebergs, id)) {
                        iceberg->track = {};
                        iceberg->trackExtraJson.clear();
                    }
                }};
}

} // namespace

std::vector<InspectorRow> icebergRows()
{
    std::vector<InspectorRow> rows{nameRow<Iceberg>(u"icebergName"_s)};
    rows.emplace_back(
        GroupRow{.key = u"icebergPositionGroup"_s, .title = InspectorRows::tr("Position")});
    append(rows, positionRows<Iceberg>(u"iceberg"_s));
    rows.emplace_back(GroupRow{.key = u"icebergDriftGroup"_s, .title = InspectorRows::tr("Drift")});
    append(rows, driftRows());
    rows.emplace_back(
        GroupRow{.key = u"icebergUncertaintyGroup"_s, .title = InspectorRows::tr("Uncertainty")});
    append(rows, uncertaintyRows());
    rows.emplace_back(objectRow<Iceberg>(
        {.key = u"icebergObserved"_s,
         .label = InspectorRows::tr("Last seen"),
         .toolTip = InspectorRows::tr("How long before the start it was last seen; σ has grown "
                                      "since."),
         .undoText = InspectorRows::tr("Change time last seen")},
        InspectorRows::tr(" s ago", "unit after a number"), &Iceberg::observed_s, limits::kTime_s));
    rows.emplace_back(
        GroupRow{.key = u"icebergVisitGroup"_s, .title = InspectorRows::tr("Size and visits")});
    rows.emplace_back(objectRow<Iceberg>(
        {.key = u"icebergAppears"_s,
         .label = InspectorRows::tr("Appears at"),
         .toolTip = InspectorRows::tr("Time of the run from which on it is known; 0 is the start."),
         .undoText = InspectorRows::tr("Change time of appearing")},
        u" s"_s, &Iceberg::appears_s, limits::kTime_s, 10));
    rows.emplace_back(objectRow<Iceberg>(
        {.key = u"icebergRadius"_s,
         .label = InspectorRows::tr("Radius"),
         .toolTip =
             InspectorRows::tr("Half its length: its size on the map, and how far outside the "
                               "area it is still monitored."),
         .undoText = InspectorRows::tr("Change radius")},
        u" m"_s, &Iceberg::radius_m, limits::kLength_m, 5));
    rows.emplace_back(visitorRow());
    rows.emplace_back(trackRow());
    return rows;
}

} // namespace berg
