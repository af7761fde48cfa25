#pragma once

#include "core/base/error.h"
#include "core/base/quantity.h"
#include "core/plan/solve/names.h"
#include "core/scenario/scenario.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

namespace berg {

/** Position of a field in a T: a plain function that returns a pointer to it. */
template <class T>
using FieldPlace =
    std::variant<double* (*)(T&), std::optional<double>* (*)(T&), std::int64_t* (*)(T&),
                 bool* (*)(T&), std::string* (*)(T&), Point* (*)(T&), std::optional<Point>* (*)(T&),
                 std::vector<Point>* (*)(T&), PolicyKind* (*)(T&), Route* (*)(T&), Backend* (*)(T&),
                 Formulation* (*)(T&), FovShape* (*)(T&), ObserverModel* (*)(T&),
                 SearchPattern* (*)(T&), AutopilotFirmware* (*)(T&), Airframe* (*)(T&),
                 TakeOffMethod* (*)(T&), MissionEnd* (*)(T&), CameraTrigger* (*)(T&)>;

/** Condition under which a file contains a field. */
enum class Presence
{
    UnlessDefault, ///< omitted if it has its default value
    Always,        ///< always written; a file without it sets the default
    Needed         ///< always written; a file without it is rejected
};

/** Details of how a field is written and how its input behaves. */
struct FieldTraits
{
    double step = 1; ///< step of the arrows of the input
    int leastDecimals = 0;
    int mostDecimals = 1;
    const char* noneText = ""; ///< text shown for the lowest value
    /**
     * Meaning of 0: of a number in memory, that the file has no such member; of an optional number
     * in a file, that it has no value.
     */
    bool zeroIsNone = false;
    Presence presence = Presence::UnlessDefault;
    const char* olderName = nullptr; ///< name of a number in older files
    bool isLong = false;             ///< text of several lines
    /**
     * English text of the page of fields (`fieldRows`), for a field without help, or whose help is
     * about the input and not about the file. Null means the help.
     */
    const char* note = nullptr;
};

/** Context of the translations of labels, help and notes. */
inline constexpr const char* kFieldContext = "berg::Fields";

/** Complete description of one field of a T, used by files, checks, inputs and pages. */
template <class T>
struct Field
{
    const char* name = ""; ///< name in files
    FieldPlace<T> place;
    Quantity quantity = Quantity::Text;
    /**
     * Limits of the number, or of both numbers of a pair. Nullopt if it is checked with other
     * fields or is not a number.
     */
    std::optional<Limits> limits{};
    FieldTraits traits{};
    const char* label = ""; ///< English source text; the window looks up its translation
    const char* help = "";
    const char* label2 = ""; ///< label of the second number of a pair
    const char* help2 = "";
};

/**
 * Returns the fields of an object in the order of the file. The fields of a scenario exclude its
 * objects.
 */
template <class T>
[[nodiscard]] std::span<const Field<T>> fieldsOf();
/** Returns the fields of the file's object `planner`, which a scenario stores in several places. */
[[nodiscard]] std::span<const Field<Scenario>> plannerFields();

/** Part of a scenario file that is no single field, or that needs an explanation as a whole. */
struct ObjectPart
{
    std::string_view path;    ///< "no_fly[]"
    const char* meaning = ""; ///< English text of the page of fields
};
/** Returns these parts; a file may lack each of them. */
[[nodiscard]] std::span<const ObjectPart> objectParts();

/**
 * Returns the fields of a table from the one named `first` to the one named `last`, both included.
 * Throws `std::logic_error` if a name is missing.
 */
template <class T>
[[nodiscard]] std::span<const Field<T>> between(std::span<const Field<T>> fields,
                                                std::string_view first, std::string_view last)
{
    const auto place = [&](std::string_view name) {
        const auto it = std::ranges::find(fields, name, &Field<T>::name);
        require(it != fields.end(), "a field of the object");
        return static_cast<std::size_t>(it - fields.begin());
    };
    return fields.subspan(place(first), place(last) - place(first) + 1);
}

/**
 * Calls `use(path, fields)` for each object of a scenario file, with a `path` such as "uavs[].".
 */
template <class Use>
void forEachObject(const Use& use)
{
    use("", fieldsOf<Scenario>());
    use("origin.", fieldsOf<LatLon>());
    use("no_fly[].", fieldsOf<NoFlyArea>());
    use("airspace[].", fieldsOf<AirspaceArea>());
    use("ice_chart.", fieldsOf<IceChart>());
    use("ice_chart.areas[].", fieldsOf<IceArea>());
    use("operation.", fieldsOf<Operation>());
    use("uavs[].", fieldsOf<Uav>());
    use("icebergs[].", fieldsOf<Iceberg>());
    use("asset.", fieldsOf<Asset>());
    use("weather.", fieldsOf<Weather>());
    use("forecast.places[].", fieldsOf<Forecast>());
    use("forecast.places[].series[].", fieldsOf<ForecastEntry>());
    use("ground_station.", fieldsOf<GroundStation>());
    use("observer.", fieldsOf<ObserverSpec>());
    use("planner.", plannerFields());
}

/** Returns true if a field is a pair of numbers. */
template <class T>
[[nodiscard]] bool isPair(const Field<T>& field)
{
    return std::holds_alternative<Point* (*)(T&)>(field.place) ||
           std::holds_alternative<std::optional<Point>* (*)(T&)>(field.place);
}

/** Returns whether a field is a list of points. */
template <class T>
[[nodiscard]] bool isList(const Field<T>& field)
{
    return std::holds_alternative<std::vector<Point>* (*)(T&)>(field.place);
}

/** Calls `use` with a reference to the field of the object. */
template <class T, class Use>
void withField(const Field<T>& field, T& object, const Use& use)
{
    std::visit([&](auto place) { use(*place(object)); }, field.place);
}
/** Calls `use` with a constant reference to the field of the object. */
template <class T, class Use>
void withField(const Field<T>& field, const T& object, const Use& use)
{
    // Field locations only point into the object, and the reference is made constant again.
    std::visit([&](auto place) { use(std::as_const(*place(const_cast<T&>(object)))); },
               field.place);
}

/** Returns true if both objects have the same value in the field. */
template <class T>
[[nodiscard]] bool isEqual(const Field<T>& field, const T& one, const T& other)
{
    return std::visit(
        [&](auto place) { return *place(const_cast<T&>(one)) == *place(const_cast<T&>(other)); },
        field.place);
}

inline constexpr std::array<Named<FovShape>, 3> kFovShapeNames{{
    {FovShape::Body, "body"},
    {FovShape::North, "north"},
    {FovShape::Disk, "disk"},
}};
inline constexpr std::array<Named<ObserverModel>, 2> kObserverNames{{
    {ObserverModel::Simple, "simple"},
    {ObserverModel::Kalman, "kalman"},
}};
inline constexpr std::array<Named<SearchPattern>, 3> kSearchNames{{
    {SearchPattern::None, "none"},
    {SearchPattern::Square, "square"},
    {SearchPattern::Sector, "sector"},
}};
inline constexpr std::array<Named<AutopilotFirmware>, 2> kFirmwareNames{{
    {AutopilotFirmware::ArduPilot, "ardupilot"},
    {AutopilotFirmware::Px4, "px4"},
}};
inline constexpr std::array<Named<Airframe>, 3> kAirframeNames{{
    {Airframe::FixedWing, "fixed-wing"},
    {Airframe::Vtol, "vtol"},
    {Airframe::Multirotor, "multirotor"},
}};
inline constexpr std::array<Named<TakeOffMethod>, 2> kTakeOffNames{{
    {TakeOffMethod::Item, "item"},
    {TakeOffMethod::Hand, "hand"},
}};
inline constexpr std::array<Named<MissionEnd>, 3> kMissionEndNames{{
    {MissionEnd::Return, "return"},
    {MissionEnd::Landing, "landing"},
    {MissionEnd::Loiter, "loiter"},
}};
inline constexpr std::array<Named<CameraTrigger>, 3> kCameraNames{{
    {CameraTrigger::None, "none"},
    {CameraTrigger::Distance, "distance"},
    {CameraTrigger::Time, "time"},
}};

// The overloads of `namesOf` return the names in files of the values of a choice.
constexpr const auto& namesOf(PolicyKind /*value*/)
{
    return kPolicyNames;
}
constexpr const auto& namesOf(Route /*value*/)
{
    return kRouteNames;
}
constexpr const auto& namesOf(Backend /*value*/)
{
    return kBackendNames;
}
constexpr const auto& namesOf(Formulation /*value*/)
{
    return kFormulationNames;
}
constexpr const auto& namesOf(FovShape /*value*/)
{
    return kFovShapeNames;
}
constexpr const auto& namesOf(ObserverModel /*value*/)
{
    return kObserverNames;
}
constexpr const auto& namesOf(SearchPattern /*value*/)
{
    return kSearchNames;
}
constexpr const auto& namesOf(AutopilotFirmware /*value*/)
{
    return kFirmwareNames;
}
constexpr const auto& namesOf(Airframe /*value*/)
{
    return kAirframeNames;
}
constexpr const auto& namesOf(TakeOffMethod /*value*/)
{
    return kTakeOffNames;
}
constexpr const auto& namesOf(MissionEnd /*value*/)
{
    return kMissionEndNames;
}
constexpr const auto& namesOf(CameraTrigger /*value*/)
{
    return kCameraNames;
}

} // namespace berg
