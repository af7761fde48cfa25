// Prints the JSON Schema of scenario files, or with the argument "fields" the page of their fields.
// Both are made of the tables of the fields.

#include "core/io/files/field_rows.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/fields.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <limits>
#include <map>

using namespace berg;

namespace {

constexpr const char* kDescription =
    "Members that are not named here are kept and written back. What fields must be to each other "
    "(times rising, a UAV inside its geofence, ids that differ) a schema cannot say: bergwatch-cli "
    "validate does.";

std::string numberSchema(const char* type, const std::optional<Limits>& limits)
{
    JsonObject schema;
    schema.add("type", type);
    if (limits && limits->high < std::numeric_limits<double>::max()) {
        schema.add(limits->above ? "exclusiveMinimum" : "minimum", limits->low);
        schema.add("maximum", limits->high);
    }
    return schema.inLine();
}

std::string listSchema(const std::string& items, std::size_t least, std::size_t most)
{
    JsonObject schema;
    schema.add("type", "array");
    schema.addText("items", items);
    schema.add("minItems", least);
    schema.add("maxItems", most);
    return schema.inLine();
}

std::string reference(const std::string& name)
{
    return R"({"$ref": "#/$defs/)" + name + "\"}";
}

/** Schema of a field with a value of this type. */
template <class T, class Value>
std::string fieldSchema(const Field<T>& field, const Value& value)
{
    std::string number = numberSchema("number", field.limits);
    if constexpr (std::is_same_v<Value, std::int64_t>) {
        return numberSchema("integer", field.limits);
    } else if constexpr (std::is_same_v<Value, bool>) {
        return R"({"type": "boolean"})";
    } else if constexpr (std::is_same_v<Value, std::string>) {
        if (field.quantity == Quantity::Utc)
            return R"({"type": "string", "pattern": "^$|^[0-9]{4}-[0-9]{2}-[0-9]{2}T.*Z$"})";
        return std::string_view(field.name) == "id" ? R"({"type": "string", "minLength": 1})"
                                                    : R"({"type": "string"})";
    } else if constexpr (std::is_same_v<Value, Point> ||
                         std::is_same_v<Value, std::optional<Point>>) {
        return listSchema(number, 2, 2);
    } else if constexpr (std::is_same_v<Value, std::vector<Point>>) {
        return listSchema(listSchema(number, 2, 2), 3, kMostAreaCorners);
    } else if constexpr (std::is_enum_v<Value>) {
        return R"({"enum": )" +
               jsonArray(textsOf(namesOf(value),
                                 [](const auto& named) { return jsonText(named.name); })) +
               '}';
    } else {
        return number;
    }
}

using Properties = std::map<std::string, std::string>; ///< schemas by name

/** Schema of an object with these fields and `others`, which are not in the table. */
template <class T>
std::string objectSchema(std::span<const Field<T>> fields, const Properties& others = {},
                         std::vector<std::string> needed = {})
{
    static const T standard;
    JsonObject properties;
    for (const auto& [name, schema] : others)
        properties.addText(name, schema);
    for (const Field<T>& field : fields)
        withField(field, standard, [&](const auto& value) {
            const std::string schema = fieldSchema(field, value);
            properties.addText(field.name, schema);
            if (field.traits.olderName != nullptr)
                properties.addText(field.traits.olderName, schema);
            if (field.traits.presence == Presence::Needed)
                needed.emplace_back(field.name);
        });
    JsonObject schema;
    schema.add("type", "object");
    if (!needed.empty())
        schema.addText("required", jsonArrayOf(needed));
    schema.addText("properties", properties.inLine());
    return schema.inLine();
}

/** An object with a member for each axis of the record. */
std::string trackSchema()
{
    const auto listOf = [](const std::string& items) {
        return listSchema(items, 2, kMostTrackPoints);
    };
    const std::string place = numberSchema("number", limits::kCoordinate_m);
    return R"({"type": "object", "required": ["time_s", "position_m"], "properties": {"time_s": )" +
           listOf(numberSchema("number", limits::kTrackTime_s)) + R"(, "position_m": )" +
           listOf(listSchema(place, 2, 2)) + "}}";
}

/** A forecast: a grid of places, each with its series. */
std::string forecastSchema()
{
    const std::string time = R"({"type": "string", "pattern": "^[0-9]{4}-[0-9]{2}-[0-9]{2}T.*Z$"})";
    const std::string entry = objectSchema(fieldsOf<ForecastEntry>(), {{"time", time}}, {"time"});
    const std::string place = objectSchema(
        fieldsOf<Forecast>(), {{"series", listSchema(entry, 1, kMostForecastEntries)}}, {"series"});
    JsonObject properties;
    properties.addText("source", R"({"type": "string"})");
    properties.addText("issued", time);
    properties.addText("columns", R"({"type": "integer", "minimum": 1})");
    properties.addText("places", listSchema(place, 1, kMostForecastPlaces));
    JsonObject schema;
    schema.add("type", "object");
    schema.addText("required", R"(["places"])");
    schema.addText("properties", properties.inLine());
    return schema.inLine();
}

/** An ice chart with its areas, and their outlines in lists of corners. */
std::string iceChartSchema()
{
    const std::string corner = listSchema(numberSchema("number", limits::kCoordinate_m), 2, 2);
    const std::string outline = listSchema(corner, 3, kMostIceCorners);
    const std::string area =
        objectSchema(fieldsOf<IceArea>(), {{"outlines_m", listSchema(outline, 1, kMostIceCorners)}},
                     {"outlines_m"});
    return objectSchema(fieldsOf<IceChart>(), {{"areas", listSchema(area, 0, kMostIceAreas)}},
                        {"areas"});
}

std::string scenarioObject()
{
    return objectSchema(fieldsOf<Scenario>(),
                        {{"format", R"({"const": "bergwatch-scenario"})"},
                         {"version", R"({"const": 1})"},
                         {"origin", objectSchema(fieldsOf<LatLon>())},
                         {"no_fly", listSchema(reference("no_fly"), 0, kMostNoFlyAreas)},
                         {"airspace", listSchema(reference("airspace"), 0, kMostAirspaceAreas)},
                         {"ice_chart", reference("ice_chart")},
                         {"operation", objectSchema(fieldsOf<Operation>())},
                         {"uavs", listSchema(reference("uav"), 1, kMostUavs)},
                         {"icebergs", listSchema(reference("iceberg"), 0, kMostIcebergs)},
                         {"asset", reference("asset")},
                         {"weather", objectSchema(fieldsOf<Weather>())},
                         {"forecast", forecastSchema()},
                         {"ground_station", objectSchema(fieldsOf<GroundStation>())},
                         {"observer", objectSchema(fieldsOf<ObserverSpec>())},
                         {"planner", objectSchema(plannerFields())}},
                        {"uavs", "icebergs"});
}

} // namespace

