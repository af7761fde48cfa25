#include "core/io/results/drift_result.h"

#include "core/base/number_text.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/utc_time.h"

namespace berg {

namespace {

/** A name and its number as text, rounded to what a prediction is worth. */
struct Cell
{
    std::string_view name;
    std::string text;
};

std::vector<Cell> cellsOf(const DriftPoint& point)
{
    return {{"latitude_deg", fixedText(point.place.latitude_deg, 5)},
            {"longitude_deg", fixedText(point.place.longitude_deg, 5)},
            {"speed_mps", fixedText(point.velocity_mps.norm(), 4)},
            {"direction_deg", fixedText(directionTo_deg(point.velocity_mps), 1)}};
}

std::vector<Cell> cellsOf(const DriftLeadError& error)
{
    const auto km = [&](double distance_m) {
        return error.starts > 0 ? fixedText(distance_m / 1000, 3) : std::string();
    };
    return {{"lead_h", numberText(error.lead_s / 3600)},
            {"starts", std::to_string(error.starts)},
            {"moved_km", km(error.moved_m)},
            {"drift_km", km(error.drift_m)},
            {"last_velocity_km", km(error.lastVelocity_m)}};
}

/** Adds the cells to the object; an empty one is null. */
void addCells(JsonObject& json, const std::vector<Cell>& cells)
{
    for (const Cell& cell : cells)
        json.addText(cell.name, cell.text.empty() ? "null" : cell.text);
}

std::string joinedCells(const std::vector<Cell>& cells, std::string_view Cell::*part)
{
    std::string line;
    for (const Cell& cell : cells)
        line.append(line.empty() ? "" : ",").append(cell.*part);
    return line;
}

std::string row(const std::vector<Cell>& cells)
{
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i)
        line += (i > 0 ? "," : "") + cells[i].text;
    return line + '\n';
}

} // namespace

std::string utcTextOf(double time_s)
{
    return utcText(UtcTime(), time_s);
}

std::string driftJson(const DriftReport& report)
{
    JsonObject json;
    json.add("length_m", report.dimensions.length_m);
    json.add("draft_m", report.dimensions.draft_m);
    json.add("sail_m2", report.dimensions.sail_m2);
    json.add("current_share", report.law.currentShare);
    json.add("wind_share", report.law.windShare);
    json.add("turn_deg", report.law.turn_deg);
    if (report.velocity_mps) {
        json.add("speed_mps", report.velocity_mps->norm());
        json.add("direction_deg", directionTo_deg(*report.velocity_mps));
    }
    if (!report.path.empty())
        json.addText("path", jsonLines(textsOf(report.path,
                                               [](const DriftPoint& point) {
                                                   JsonObject entry;
                                                   entry.add("time", utcTextOf(point.time_s));
                                                   addCells(entry, cellsOf(point));
                                                   return entry.inLine();
                                               }),
                                       1));
    if (!report.errors.empty())
        json.addText("errors", jsonLines(textsOf(report.errors,
                                                 [](const DriftLeadError& error) {
                                                     JsonObject entry;
                                                     addCells(entry, cellsOf(error));
                                                     return entry.inLine();
                                                 }),
                                         1));
    return json.inLines(0) + '\n';
}

std::string driftPathCsv(const std::vector<DriftPoint>& path)
{
    std::string text = "time," + joinedCells(cellsOf(DriftPoint{}), &Cell::name) + '\n';
    for (const DriftPoint& point : path)
        text += utcTextOf(point.time_s) + ',' + row(cellsOf(point));
    return text;
}

std::string driftErrorsCsv(const std::vector<DriftLeadError>& errors)
{
    std::string text = joinedCells(cellsOf(DriftLeadError{}), &Cell::name) + '\n';
    for (const DriftLeadError& error : errors)
        text += row(cellsOf(error));
    return text;
}

} // namespace berg
