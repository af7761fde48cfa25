#pragma once

#include "widgets/print/brief_table.h"

#include <QStringList>

namespace berg {

/** A value with what it is. */
struct BriefFact
{
    QString caption;
    QString value;
};

/** What the flight brief says, in the language and the units of the user. */
struct BriefContent
{
    QString title; ///< name of the scenario
    QString about; ///< what is exported, of how much
    QString start; ///< date and time, or that times are relative
    QString origin;
    std::vector<BriefFact> flight;    ///< facts about it
    std::vector<BriefFact> planning;  ///< the same
    std::vector<QStringList> uavs;    ///< captions, then a row for each; all as long
    std::vector<QStringList> sorties; ///< endurance and contact of each UAV, likewise; may be none
    BriefCaptions captions;           ///< of the rows of the routes
    std::vector<BriefRoute> routes;   ///< one at least; of several UAVs those that fly
    QStringList warnings;             ///< the most important first
    QString notes;                    ///< of the scenario
    QString foot;
};

[[nodiscard]] BriefContent briefContent(const ExportContent& content, const QLocale& locale);

} // namespace berg
