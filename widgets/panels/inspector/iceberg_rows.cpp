#include "core/study/drift_tracks.h"
#include "core/tracking/position_error.h"
#include "widgets/document/scenario_document.h"
#include "widgets/panels/inspector/field_inputs.h"
#include "widgets/words/import_text.h"
#include "widgets/words/source_text.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

std::vector<InspectorRow> driftRows()
{
    const FieldInputs<Iceberg> iceberg("icebergs.");
    const QString change = InspectorRows::tr("Change drift");
    std::vector<InspectorRow> rows = velocityRows(
        {.east = named(iceberg.inSi("velocity_mps", 0), u"icebergVelocityEast"_s, change),
         .north = named(iceberg.inSi("velocity_mps", 1), u"icebergVelocityNorth"_s, change),
         .key = u"icebergVelocity"_s,
         .speedLabel = InspectorRows::tr("Drift"),
         .speedToolTip = InspectorRows::tr("Known drift, without the current."),
         .directionLabel = InspectorRows::tr("Drift towards"),
         .directionToolTip = InspectorRows::tr("Drift direction, clockwise from north."),
         .componentLimit_mps = kLargestVelocity_mps,
         .speeds_mps = always(limits::kSpeed_mps),
         .direction = {
             .key = u"icebergDrift"_s,
             .text = [](const Scenario& scenario, const std::string& id, const QLocale& locale) {
                 const Iceberg* iceberg = findById(scenario.icebergs, id);
                 return iceberg == nullptr ? QString() : towardsText(iceberg->velocity_mps, locale);
             }}});
    append(
        rows,
        FieldInputs<Iceberg>("icebergs.", isFiltered).rows("velocity_sd_mps", "velocity_time_s"));
    return rows;
}

/** Returns the row of the 95 % radius, an alternative form of sigma. */
NumberRow radius95Row(const NumberRow& sigma)
{
    NumberRow row = sigma;
    row.words = {.key = u"icebergRadius95"_s,
                 .label = InspectorRows::tr("95 % within"),
                 .toolTip =
                     InspectorRows::tr("When last seen, the iceberg was within this radius with a "
                                       "probability of 95 %: the square root of 5.99 σ₀."),
                 .undoText = InspectorRows::tr("Change uncertainty")};
    row.unit = u" m"_s;
    row.decimals = {.least = 0, .most = 2};
    row.step = 10;
    row.read = [read = sigma.read](const Scenario& scenario, const std::string& id) {
        return radius95_m(read(scenario, id));
    };
    row.write = [write = sigma.write](Scenario& scenario, const std::string& id, double radius_m) {
        write(scenario, id, sigmaOfRadius95_m2(radius_m));
    };
    row.range = always({.low = 0, .high = std::floor(radius95_m(limits::kSigma_m2.high))});
    return row;
}

/** Returns the row that sets the usual sigma of a source, also for icebergs placed later. */
PickRow sourceRow()
{
    return {
        .words = {.key = u"icebergSource"_s,
                  .label = InspectorRows::tr("Seen by"),
                  .toolTip = InspectorRows::tr(
                      "Sets the usual uncertainty of this source, also for icebergs placed later."),
                  .undoText = InspectorRows::tr("Change uncertainty")},
        .options =
            [](const Scenario&) {
                std::vector<PickRow::Option> options{
                    {.value = {}, .text = InspectorRows::tr("as typed")}};
                for (const SightingSource source : kSightingSources)
                    options.push_back(
                        {.value = std::string(errorOf(source).name), .text = sourceName(source)});
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
    const FieldInputs<Iceberg> iceberg("icebergs.");
    const NumberRow sigma = iceberg.number("sigma0_m2");
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
        append(rows, {sigma, radius95Row(sigma)});
    else
        append(rows, {radius95Row(sigma), sigma});
    append(rows, {iceberg.number("q_m2ps"), sourceRow(),
                  InfoRow{.key = u"icebergDeviation"_s, .text = deviation}});
    return rows;
}

PickRow visitorRow()
{
    const TextRow uav = FieldInputs<Iceberg>("icebergs.", hasSeveralUavs).text("uav");
    return {.words = uav.words,
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
            .read = uav.read,
            .write = uav.write};
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

/** Returns the error of the predicted drift after some hours, where a track is recorded. */
QString driftErrorText(const Scenario& scenario, const std::string& id, const QLocale& locale)
{
    constexpr std::array<double, 6> kLeads_h{1, 3, 6, 12, 24, 48};
    constexpr double kHour_s = 3600;
    const Iceberg* iceberg = findById(scenario.icebergs, id);
    if (iceberg == nullptr || iceberg->track.empty())
        return {};
    const double known_s = std::min(iceberg->track.time_s.back(), kLeads_h.back() * kHour_s);
    if (known_s < kHour_s)
        return {};
    const auto index = static_cast<std::size_t>(iceberg - scenario.icebergs.data());
    const DriftTrack track =
        driftTrack(scenario, index, {.every_s = kHour_s, .duration_s = known_s});
    QStringList errors;
    for (const double lead_h : kLeads_h)
        for (const DriftTrackPoint& point : track.points)
            if (point.time_s == lead_h * kHour_s && point.error_m)
                errors << InspectorRows::tr("%1 h: %2 (1 σ: %3)", "time, error, deviation")
                              .arg(QString::number(lead_h), distanceText(*point.error_m, locale, 2),
                                   distanceText(point.sd_m, locale, 2));
    return errors.isEmpty()
               ? QString()
               : InspectorRows::tr("Error of the predicted drift") + u'\n' + errors.join(u'\n');
}

} // namespace

std::vector<InspectorRow> icebergRows()
{
    const FieldInputs<Iceberg> iceberg("icebergs.");
    std::vector<InspectorRow> rows = iceberg.rows("name");
    beginGroup(rows, u"icebergPositionGroup"_s, InspectorRows::tr("Position"));
    append(rows, positionRows<Iceberg>(u"iceberg"_s, "icebergs."));
    beginGroup(rows, u"icebergDriftGroup"_s, InspectorRows::tr("Drift"));
    append(rows, driftRows());
    beginGroup(rows, u"icebergUncertaintyGroup"_s, InspectorRows::tr("Uncertainty"));
    append(rows, uncertaintyRows());
    NumberRow observed = iceberg.number("observed_s");
    observed.unit = InspectorRows::tr(" s ago", "unit after a number");
    rows.emplace_back(observed);
    beginGroup(rows, u"icebergVisitGroup"_s, InspectorRows::tr("Size and visits"));
    append(rows, iceberg.rows("appears_s", "radius_m"));
    rows.emplace_back(visitorRow());
    rows.emplace_back(trackRow());
    rows.emplace_back(InfoRow{.key = u"icebergDriftError"_s, .text = driftErrorText});
    return rows;
}

} // namespace berg
