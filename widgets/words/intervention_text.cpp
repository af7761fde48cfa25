#include "widgets/words/intervention_text.h"

#include <QCoreApplication>

namespace berg {

namespace {

struct InterventionText
{
    Q_DECLARE_TR_FUNCTIONS(InterventionText)
};

} // namespace

QString changeName(const Intervention& change)
{
    if (change.policy)
        return InterventionText::tr("Change policy");
    if (change.wind_mps)
        return InterventionText::tr("Change wind");
    if (change.asset)
        return InterventionText::tr("Move asset");
    if (change.appears)
        return InterventionText::tr("Add iceberg");
    if (change.seen)
        return InterventionText::tr("Report sighting");
    if (change.removed)
        return InterventionText::tr("Remove icebergs");
    if (change.assigned)
        return InterventionText::tr("Assign iceberg");
    if (change.commanded)
        return InterventionText::tr("Order UAV");
    if (change.home)
        return InterventionText::tr("Move home");
    return InterventionText::tr("Change trade-off");
}

QString lockedInFlightText()
{
    return InterventionText::tr("The scenario is locked in flight. Stop the flight to change it.");
}

} // namespace berg
