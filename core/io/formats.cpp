#include "core/io/formats.h"

#include "core/io/geojson.h"
#include "core/io/plan_csv.h"
#include "core/io/plan_qgc.h"
#include "core/io/plan_wpl.h"
#include "core/io/result_csv.h"

#include <algorithm>
#include <array>

namespace berg {

namespace {

std::string csv(const ExportSource& source)
{
    return source.mission ? trajectoryCsv(*source.mission) : planCsv(source.scenario, source.plan);
}

constexpr std::array kFormats{
    ExportFormat{"plan", "plan", "QGroundControl, Mission Planner, MAVSDK", qgcPlan},
    ExportFormat{"wpl", "waypoints", "ArduPilot: Mission Planner, MAVProxy (home row)", wplText},
    ExportFormat{"geojson", "geojson", "QGIS and other map programs", geoJson},
    ExportFormat{"csv", "csv", "spreadsheets and scripts", csv}};

} // namespace

std::span<const ExportFormat> exportFormats()
{
    return kFormats;
}

const ExportFormat* findExportFormat(std::string_view id)
{
    const auto it = std::find_if(kFormats.begin(), kFormats.end(),
                                 [&](const ExportFormat& format) { return format.id == id; });
    return it == kFormats.end() ? nullptr : &*it;
}

} // namespace berg
