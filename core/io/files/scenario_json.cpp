#include "core/io/files/scenario_json.h"

#include "core/checks/validate.h"
#include "core/io/files/members.h"
#include "core/io/text/atomic_file.h"

#include <set>

namespace berg {

namespace {

constexpr std::string_view kFormat = "bergwatch-scenario";

/** Reads the members of a scenario in the layout of `Writer`. */
struct Reader : MemberReader
{
    template <class T>
    void fields(std::span<const Field<T>> fields, T& of)
    {
        readFields(object, fields, of);
    }
    template <class T>
    void part(const char* name, std::span<const Field<T>> fields, T& of, std::string& extraJson,
              bool /*isUsual*/ = false)
    {
        const Json* value = object.find(name);
        if (value == nullptr)
            return;
        ObjectReader members(*value, object.path(name), object.faults());
        readFields(members, fields, of);
        extraJson = members.unknown();
    }
    template <class T>
    void list(const char* name, std::vector<T>& entries, std::size_t most, bool isNeeded)
    {
        const Json* list = isNeeded ? object.neededArray(name) : object.array(name);
        const std::string path = object.path(name);
        if (list != nullptr && list->size() > most)
            object.faults().add(path,
                                {IssueId::MostEntries, {countOf(most), countOf(list->size())}});
        else
            for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
                entries.push_back(readObject<T>((*list)[i], entryPath(path, i), object.faults()));
    }
};

/** Writes the members of a scenario; values equal to their default are left out. */
struct Writer : MemberWriter
{
    Writer(JsonObject& into, int indentBy) : MemberWriter{into}, indent(indentBy) {}

    int indent = 0;

    template <class T>
    void fields(std::span<const Field<T>> fields, const T& of)
    {
        writeFields(object, fields, of);
    }
    template <class T>
    void part(const char* name, std::span<const Field<T>> fields, const T& of,
              const std::string& extraJson, bool isUsual = false)
    {
        JsonObject members;
        writeFields(members, fields, of);
        members.addExtra(extraJson);
        if (!isUsual || !extraJson.empty())
            object.addText(name, members.inLine());
    }
    template <class T>
    void list(const char* name, const std::vector<T>& entries, std::size_t /*most*/, bool isNeeded)
    {
        if (isNeeded || !entries.empty())
            object.addText(name, jsonLines(textsOf(entries, &objectText<T>), indent + 1));
    }
};

/** Visits all members but `format` and `version`, in the order of the file. */
template <class Io, class S>
void members(Io io, S& scenario)
{
    const auto own = [](std::string_view first, std::string_view last) {
        return between(fieldsOf<Scenario>(), first, last);
    };
    io.fields(own("name", "notes"), scenario);
    io.part("origin", fieldsOf<LatLon>(), scenario.origin, scenario.originExtraJson);
    io.fields(own("start_utc", "geofence"), scenario);
    io.list("no_fly", scenario.noFly, kMostNoFlyAreas, false);
    io.list("airspace", scenario.airspace, kMostAirspaceAreas, false);
    io.one("ice_chart", scenario.iceChart);
    io.one("operation", scenario.operation);
    io.fields(own("separation_m", "separation_m"), scenario);
    io.list("uavs", scenario.uavs, kMostUavs, true);
    io.list("icebergs", scenario.icebergs, kMostIcebergs, true);
    io.one("asset", scenario.asset);
    io.one("weather", scenario.weather);
    io.one("forecast", scenario.forecast);
    io.one("ground_station", scenario.groundStation);
    io.part("observer", fieldsOf<ObserverSpec>(), scenario.observer, scenario.observerExtraJson,
            scenario.observer == ObserverSpec());
    io.part("planner", plannerFields(), scenario, scenario.plannerExtraJson);
}

/** Gives entries without an id the name of their row, or the next free name if that is taken. */
template <class Entry>
void nameByRow(std::vector<Entry>& entries, const Json* list, const std::string& prefix,
               std::set<std::string>& taken)
{
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Json& value = (*list)[i];
        if (value.is_object() && value.contains("id"))
            continue;
        std::string id = prefix + std::to_string(i + 1);
        for (std::size_t n = entries.size() + 1; taken.contains(id); ++n)
            id = prefix + std::to_string(n);
        taken.insert(id);
        entries[i].id = std::move(id);
    }
}

void nameUnnamed(Scenario& scenario, ObjectReader& object)
{
    std::set<std::string> taken;
    for (const Uav& uav : scenario.uavs)
        taken.insert(uav.id);
    for (const Iceberg& iceberg : scenario.icebergs)
        taken.insert(iceberg.id);
    nameByRow(scenario.uavs, object.find("uavs"), "uav-", taken);
    nameByRow(scenario.icebergs, object.find("icebergs"), "berg-", taken);
}

/** Adds errors for this use, except about members that are faulty already. */
void addFindings(const Scenario& scenario, ObjectReader& object, ScenarioUse use)
{
    if (!object.isObject())
        return;
    for (Issue& issue : use == ScenarioUse::Flying ? validate(scenario) : unreadable(scenario)) {
        std::string path = object.path("") + issue.field;
        if (issue.severity == Severity::Error && !object.faults().has(path))
            object.faults().add(std::move(path), std::move(issue.reason));
    }
}

} // namespace

Scenario readScenario(ObjectReader& object, ScenarioUse use)
{
    Scenario scenario;
    checkFormat(object, kFormat);
    members(Reader{{object}}, scenario);
    scenario.extraJson = object.unknown();
    nameUnnamed(scenario, object);
    addFindings(scenario, object, use);
    return scenario;
}

std::string scenarioText(const Scenario& scenario, int indent)
{
    JsonObject object;
    object.add("format", kFormat);
    object.add("version", 1);
    members(Writer(object, indent), scenario);
    object.addExtra(scenario.extraJson);
    return object.inLines(indent);
}

Scenario scenarioFromJson(std::string_view text, const std::string& subject, ScenarioUse use,
                          const std::stop_token& stop)
{
    ReadBudget budget(subject, text.size(), stop);
    ParsedJson file = parseJson(text, budget);
    requireFormat(file, kFormat, subject);
    ObjectReader object(file.root, "", file.faults);
    Scenario scenario = readScenario(object, use);
    file.faults.throwIfAny(subject);
    return scenario;
}

std::string scenarioToJson(const Scenario& scenario)
{
    return scenarioText(scenario, 0) + '\n';
}

Scenario loadScenario(const std::string& path, ScenarioUse use)
{
    return scenarioFromJson(readFile(path), path, use);
}

} // namespace berg
