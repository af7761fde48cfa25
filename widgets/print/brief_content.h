#pragma once

#include "widgets/print/brief_table.h"
#include "widgets/print/brief_weather.h"

#include <QStringList>

namespace berg {

/** A value with its caption. */
struct BriefFact
{
    QString caption;
    QString value;
};

/** Content of the flight brief, in the user's language and units. */
struct BriefContent
{
    QString title; ///< name of the scenario
    QString about; ///< kind of export and its time
    QString start; ///< date and time of the start, or a note that times are relative
    QString origin;
    std::vector<BriefFact> flight;   ///< facts about the flight
    std::vector<BriefFact> planning; ///< facts about the planning
    std::vector<QStringList> uavs;   ///< captions, then a row per UAV; all rows have equal length
    std::vector<QStringList>
        sorties;                    ///< endurance and radio contact, in the same form; may be empty
    BriefWeather weather;           ///< forecast over the flight
    BriefCaptions captions;         ///< captions of the route tables
    std::vector<BriefRoute> routes; ///< at least one; in a fleet only UAVs that fly
    QStringList warnings;           ///< most important first
    QString notes;                  ///< notes of the scenario
    QString foot;
};

/** Returns the brief's content for an export with at least one UAV; its texts are printable. */
[[nodiscard]] BriefContent briefContent(const ExportContent& content, const QLocale& locale);

} // namespace berg