int main(int count, char* arguments[])
{
    if (count > 1 && std::string_view(arguments[1]) == "fields") {
        std::cout << "# Fields of Bergwatch scenarios (.berg)\n\n" << fieldTable();
        return 0;
    }
    JsonObject parts;
    parts.addText("number2", listSchema(numberSchema("number", {}), 2, 2)); // of run files
    parts.addText("policy", fieldSchema(plannerFields().front(), PolicyKind::Visitation));
    parts.addText("scenario", scenarioObject());
    parts.addText("airspace", objectSchema(fieldsOf<AirspaceArea>()));
    parts.addText("ice_chart", iceChartSchema());
    parts.addText("uav", objectSchema(fieldsOf<Uav>()));
    parts.addText("iceberg", objectSchema(fieldsOf<Iceberg>(), {{"track", trackSchema()}}));
    parts.addText("asset", objectSchema(fieldsOf<Asset>()));
    parts.addText("no_fly", objectSchema(fieldsOf<NoFlyArea>()));
    JsonObject schema;
    schema.add("$schema", "https://json-schema.org/draft/2020-12/schema");
    schema.add("$id", "bergwatch-scenario.schema.json");
    schema.add("title", "Bergwatch scenario (.berg)");
    schema.add("description", kDescription);
    schema.add("type", "object");
    schema.addText("required", R"(["format", "version"])");
    schema.add("$ref", "#/$defs/scenario");
    schema.addText("$defs", parts.inLine());
    std::cout << jsonText(nlohmann::ordered_json::parse(schema.inLine()), 2) << '\n';
}
