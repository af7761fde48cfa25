#include "widgets/panels/inspector/field_inputs.h"

using namespace Qt::StringLiterals;

namespace berg {

std::vector<InspectorRow> observerRows()
{
    constexpr double kPercent = 100;
    const FieldInputs<ObserverSpec> observer("observer.");
    const FieldInputs<ObserverSpec> filter("observer.", isFiltered);
    NumberRow interval = filter.number("interval_s");
    interval.range = [](const Scenario& scenario) {
        return Limits{.low = scenario.dt_s, .high = limits::kSensorInterval_s.high};
    };
    NumberRow detection = filter.number("detection");
    detection.unit = u" %"_s;
    detection.read = [](const Scenario& scenario, const std::string&) {
        return kPercent * scenario.observer.detection;
    };
    detection.write = [](Scenario& scenario, const std::string&, double value) {
        scenario.observer.detection = value / kPercent;
    };
    detection.range = always({.low = 0.1, .high = kPercent});
    return {
        observer.choice("model", {InspectorRows::tr("exact"), InspectorRows::tr("Kalman filter")}),
        filter.number("position_sd_m"), interval, detection,
        filter.choice("search", {InspectorRows::tr("none"), InspectorRows::tr("expanding square"),
                                 InspectorRows::tr("sectors")})};
}

} // namespace berg
