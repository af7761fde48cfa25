#pragma once

#include "core/base/find_by_id.h"
#include "core/scenario/validate.h"
#include "widgets/model/selection.h"
#include "widgets/panels/inspector/inspector_rows.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace berg {

// What the rows of icebergs, UAVs and the scenario have in common.

/** Context of the translations. */
struct InspectorRows
{
    Q_DECLARE_TR_FUNCTIONS(InspectorRows)
};

// Steps of the arrows.
inline constexpr double kVelocityStep_mps = 0.05;

/** The object of this kind in a scenario, constant or not; nullptr when there is none. */
template <class Object, class S>
[[nodiscard]] auto* objectIn(S& scenario, [[maybe_unused]] const std::string& id)
{
    if constexpr (std::is_same_v<Object, Iceberg>)
        return findById(scenario.icebergs, id);
    else if constexpr (std::is_same_v<Object, Uav>)
        return findById(scenario.uavs, id);
    else if constexpr (std::is_same_v<Object, NoFlyArea>) {
        const std::optional<std::size_t> place = noFlyPlace(id);
        return place && *place < scenario.noFly.size() ? &scenario.noFly[*place] : nullptr;
    } else
        return scenario.asset ? &*scenario.asset : nullptr;
}

inline auto always(const Limits& limits)
{
    return [limits](const Scenario&) { return limits; };
}

// What a row edits is a function of scenario, constant or not, and id: a pointer to it, nullptr
// when it is not there. A `member` is one, or gives a reference to one.

/** Of the object with the id. */
template <class Object, class Member>
auto memberOf(Member member)
{
    return [member](auto& scenario, const std::string& id) {
        auto* object = objectIn<Object>(scenario, id);
        return object == nullptr ? nullptr : &std::invoke(member, *object);
    };
}

/** Of the scenario itself. */
template <class Member>
auto ofScenario(Member member)
{
    return [member](auto& scenario, const std::string&) { return &std::invoke(member, scenario); };
}

/** Of something that the scenario may have. */
template <class Part, class Member>
auto ofPart(Part part, Member member)
{
    return [part, member](auto& scenario, const std::string&) {
        return scenario.*part ? &std::invoke(member, *(scenario.*part)) : nullptr;
    };
}

template <class Number>
NumberRow numberRow(const RowWords& words, const QString& unit, Number number,
                    const std::function<Limits(const Scenario&)>& range, double step = 1)
{
    return {.words = words,
            .unit = unit,
            .decimals = {.least = 0, .most = 1},
            .step = step,
            .read = [number](const Scenario& scenario, const std::string& id) -> double {
                const auto* held = number(scenario, id);
                return held == nullptr ? 0 : *held;
            },
            .write =
                [number](Scenario& scenario, const std::string& id, double value) {
                    if (auto* held = number(scenario, id))
                        *held = value;
                },
            .range = range};
}

template <class Object, class Member>
NumberRow objectRow(const RowWords& words, const QString& unit, Member member, const Limits& limits,
                    double step = 1)
{
    return numberRow(words, unit, memberOf<Object>(member), always(limits), step);
}

inline NumberRow uavRow(const RowWords& words, const QString& unit, double UavSpec::*member,
                        const Limits& limits, double step = 1)
{
    return objectRow<Uav>(
        words, unit, [member](auto& uav) -> auto& { return uav.spec.*member; }, limits, step);
}

template <class Member>
NumberRow scenarioRow(const RowWords& words, const QString& unit, Member member,
                      const std::function<Limits(const Scenario&)>& range)
{
    NumberRow row = numberRow(words, unit, ofScenario(member), range);
    row.decimals = {.least = 0, .most = 2};
    return row;
}

template <class Text>
TextRow textRow(const RowWords& words, Text text)
{
    return {.words = words,
            .read =
                [text](const Scenario& scenario, const std::string& id) {
                    const std::string* held = text(scenario, id);
                    return held == nullptr ? std::string() : *held;
                },
            .write =
                [text](Scenario& scenario, const std::string& id, const std::string& value) {
                    if (std::string* held = text(scenario, id))
                        *held = value;
                }};
}

inline FlagRow flagRow(const RowWords& words, bool Scenario::*flag)
{
    return {.words = words,
            .read = [flag](const Scenario& scenario) { return scenario.*flag; },
            .write = [flag](Scenario& scenario, bool on) { scenario.*flag = on; }};
}

