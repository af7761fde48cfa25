#include "widgets/panels/inspector/inspector_row_makers.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPercent = 100;

NumberRow measurementRow()
{
    NumberRow row = scenarioRow(
        {.key = u"observerPositionSd"_s,
         .label = InspectorRows::tr("Position error"),
         .toolTip =
             InspectorRows::tr("Standard deviation of a measured position, along each axis."),
         .undoText = InspectorRows::tr("Change position error"),
         .isShown = isFiltered},
        u" m"_s, [](auto& scenario) -> auto& { return scenario.observer.positionSd_m; },
        always(limits::kLength_m));
    row.decimals = {.least = 0, .most = 1};
    return row;
}

NumberRow intervalRow()
{
    NumberRow row = scenarioRow(
        {.key = u"observerInterval"_s,
         .label = InspectorRows::tr("Sensor interval"),
         .toolTip =
             InspectorRows::tr("Time between two samples of the sensor, each of which measures "
                               "what is in view."),
         .undoText = InspectorRows::tr("Change sensor interval"),
         .isShown = isFiltered},
        u" s"_s, [](auto& scenario) -> auto& { return scenario.observer.interval_s; },
        [](const Scenario& scenario) {
            return Limits{.low = scenario.dt_s, .high = limits::kSensorInterval_s.high};
        });
    row.decimals = {.least = 0, .most = 3};
    return row;
}

NumberRow detectionRow()
{
    return {
        .words = {.key = u"observerDetection"_s,
                  .label = InspectorRows::tr("Detection probability"),
                  .toolTip = InspectorRows::tr("Chance that one sample shows an iceberg in view."),
                  .undoText = InspectorRows::tr("Change detection probability"),
                  .isShown = isFiltered},
        .unit = u" %"_s,
        .decimals = {.least = 0, .most = 1},
        .step = 5,
        .read = [](const Scenario& scenario,
                   const std::string&) { return kPercent * scenario.observer.detection; },
        .write = [](Scenario& scenario, const std::string&,
                    double value) { scenario.observer.detection = value / kPercent; },
        .range = always({.low = 0.1, .high = kPercent})};
}

} // namespace

std::vector<InspectorRow> observerRows()
{
    return {
        choiceRow(
            {.key = u"observerModel"_s,
             .label = InspectorRows::tr("Observer"),
             .toolTip = InspectorRows::tr("Exact: an iceberg in view is where it is seen. "
                                          "Filter: noisy measurements, from which position and "
                                          "velocity are estimated, and icebergs can get lost."),
             .undoText = InspectorRows::tr("Change observer")},
            {InspectorRows::tr("exact"), InspectorRows::tr("Kalman filter")},
            ofScenario([](auto& scenario) -> auto& { return scenario.observer.model; })),
        measurementRow(), intervalRow(), detectionRow(),
        choiceRow(
            {.key = u"observerSearch"_s,
             .label = InspectorRows::tr("Search"),
             .toolTip = InspectorRows::tr("Pattern that finds an iceberg which was not where it "
                                          "was believed to be."),
             .undoText = InspectorRows::tr("Change search"),
             .isShown = isFiltered},
            {InspectorRows::tr("none"), InspectorRows::tr("expanding square"),
             InspectorRows::tr("sectors")},
            ofScenario([](auto& scenario) -> auto& { return scenario.observer.search; }))};
}

} // namespace berg
