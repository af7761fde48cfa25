#include "widgets/aircraft/link_text.h"

#include "core/link/tracker_list.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

#include <algorithm>

namespace berg {
namespace {

struct LinkText
{
    Q_DECLARE_TR_FUNCTIONS(LinkText)
};

constexpr int kWorstWarning = 4; ///< severities from 0 (emergency) to this are shown as alarms

/** Returns received bytes as text; other people's bytes may be anything. */
QString plainText(const std::string& bytes)
{
    QString text = QString::fromUtf8(bytes.data(), static_cast<qsizetype>(bytes.size()));
    for (QChar& character : text)
        if (!character.isPrint())
            character = u' ';
    return text.trimmed();
}

QString partName(MissionType type)
{
    switch (type) {
    case MissionType::Mission:
        return LinkText::tr("Mission");
    case MissionType::Fence:
        return LinkText::tr("Fence");
    case MissionType::Rally:
        return LinkText::tr("Rally points");
    }
    return {};
}

/** Fences and rally points have no item for home. */
int transferredItem(const SyncStatus& sync, AutopilotKind autopilot)
{
    const int item = sync.transfer.item.value_or(0);
    return sync.type == MissionType::Mission ? itemNumber(item, autopilot) : item + 1;
}

QString failureText(const SyncStatus& sync, AutopilotKind autopilot)
{
    const TransferStatus& transfer = sync.transfer;
    switch (transfer.failure) {
    case TransferFailure::None:
    case TransferFailure::NoAnswer:
        return LinkText::tr("the aircraft does not answer");
    case TransferFailure::GaveUp:
        return LinkText::tr("the aircraft stopped answering at item %1")
            .arg(transferredItem(sync, autopilot));
    case TransferFailure::Refused:
        return LinkText::tr("the aircraft refuses it (result %1)").arg(transfer.result);
    case TransferFailure::WrongItem:
        return LinkText::tr("the aircraft requests an item that does not exist");
    case TransferFailure::TooManyItems:
        return LinkText::tr("the aircraft announces too many items");
    }
    return {};
}

/** Returns the name of a field of an item, as MAVLink calls it. */
QString fieldText(const std::string& field)
{
    if (field == "command")
        return LinkText::tr("command");
    if (field == "frame")
        return LinkText::tr("altitude reference");
    if (field == "x")
        return LinkText::tr("latitude");
    if (field == "y")
        return LinkText::tr("longitude");
    if (field == "z")
        return LinkText::tr("altitude");
    if (field.starts_with("param"))
        return LinkText::tr("parameter %1").arg(QString::fromStdString(field.substr(5)));
    return QString::fromStdString(field);
}

QString differenceText(const ItemDifference& difference)
{
    if (!difference.index)
        return LinkText::tr("the numbers of items differ");
    return LinkText::tr("item %1, %2")
        .arg(QString::number(*difference.index + 1), fieldText(difference.field));
}

} // namespace

QString aircraftName(LinkAddress address)
{
    return isTracker(address) ? LinkText::tr("Tracker %1").arg(address.component)
                              : LinkText::tr("Aircraft %1").arg(address.system);
}

QString trafficName(const TrafficTarget& target)
{
    QString name = plainText(target.name);
    if (!name.isEmpty())
        return name;
    if (target.kind == TrafficTarget::Kind::Ice)
        return LinkText::tr("Radar target %1").arg(target.id);
    return target.kind == TrafficTarget::Kind::Ship // MMSI, or ICAO address
               ? QString::number(target.id)
               : QString::number(target.id, 16).toUpper().rightJustified(6, u'0');
}

QString linkConditionText(const LinkCondition& condition)
{
    switch (condition.state) {
    case LinkCondition::State::Opening:
        return LinkText::tr("Opening the link…");
    case LinkCondition::State::Open:
        return LinkText::tr("Listening");
    case LinkCondition::State::Broken:
        return LinkText::tr("No link: %1").arg(QString::fromStdString(condition.fault));
    }
    return {};
}

QString positionAgeText(double age_s, const QLocale& locale)
{
    constexpr double kMinute_s = 60;
    return LinkText::tr("%1 ago").arg(age_s < kMinute_s ? u"%1 s"_s.arg(fixedText(age_s, 1, locale))
                                                        : clockText(age_s));
}

int itemNumber(int item, AutopilotKind autopilot)
{
    return autopilot == AutopilotKind::ArduPilot ? item : item + 1;
}

QString syncText(const SyncStatus& sync, AutopilotKind autopilot)
{
    const QString progress = sync.transfer.total ? LinkText::tr("%1 of %2")
                                                       .arg(QString::number(sync.transfer.done),
                                                            QString::number(*sync.transfer.total))
                                                 : QString::number(sync.transfer.done);
    switch (sync.phase) {
    case SyncPhase::Uploading:
        return LinkText::tr("%1: uploading, %2").arg(partName(sync.type), progress);
    case SyncPhase::ReadingBack:
        return LinkText::tr("%1: reading back, %2").arg(partName(sync.type), progress);
    case SyncPhase::Equal:
        return std::ranges::find(sync.leftOut, MissionType::Rally) == sync.leftOut.end()
                   ? LinkText::tr("On board: same as the plan")
                   : LinkText::tr("On board: same as the plan. The aircraft has no rally points");
    case SyncPhase::Different:
        return LinkText::tr("On board differs. %1: %2")
            .arg(partName(sync.type),
                 sync.differences.empty() ? QString() : differenceText(sync.differences.front()));
    case SyncPhase::Failed:
        return LinkText::tr("%1 failed: %2").arg(partName(sync.type), failureText(sync, autopilot));
    }
    return {};
}

QString linkEventText(const LinkEvent& event, const LinkVehicle* vehicle)
{
    const QString name = aircraftName(event.vehicle);
    const auto named = [&name](const QString& what) { return u"%1: %2"_s.arg(name, what); };
    switch (event.kind) {
    case LinkEvent::Kind::VehicleAppeared:
        return named(LinkText::tr("heard for the first time"));
    case LinkEvent::Kind::VehicleLost:
        return named(LinkText::tr("contact lost"));
    case LinkEvent::Kind::VehicleReturned:
        return named(LinkText::tr("contact again"));
    case LinkEvent::Kind::ModeChanged:
        return named(LinkText::tr("mode %1").arg(QString::fromStdString(
            modeName(vehicle == nullptr ? AutopilotKind::Other : vehicle->autopilot,
                     static_cast<std::uint32_t>(event.value)))));
    case LinkEvent::Kind::ItemReached:
        return named(LinkText::tr("item %1 reached")
                         .arg(itemNumber(event.value, vehicle == nullptr ? AutopilotKind::Other
                                                                         : vehicle->autopilot)));
    case LinkEvent::Kind::Text:
        return named(plainText(event.text));
    case LinkEvent::Kind::CommandEnded:
        if (!event.command)
            return {};
        return named(!event.command->result ? LinkText::tr("a command was not answered")
                     : *event.command->result == 0
                         ? LinkText::tr("command accepted")
                         : LinkText::tr("command refused (result %1)").arg(*event.command->result));
    case LinkEvent::Kind::SyncEnded:
        return vehicle != nullptr && vehicle->sync && !vehicle->sync->isRecheck
                   ? named(syncText(*vehicle->sync, vehicle->autopilot))
                   : QString();
    case LinkEvent::Kind::SameIdHeard:
        return LinkText::tr("Another ground station uses the same id: sending is off");
    }
    return {};
}

bool isAlarming(const LinkEvent& event)
{
    return event.kind == LinkEvent::Kind::VehicleLost ||
           event.kind == LinkEvent::Kind::SameIdHeard ||
           (event.kind == LinkEvent::Kind::Text && event.value <= kWorstWarning) ||
           (event.kind == LinkEvent::Kind::CommandEnded && event.command &&
            event.command->result != 0);
}

QString steeringText(const Steering& steering, bool isLive)
{
    const bool isGuided = steering.kind() == SteeringKind::Guided;
    switch (steering.state()) {
    case SteeringState::Off:
        return {};
    case SteeringState::Waiting:
        return isGuided ? LinkText::tr("Waiting for guided mode")
                        : LinkText::tr("Waiting until the mission is flown");
    case SteeringState::Active:
        if (isLive)
            return isGuided ? LinkText::tr("Guiding from iceberg to iceberg")
                            : LinkText::tr("Replacing the mission when the plan changes");
        return isGuided
                   ? LinkText::tr("Guiding begins when the flight in this window follows the "
                                  "aircraft")
                   : LinkText::tr("Replacing the mission begins when the flight in this window "
                                  "follows the aircraft");
    case SteeringState::PilotTookOver:
        return LinkText::tr("The pilot has taken over: nothing is sent");
    }
    return {};
}

} // namespace berg
