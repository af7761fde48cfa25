#pragma once

#include "core/scenario/scenario.h"
#include "core/scenario/text_checks.h"
#include "widgets/panels/fields/number_field.h"

#include <QLocale>
#include <QString>
#include <QStringList>

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace berg {

class ScenarioDocument;

// Editable values of the Inspector, as data. `id` is the id of the object; rows about the scenario
// ignore it. `key` names the input and the gesture of its edits.

/** Texts common to all rows. */
struct RowWords
{
    QString key;
    QString label;
    QString toolTip;
    QString undoText;
    /**
     * Returns whether the row matters to the object; null means always. With several objects it is
     * shown if it matters to one.
     */
    std::function<bool(const Scenario&, const std::string& id)> isShown{};
};

using ReadText = std::function<QString(const Scenario&, const std::string& id, const QLocale&)>;

struct NumberRow
{
    RowWords words;
    QString unit;
    Decimals decimals;
    double step = 1;
    std::function<double(const Scenario&, const std::string& id)> read;
    std::function<void(Scenario&, const std::string& id, double)> write;
    /** Closed range within which `validate` accepts the number, other values unchanged. */
    std::function<Limits(const Scenario&)> range;
    QString lowestText; ///< shown in place of the lowest value; empty shows the number
};

struct TextRow
{
    RowWords words;
    bool multiLine = false;
    std::function<std::string(const Scenario&, const std::string& id)> read;
    std::function<void(Scenario&, const std::string& id, const std::string&)> write;
};

/** A text with a syntax of its own, checked when typing ends. */
struct EntryRow
{
    RowWords words;
    ReadText read;
    /** Applies the text, or changes nothing and returns the reason. */
    std::function<QString(Scenario&, const std::string& id, const QString& text, const QLocale&)>
        apply;
    /** Returns why several objects cannot have the same text; null if they can. */
    std::function<QString(const QString& text)> faultForSeveral{};
    QString placeholder{}; ///< shown in an empty line
};

struct FlagRow
{
    RowWords words;
    std::function<bool(const Scenario&, const std::string& id)> read;
    std::function<void(Scenario&, const std::string& id, bool)> write;
};

/** A choice from a list that depends on the scenario; objects that differ show no choice. */
struct PickRow
{
    struct Option
    {
        std::string value;
        QString text;
        bool operator==(const Option&) const = default;
    };
    RowWords words;
    std::function<std::vector<Option>(const Scenario&)> options;
    std::function<std::string(const Scenario&, const std::string& id)> read;
    std::function<void(Scenario&, const std::string& id, const std::string&)> write;
    /** Called when the user has chosen; may be null. */
    std::function<void(ScenarioDocument&, const std::string&)> chosen{};
};

/** A button. */
struct ActionRow
{
    RowWords words; ///< `undoText` is the text of the button
    std::function<void(Scenario&)> act;
};

/** An optional part of an object: a text about it, and a button that removes it. */
struct PartRow
{
    RowWords words;
    QString removeText; ///< text of the button
    /**
     * Returns an empty text if the object has no such part; the row is hidden if no object has one.
     */
    ReadText text;
    std::function<void(Scenario&, const std::string& id)> remove;
};

/** A read-only value derived from the rows above. */
struct InfoRow
{
    QString key;
    ReadText text;
};

/** Heading of the rows up to the next one. */
struct GroupRow
{
    QString key;
    QString title;
    bool isFolded = false; ///< initial state; for rarely changed values
};

using InspectorRow = std::variant<NumberRow, TextRow, EntryRow, FlagRow, PickRow, ActionRow,
                                  PartRow, InfoRow, GroupRow>;

[[nodiscard]] std::vector<InspectorRow> icebergRows();
[[nodiscard]] std::vector<InspectorRow> uavRows();
[[nodiscard]] std::vector<InspectorRow> assetRows();
[[nodiscard]] std::vector<InspectorRow> areaRows();
/** Returns the rows of a no-fly area; `id` is its selection key. */
[[nodiscard]] std::vector<InspectorRow> noFlyRows();
[[nodiscard]] std::vector<InspectorRow> scenarioRows();
/** Returns the rows of the observer; part of `scenarioRows`. */
[[nodiscard]] std::vector<InspectorRow> observerRows();
/**
 * Returns the planner settings that the trade-off panel does not have; the end of `scenarioRows`.
 */
[[nodiscard]] std::vector<InspectorRow> plannerRows();

} // namespace berg
