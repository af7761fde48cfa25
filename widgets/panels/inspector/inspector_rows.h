#pragma once

#include "core/scenario/checks.h"
#include "core/scenario/scenario.h"
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

// What the inspector lets one edit, as data. `id` is the iceberg's or the UAV's; rows of what there
// is once ignore it. `key` names the input and the gesture that edits it.

/** What every row has. */
struct RowWords
{
    QString key;
    QString label;
    QString toolTip;
    QString undoText;
    /** Where the row matters; null: everywhere. Of several objects it is there when it is for one.
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
    /** Closed range, inside the one `validate` allows while all else stays as it is. */
    std::function<Limits(const Scenario&)> range;
    QString lowestText; ///< in place of the lowest value; empty: the number
};

struct TextRow
{
    RowWords words;
    bool multiLine = false;
    std::function<std::string(const Scenario&, const std::string& id)> read;
    std::function<void(Scenario&, const std::string& id, const std::string&)> write;
};

/** A text with a grammar of its own, taken when typing ends. */
struct EntryRow
{
    RowWords words;
    ReadText read;
    /** Takes the text, or changes nothing and says why not. */
    std::function<QString(Scenario&, const std::string& id, const QString& text, const QLocale&)>
        take;
    /** Why several objects do not take the same text; null: they do. */
    std::function<QString(const QString& text)> faultForSeveral{};
    QString placeholder{}; ///< in an empty line
};

struct FlagRow
{
    RowWords words;
    std::function<bool(const Scenario&)> read;
    std::function<void(Scenario&, bool)> write;
};

/** One of several that depend on the scenario; of objects that differ none is shown. */
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
    /** Called when the user has chosen; null: nothing else depends on the choice. */
    std::function<void(ScenarioDocument&, const std::string&)> chosen{};
};

/** A button. */
struct ActionRow
{
    RowWords words; ///< `undoText` is written on it
    std::function<void(Scenario&)> act;
};

/** Something that an object may have: what it is, and a button that takes it away. */
struct PartRow
{
    RowWords words;
    QString removeText; ///< on the button
    /** Empty: the object has none; when no object has one the row is hidden. */
    ReadText text;
    std::function<void(Scenario&, const std::string& id)> remove;
};

/** A value that follows from the rows above, for reading. */
struct InfoRow
{
    QString key;
    ReadText text;
};

/** Heads the rows that follow, until the next one. */
struct GroupRow
{
    QString key;
    QString title;
    bool isFolded = false; ///< at first: what is rarely changed
};

using InspectorRow = std::variant<NumberRow, TextRow, EntryRow, FlagRow, PickRow, ActionRow,
                                  PartRow, InfoRow, GroupRow>;

[[nodiscard]] std::vector<InspectorRow> icebergRows();
[[nodiscard]] std::vector<InspectorRow> uavRows();
[[nodiscard]] std::vector<InspectorRow> assetRows();
[[nodiscard]] std::vector<InspectorRow> areaRows();
/** Of a no-fly area; `id` is its key in the selection. */
[[nodiscard]] std::vector<InspectorRow> noFlyRows();
[[nodiscard]] std::vector<InspectorRow> scenarioRows();
/** How the icebergs are observed; part of `scenarioRows`. */
[[nodiscard]] std::vector<InspectorRow> observerRows();
/** Settings of the planner that the trade-off panel does not have; they end `scenarioRows`. */
[[nodiscard]] std::vector<InspectorRow> plannerRows();

} // namespace berg
