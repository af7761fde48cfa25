#pragma once

// Private to core/io: parts of the scenario file that the run file holds too.

#include "core/io/files/scenario_json.h"
#include "core/io/text/json_reader.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/scenario.h"

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace berg {

/**
 * Scenario of an object whose format and version are checked already. Notes what has the wrong
 * type, is missing or is wrong for this use; the value returned is whole only without faults.
 */
[[nodiscard]] Scenario readScenario(ObjectReader& object, ScenarioUse use = ScenarioUse::Flying);

/**
 * An object of a scenario file: Uav, Iceberg (their ids are empty when the file gives none), Asset,
 * NoFlyArea, AirspaceArea, GroundStation, Operation or Weather.
 */
template <class T>
[[nodiscard]] T readObject(const Json& value, const std::string& path, Faults& faults);
template <class T>
[[nodiscard]] std::string objectText(const T& object);

/** The scenario as an object whose braces stand at `indent`. */
[[nodiscard]] std::string scenarioText(const Scenario& scenario, int indent);

/**
 * Takes the members of an object from a file as `MemberWriter` puts them into it: functions with
 * either as parameter name every member once, in the order of the file.
 */
class MemberReader
{
public:
    explicit MemberReader(ObjectReader& object) : m_object(object) {}
    [[nodiscard]] ObjectReader& object() { return m_object; }

    void add(const char* name, double& value) { value = m_object.number(name, value); }
    void add(const char* name, bool& value) { value = m_object.boolean(name, value); }
    void add(const char* name, std::string& value) { value = m_object.text(name); }
    void add(const char* name, Point& value) { value = m_object.point(name, value); }
    void addSeed(std::int64_t& seed);
    /** A name that older files have for the member that follows. */
    void addOlder(const char* name, double& value) { add(name, value); }
    /** May not be left out: a wrong default would be flown without notice. */
    void addPosition(Point& position_m);
    /** At least 3 corners of a polygon; none when it is missing or unreadable. */
    void addCorners(std::vector<Point>& corners_m, bool isNeeded);

    template <class T>
    void addUnless(const char* name, T& value, const T& /*usual*/)
    {
        add(name, value);
    }
    void addOptional(const char* name, std::optional<double>& value)
    {
        value = m_object.optionalNumber(name);
    }
    template <class Enum, std::size_t Size>
    void addChoice(const char* name, Enum& value, const std::array<Named<Enum>, Size>& names,
                   std::optional<std::type_identity_t<Enum>> /*usual*/ = {})
    {
        value = m_object.choice(name, value, names);
    }
    template <class T>
    void addObject(const char* name, T& object)
    {
        if (const Json* value = m_object.find(name))
            object = readObject<T>(*value, m_object.path(name), m_object.faults());
    }
    template <class T>
    void addObject(const char* name, std::optional<T>& object)
    {
        if (const Json* value = m_object.find(name))
            object = readObject<T>(*value, m_object.path(name), m_object.faults());
    }
    template <class T>
    void addList(const char* name, std::vector<T>& entries, std::size_t most, bool isNeeded)
    {
        const Json* list = isNeeded ? m_object.neededArray(name) : m_object.array(name);
        if (list == nullptr)
            return;
        const std::string path = m_object.path(name);
        if (list->size() > most)
            m_object.faults().add(path,
                                  {IssueId::MostEntries, {countOf(most), countOf(list->size())}});
        else
            for (std::size_t i = 0; i < list->size(); ++i)
                entries.push_back(readObject<T>((*list)[i], entryPath(path, i), m_object.faults()));
    }
    /** An object whose members are those of something else. */
    template <class Members>
    void addPart(const char* name, std::string& extraJson, bool /*isUsual*/, const Members& members)
    {
        const Json* value = m_object.find(name);
        if (value == nullptr)
            return;
        ObjectReader object(*value, m_object.path(name), m_object.faults());
        MemberReader part(object);
        members(part);
        extraJson = object.unknown();
    }

private:
    ObjectReader& m_object;
};

/** See `MemberReader`; what is usual is left out. */
class MemberWriter : public JsonObject
{
public:
    /** Of an object whose braces stand at `indent`. */
    explicit MemberWriter(int indent = 0) : m_indent(indent) {}

    void addSeed(std::int64_t seed) { add("seed", seed); }
    void addOlder(const char* /*name*/, double /*value*/) {}
    void addPosition(const Point& position_m) { add("position_m", position_m); }
    void addCorners(const std::vector<Point>& corners_m, bool isNeeded)
    {
        if (isNeeded || !corners_m.empty())
            addText("area_m", jsonArrayOf(corners_m));
    }
    template <class Enum, std::size_t Size>
    void addChoice(const char* name, Enum value, const std::array<Named<Enum>, Size>& names,
                   std::optional<std::type_identity_t<Enum>> usual = {})
    {
        if (value != usual)
            add(name, nameOf(names, value));
    }
    template <class T>
    void addObject(const char* name, const T& object)
    {
        if (object != T())
            addText(name, objectText(object));
    }
    template <class T>
    void addObject(const char* name, const std::optional<T>& object)
    {
        if (object)
            addText(name, objectText(*object));
    }
    template <class T>
    void addList(const char* name, const std::vector<T>& entries, std::size_t /*most*/,
                 bool isNeeded)
    {
        if (isNeeded || !entries.empty())
            addText(name, jsonLines(textsOf(entries, &objectText<T>), m_indent + 1));
    }
    template <class Members>
    void addPart(const char* name, const std::string& extraJson, bool isUsual,
                 const Members& members)
    {
        MemberWriter part;
        members(part);
        part.addExtra(extraJson);
        if (!isUsual || !extraJson.empty())
            addText(name, part.inLine());
    }

private:
    int m_indent;
};

/** What members are taken into, or put from. */
template <class Io, class T>
using Held = std::conditional_t<std::is_same_v<Io, MemberWriter>, const T, T>;

} // namespace berg
