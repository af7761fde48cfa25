#pragma once

#include "core/scenario/checks.h"
#include "core/scenario/scenario.h"
#include "widgets/panels/number_field.h"

#include <QLocale>
#include <QString>

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace berg {

// What the inspector lets one edit, as data. `id` is the iceberg's or the UAV's; rows of the
// scenario itself ignore it. `key` names the input and the gesture that edits it.

/** What every row has. */
struct RowWords
{
    QString key;
    QString label;
    QString toolTip;
    QString undoText;
};

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

struct FlagRow
{
    RowWords words;
    std::function<bool(const Scenario&)> read;
    std::function<void(Scenario&, bool)> write;
};

/** A value that follows from the rows above, for reading. */
struct InfoRow
{
    QString key;
    std::function<QString(const Scenario&, const std::string& id, const QLocale&)> text;
};

using InspectorRow = std::variant<NumberRow, TextRow, FlagRow, InfoRow>;

[[nodiscard]] std::vector<InspectorRow> icebergRows();
[[nodiscard]] std::vector<InspectorRow> uavRows();
[[nodiscard]] std::vector<InspectorRow> scenarioRows();

} // namespace berg
