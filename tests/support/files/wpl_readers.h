#pragma once

#include <QByteArray>
#include <QList>
#include <QRegularExpression>
#include <QString>

#include <array>
#include <vector>

// Models of four readers of `QGC WPL` text, after their sources: QGroundControl (MissionController,
// MissionItem), pymavlink (mavwp.py), Mission Planner (WaypointFile), MAVSDK (mission_import.cpp).

namespace berg::test {

struct WplRow
{
    int index = 0;
    int current = 0;
    int frame = 0;
    int command = 0;
    std::array<double, 7> numbers{}; ///< p1 to p4, latitude, longitude, altitude
    int autocontinue = 0;
    bool operator==(const WplRow&) const = default;
};

/** A mission whose row 0 is home. */
struct WplMission
{
    QString fault; ///< empty if it was read
    std::vector<WplRow> rows;
};

struct WplReader
{
    QString name;
    WplMission (*read)(const QByteArray&);
};

namespace wpl {

inline QList<QByteArray> lines(const QByteArray& text)
{
    QList<QByteArray> lines = text.split('\n');
    if (!lines.isEmpty() && lines.last().isEmpty())
        lines.removeLast(); // the final newline
    return lines;
}

/** Reads all twelve columns as numbers of the C locale. */
inline QString readRow(const QList<QByteArray>& columns, WplRow& row)
{
    if (columns.size() != 12)
        return QStringLiteral("%1 columns").arg(columns.size());
    bool ok = true;
    const auto integer = [&](qsizetype column) {
        bool good = false;
        const int value = columns[column].toInt(&good);
        ok = ok && good;
        return value;
    };
    row.index = integer(0);
    row.current = integer(1);
    row.frame = integer(2);
    row.command = integer(3);
    for (std::size_t i = 0; i < row.numbers.size(); ++i) {
        bool good = false;
        row.numbers[i] = columns[static_cast<qsizetype>(i) + 4].toDouble(&good);
        ok = ok && good;
    }
    row.autocontinue = integer(11);
    return ok ? QString() : QStringLiteral("not a number");
}

inline QList<QByteArray> splitAt(const QByteArray& line, const char* separators)
{
    const QRegularExpression separator(QStringLiteral("[%1]+").arg(QLatin1String(separators)));
    QList<QByteArray> columns;
    for (const QString& column : QString::fromUtf8(line).split(separator, Qt::SkipEmptyParts))
        columns << column.toUtf8();
    return columns;
}

/** Accepts tabs only; rows without twelve columns are "corrupted". Renumbers the rows. */
inline WplMission readQgroundcontrol(const QByteArray& text)
{
    const QList<QByteArray> rows = lines(text);
    WplMission mission;
    if (rows.isEmpty() || rows.first() != "QGC WPL 110")
        return {.fault = QStringLiteral("header"), .rows = {}};
    for (qsizetype i = 1; i < rows.size() && mission.fault.isEmpty(); ++i) {
        mission.rows.emplace_back();
        mission.fault = readRow(rows[i].split('\t'), mission.rows.back());
        mission.rows.back().index = static_cast<int>(mission.rows.size()) - 1;
    }
    return mission;
}

/** Accepts any white space, comments and blank lines; versions 100 and 110. */
inline WplMission readPymavlink(const QByteArray& text)
{
    const QList<QByteArray> rows = lines(text);
    WplMission mission;
    if (rows.isEmpty() ||
        !(rows.first().startsWith("QGC WPL 110") || rows.first().startsWith("QGC WPL 100") ||
          rows.first().startsWith("QGC WPL PB 110")))
        return {.fault = QStringLiteral("header"), .rows = {}};
    for (qsizetype i = 1; i < rows.size() && mission.fault.isEmpty(); ++i) {
        const QByteArray line = rows[i].trimmed();
        if (line.isEmpty() || line.startsWith('#'))
            continue;
        mission.rows.emplace_back();
        mission.fault = readRow(splitAt(line, " \\t"), mission.rows.back());
        mission.rows.back().index = static_cast<int>(mission.rows.size()) - 1;
    }
    return mission;
}

/**
 * Accepts tabs, spaces and commas; skips short lines; inserts a blank home if the first index is
 * not 0. Ignores the current and autocontinue columns, which are set here as it would write them.
 */
inline WplMission readMissionPlanner(const QByteArray& text)
{
    const QList<QByteArray> rows = lines(text);
    WplMission mission;
    if (rows.isEmpty() || !rows.first().contains("QGC WPL"))
        return {.fault = QStringLiteral("header"), .rows = {}};
    for (qsizetype i = 1; i < rows.size() && mission.fault.isEmpty(); ++i) {
        if (rows[i].startsWith('#'))
            continue;
        QList<QByteArray> columns = splitAt(rows[i], " \\t,");
        if (columns.size() <= 9)
            continue;
        if (mission.rows.empty() && columns.first() != "0")
            mission.rows.emplace_back();
        while (columns.size() < 11)
            columns << "0";
        columns = columns.first(11) << "1";
        mission.rows.emplace_back();
        mission.fault = readRow(columns, mission.rows.back());
        mission.rows.back().index = static_cast<int>(mission.rows.size()) - 1;
        mission.rows.back().current = mission.rows.size() == 1 ? 1 : 0;
    }
    return mission;
}

/** Accepts tabs only and twelve columns; skips comments and blank lines. Renumbers the rows. */
inline WplMission readMavsdk(const QByteArray& text)
{
    const QList<QByteArray> rows = lines(text);
    WplMission mission;
    if (rows.isEmpty() || rows.first().trimmed() != "QGC WPL 110")
        return {.fault = QStringLiteral("header"), .rows = {}};
    for (qsizetype i = 1; i < rows.size() && mission.fault.isEmpty(); ++i) {
        if (rows[i].isEmpty() || rows[i].startsWith('#'))
            continue;
        mission.rows.emplace_back();
        mission.fault = readRow(rows[i].split('\t'), mission.rows.back());
        mission.rows.back().index = static_cast<int>(mission.rows.size()) - 1;
    }
    return mission;
}

} // namespace wpl

inline std::vector<WplReader> readers()
{
    return {{QStringLiteral("QGroundControl"), wpl::readQgroundcontrol},
            {QStringLiteral("pymavlink"), wpl::readPymavlink},
            {QStringLiteral("Mission Planner"), wpl::readMissionPlanner},
            {QStringLiteral("MAVSDK"), wpl::readMavsdk}};
}

} // namespace berg::test