/** The values of an enumeration of the core in the order of its declaration, or no and yes. */
template <class Value>
PickRow choiceRow(const RowWords& words, const QStringList& choices, Value value)
{
    using Enum = std::remove_pointer_t<decltype(value(std::declval<Scenario&>(), std::string()))>;
    std::vector<PickRow::Option> options;
    for (const QString& choice : choices)
        options.push_back({.value = std::to_string(options.size()), .text = choice});
    return {.words = words,
            .options = [options](const Scenario&) { return options; },
            .read =
                [value](const Scenario& scenario, const std::string& id) {
                    const Enum* held = value(scenario, id);
                    return std::to_string(held == nullptr ? 0 : static_cast<int>(*held));
                },
            .write =
                [value](Scenario& scenario, const std::string& id, const std::string& chosen) {
                    if (Enum* held = value(scenario, id))
                        *held = static_cast<Enum>(std::stoi(chosen));
                }};
}

/** A number that may be left out, which the lowest value of the field stands for; others are
 * `least` at least. */
template <class Read>
NumberRow optionalRow(const RowWords& words, const QString& unit, Read number, const Limits& limits,
                      const QString& noneText, double least = std::numeric_limits<double>::lowest())
{
    return {.words = words,
            .unit = unit,
            .decimals = {.least = 0, .most = 1},
            .read = [number, limits](const Scenario& scenario, const std::string& id) -> double {
                const auto* value = number(scenario, id);
                return value == nullptr ? limits.low : value->value_or(limits.low);
            },
            .write =
                [number, limits, least](Scenario& scenario, const std::string& id, double typed) {
                    if (auto* value = number(scenario, id))
                        *value = typed > limits.low ? std::optional(std::max(typed, least))
                                                    : std::nullopt;
                },
            .range = always(limits),
            .lowestText = noneText};
}

/** Whether icebergs are measured and filtered: what only then matters is shown only then. */
inline bool isFiltered(const Scenario& scenario, const std::string& /*id*/)
{
    return scenario.observer.model == ObserverModel::Kalman;
}

/** Whether the endurance of the UAV has a limit. */
inline bool isLimited(const Scenario& scenario, const std::string& id)
{
    const Uav* uav = findById(scenario.uavs, id);
    return uav != nullptr && uav->spec.endurance_s > 0;
}

inline bool hasUavsToldApart(const Scenario& scenario, const std::string& /*id*/)
{
    return areToldApart(scenario.uavs);
}

/** Where a UAV lands and how long it stands there; part of `uavRows`. */
[[nodiscard]] std::vector<InspectorRow> homeRows();

/** What is kept of a limited endurance; part of `uavRows`. */
[[nodiscard]] std::vector<InspectorRow> reserveRows();
/** Weather that a UAV is not flown in; part of `uavRows`. */
[[nodiscard]] std::vector<InspectorRow> weatherLimitRows();
/** Operation volume, papers and airspace; part of `scenarioRows`. */
[[nodiscard]] std::vector<InspectorRow> permitRows();
/** Weather and ground station; part of `scenarioRows`. */
[[nodiscard]] std::vector<InspectorRow> surroundingsRows();

template <class Object>
[[nodiscard]] TextRow nameRow(const QString& key);

/** East and north in metres, and the place on the globe they are; `kind` begins the keys. */
template <class Object>
[[nodiscard]] std::vector<InspectorRow> positionRows(const QString& kind);

/** A velocity: components as rows of SI numbers, and what else it takes to be a direction. */
struct VelocityRows
{
    NumberRow east;
    NumberRow north;
    QString key; ///< of the rows of speed and direction begins with it
    QString speedLabel;
    QString speedToolTip;
    QString directionLabel;
    QString directionToolTip;
    bool isFrom = false;           ///< the direction is where it comes from
    double componentLimit_mps = 0; ///< largest amount of a component
    double finest_mps = 0;         ///< components are multiples of it; 0: of nothing
    std::function<Limits(const Scenario&)> speeds_mps;
    InfoRow direction{}; ///< beside components; without `text` there is none
};

/** In the form of `shownUnits`. A direction is there only where there is a speed. */
[[nodiscard]] std::vector<InspectorRow> velocityRows(const VelocityRows& given);

/** "0.32 m/s towards 072°": the way it goes, as for currents. */
[[nodiscard]] QString towardsText(const Point& velocity_mps, const QLocale& locale);

/** A range of SI numbers in a unit: inside it with so many decimals. */
[[nodiscard]] Limits shownLimits(const Limits& limits, const ShownUnit& unit, int decimals);

/**
 * A row of metres or m/s as one in the unit of now; the row's `unit` is set too. What is typed is
 * converted exactly; nothing is converted where the unit is SI's.
 */
[[nodiscard]] NumberRow asDistance(NumberRow row);
[[nodiscard]] NumberRow asHeight(NumberRow row);
[[nodiscard]] NumberRow asSpeed(NumberRow row);

inline void append(std::vector<InspectorRow>& rows, std::vector<InspectorRow> more)
{
    std::move(more.begin(), more.end(), std::back_inserter(rows));
}

} // namespace berg
