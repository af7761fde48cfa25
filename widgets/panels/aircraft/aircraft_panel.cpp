#include "widgets/panels/aircraft/aircraft_panel.h"

#include "core/base/angles.h"
#include "core/link/tracker_list.h"
#include "widgets/aircraft/link_text.h"
#include "widgets/panels/aircraft/ice_row.h"
#include "widgets/panels/aircraft/log_rows.h"
#include "widgets/panels/aircraft/ship_rows.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/theme/quantity_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 8;
constexpr int kMostEventLines = 500;
constexpr int kListHeight_px = 92;
constexpr double kOld_s = 3; ///< Older positions are marked.

enum Column
{
    Name,
    Mode,
    Age,
    Columns
};

QPushButton* button(const char* name, const QString& text, const QString& tip)
{
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    made->setAutoDefault(false);
    return made;
}

QLabel* wrapped(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText); // part of it comes from others
    label->setWordWrap(true);
    return label;
}

QVariant keyOf(LinkAddress address)
{
    return address.system * 256 + address.component;
}

QString directionText(double from_rad)
{
    return u"%1°"_s.arg(qRound(degFromRad(from_rad) + 360) % 360, 3, 10, QChar(u'0'));
}

QStringList motionTexts(const AircraftState& state, const QLocale& locale)
{
    QStringList parts;
    if (state.position)
        parts << heightText(state.position->altitude_m, locale);
    if (state.groundSpeed_mps)
        parts << speedText(*state.groundSpeed_mps, locale);
    if (state.attitude)
        parts << directionText(state.attitude->heading_rad);
    return parts;
}

QString windText(const AircraftWind& wind, const QLocale& locale)
{
    const double speed_mps = std::hypot(wind.meanNorth_mps, wind.meanEast_mps);
    return AircraftPanel::tr("from %1, %2 ± %3")
        .arg(directionText(std::atan2(-wind.meanEast_mps, -wind.meanNorth_mps)),
             speedText(speed_mps, locale), speedText(wind.scatter_mps, locale));
}

QString detailsOf(const LinkVehicle& vehicle, const QLocale& locale)
{
    const AircraftState& state = vehicle.state;
    QStringList lines;
    if (const QStringList motion = motionTexts(state, locale); !motion.isEmpty())
        lines << motion.join(u", "_s);
    if (state.wind)
        lines << AircraftPanel::tr("Wind: %1").arg(windText(*state.wind, locale));
    if (state.mission)
        lines << (state.mission->total ? AircraftPanel::tr("Item %1 of %2")
                                             .arg(QString::number(itemNumber(state.mission->item,
                                                                             vehicle.autopilot)),
                                                  QString::number(*state.mission->total))
                                       : AircraftPanel::tr("Item %1").arg(
                                             itemNumber(state.mission->item, vehicle.autopilot)));
    if (vehicle.loss.lost > 0)
        lines << AircraftPanel::tr("Frames lost: %1 of %2")
                     .arg(QString::number(vehicle.loss.lost),
                          QString::number(vehicle.loss.lost + vehicle.loss.received));
    return lines.join(u'\n');
}

} // namespace

AircraftPanel::AircraftPanel(QWidget* parent)
    : QWidget(parent)
    , m_address(new QLineEdit)
    , m_listen(button("listenButton", tr("Listen"),
                      tr("Receives telemetry at this address. Nothing is sent.")))
    , m_send(new QCheckBox(tr("Send")))
    , m_rehearse(button("rehearseButton", tr("Rehearse"),
                        tr("Simulated aircraft fly from the UAVs of the scenario and send their "
                           "telemetry over the network of this computer. Not while another link "
                           "is open.")))
    , m_state(wrapped("linkState"))
    , m_list(new QTreeWidget)
    , m_details(wrapped("aircraftDetails"))
    , m_uav(new QComboBox)
    , m_onBoard(wrapped("onBoardState"))
    , m_steeringState(wrapped("steeringState"))
    , m_steering(new QComboBox)
    , m_upload(button("uploadButton", tr("Upload"),
                      tr("Uploads the plan with its fence and rally point, reads it back and "
                         "compares it. If the plan has no fence, the aircraft keeps its own.")))
    , m_compare(button("compareButton", tr("Compare"),
                       tr("Reads the mission on board and compares it with the plan.")))
    , m_flyMission(button("flyMissionButton", tr("Fly the mission"),
                          tr("Selects the mode in which the aircraft flies the mission on board. "
                             "It must be in the air.")))
    , m_wind(button("useWindButton", tr("Use its wind"),
                    tr("The mean wind of the last minute becomes the wind of the scenario.")))
    , m_flyLive(button("flyLiveButton", tr("Fly with the aircraft"),
                       tr("The flight in this window follows the aircraft: charts and uncertainty "
                          "show the real flight.")))
    , m_log(new LogRows)
    , m_battery(wrapped("aircraftBattery"))
    , m_ships(new ShipRows)
    , m_ice(new IceRow)
    , m_events(new QPlainTextEdit)
    , m_theme(Theme::light())
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    addConnection(*column);
    addDetails(*column);
    m_events->setObjectName(u"linkEvents"_s);
    m_events->setAccessibleName(tr("Events of the link"));
    m_events->setReadOnly(true);
    m_events->setMaximumBlockCount(kMostEventLines);
    m_events->setTabChangesFocus(true);
    column->addWidget(m_events, 1);
    showStatus({}, {});
}

void AircraftPanel::addConnection(QVBoxLayout& column)
{
    m_address->setObjectName(u"linkAddress"_s);
    m_address->setAccessibleName(tr("Address of the link"));
    m_address->setToolTip(tr("udp:HOST:PORT listens, udpout:HOST:PORT sends to one address; also "
                             "tcp:HOST:PORT and serial:DEVICE:BAUD"));
    m_listen->setCheckable(true);
    m_rehearse->setCheckable(true);
    m_send->setObjectName(u"sendSwitch"_s);
    m_send->setToolTip(
        tr("Off: not a byte is sent. On: heartbeats, requests for telemetry and what "
           "you choose below are sent."));
    auto* address = new QHBoxLayout;
    address->addWidget(m_address, 1);
    address->addWidget(m_listen);
    auto* choices = new QHBoxLayout;
    choices->addWidget(m_send);
    choices->addStretch();
    choices->addWidget(m_rehearse);
    column.addLayout(address);
    column.addLayout(choices);
    column.addWidget(m_log);
    column.addWidget(m_state);
    connect(m_log, &LogRows::logEdited, this, &AircraftPanel::logEdited);
    connect(m_log, &LogRows::openRequested, this, &AircraftPanel::openLogRequested);
    connect(m_log, &LogRows::speedEdited, this, &AircraftPanel::replaySpeedEdited);
    connect(m_listen, &QPushButton::clicked, this, &AircraftPanel::listenEdited);
    connect(m_send, &QCheckBox::clicked, this, &AircraftPanel::sendEdited);
    connect(m_rehearse, &QPushButton::clicked, this, &AircraftPanel::rehearsalEdited);
    connect(m_address, &QLineEdit::returnPressed, this, [this] { emit listenEdited(true); });
}

void AircraftPanel::addDetails(QVBoxLayout& column)
{
    m_list->setObjectName(u"aircraftList"_s);
    m_list->setAccessibleName(tr("Aircraft heard"));
    m_list->setColumnCount(Columns);
    m_list->setHeaderLabels({tr("Aircraft"), tr("Mode"), tr("Last position")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setMaximumHeight(kListHeight_px);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    column.addWidget(m_list);
    column.addWidget(m_battery);
    column.addWidget(m_details);
    auto* uavRow = new QHBoxLayout;
    auto* uavName = new QLabel(tr("Flies as"));
    uavName->setBuddy(m_uav);
    m_uav->setObjectName(u"aircraftUav"_s);
    guardWheel(*m_uav);
    uavRow->addWidget(uavName);
    uavRow->addWidget(m_uav, 1);
    uavRow->addWidget(m_wind);
    column.addLayout(uavRow);
    column.addWidget(m_flyLive);
    column.addWidget(m_onBoard);
    auto* transfer = new QHBoxLayout;
    for (QPushButton* one : {m_upload, m_compare, m_flyMission})
        transfer->addWidget(one);
    column.addLayout(transfer);
    m_steering->setObjectName(u"steeringChoice"_s);
    m_steering->setAccessibleName(tr("Steering"));
    m_steering->addItem(tr("Do not steer"), static_cast<int>(SteeringKind::None));
    m_steering->addItem(tr("Replace the mission when the plan changes"),
                        static_cast<int>(SteeringKind::Mission));
    m_steering->addItem(tr("Guide from iceberg to iceberg"),
                        static_cast<int>(SteeringKind::Guided));
    m_steering->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    guardWheel(*m_steering);
    column.addWidget(m_steering);
    column.addWidget(m_steeringState);
    column.addWidget(m_ships);
    column.addWidget(m_ice);
    connect(m_ice, &IceRow::iceReported, this, &AircraftPanel::iceReported);
    connect(m_ships, &ShipRows::assetShipEdited, this, &AircraftPanel::assetShipEdited);
    connect(m_ships, &ShipRows::homeShipEdited, this, &AircraftPanel::homeShipEdited);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &AircraftPanel::showDetails);
    connect(m_uav, &QComboBox::activated, this,
            [this] { emit uavEdited(m_uav->currentData().toString().toStdString()); });
    connect(m_steering, &QComboBox::activated, this, [this] {
        emit steeringEdited(static_cast<SteeringKind>(m_steering->currentData().toInt()));
    });
    connect(m_upload, &QPushButton::clicked, this, &AircraftPanel::uploadRequested);
    connect(m_compare, &QPushButton::clicked, this, &AircraftPanel::compareRequested);
    connect(m_flyMission, &QPushButton::clicked, this, &AircraftPanel::flyMissionRequested);
    connect(m_wind, &QPushButton::clicked, this, &AircraftPanel::windRequested);
    connect(m_flyLive, &QPushButton::clicked, this, &AircraftPanel::flyLiveRequested);
}

void AircraftPanel::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_log->setTheme(theme);
    showDetails();
}

void AircraftPanel::setAddress(const QString& address)
{
    m_address->setText(address);
}

QString AircraftPanel::address() const
{
    return m_address->text().trimmed();
}

void AircraftPanel::setUavs(const std::vector<std::string>& ids)
{
    m_uav->clear();
    m_uav->addItem(tr("No UAV"), QString());
    for (const std::string& id : ids)
        m_uav->addItem(QString::fromStdString(id), QString::fromStdString(id));
    showDetails();
}

void AircraftPanel::setLogChoice(bool isOn, const QString& folder)
{
    m_log->setChoice(isOn, folder);
}

double AircraftPanel::replaySpeed() const
{
    return m_log->speed();
}

QString AircraftPanel::stateText() const
{
    const LinkCondition& condition = m_status.condition;
    if (!m_status.isListening && condition.state != LinkCondition::State::Broken)
        return tr("The link is off.");
    if (m_status.replay)
        return m_status.vehicles.empty() ? tr("No aircraft in the log so far.") : QString();
    if (m_status.vehicles.empty() && condition.state == LinkCondition::State::Open)
        return tr("Listening. No aircraft has been heard yet.");
    const bool hasPosition = std::ranges::any_of(m_status.vehicles, [](const LinkVehicle& vehicle) {
        return vehicle.state.position.has_value();
    });
    if (!m_status.isSending && !hasPosition && !m_status.vehicles.empty())
        return tr("No position yet. Some autopilots report it only while Send is on.");
    return linkConditionText(condition);
}

void AircraftPanel::showStatus(const LinkStatus& status,
                               const std::map<LinkAddress, AircraftNotes>& notes)
{
    m_status = status;
    m_notes = notes;
    m_ships->showShips(status);
    m_ice->showIce(status);
    m_log->showStatus(status);
    m_listen->setChecked(status.isListening);
    m_send->setChecked(status.isSending);
    m_send->setEnabled(status.isListening && !status.replay);
    m_rehearse->setEnabled(!status.replay && m_flight.mayRehearse);
    m_address->setEnabled(!status.isListening);
    m_state->setText(stateText());
    m_state->setVisible(!m_state->text().isEmpty());
    showList();
    showDetails();
}

/** Rows are in the order of ids: an aircraft heard later may come first, and the choice moves. */
void AircraftPanel::showList()
{
    const std::optional<LinkAddress> before = chosen();
    const int count = static_cast<int>(m_status.vehicles.size());
    while (m_list->topLevelItemCount() > count)
        delete m_list->takeTopLevelItem(m_list->topLevelItemCount() - 1);
    for (int row = 0; row < count; ++row) {
        const LinkVehicle& vehicle = m_status.vehicles[static_cast<std::size_t>(row)];
        if (row >= m_list->topLevelItemCount())
            m_list->addTopLevelItem(new QTreeWidgetItem);
        QTreeWidgetItem& item = *m_list->topLevelItem(row);
        item.setData(Name, Qt::UserRole, keyOf(vehicle.address));
        item.setText(Name, aircraftName(vehicle.address));
        item.setText(Mode, vehicle.isLost ? tr("no contact")
                           : isTracker(vehicle.address)
                               ? u"NMEA"_s
                               : QString::fromStdString(modeName(vehicle.autopilot, vehicle.mode)));
        const std::optional<AircraftPosition>& position = vehicle.state.position;
        const double age_s = position ? m_status.now_s - position->received_s : 0;
        item.setText(Age, position ? positionAgeText(age_s, locale()) : tr("none yet"));
        const bool isOld = vehicle.isLost || !position || age_s > kOld_s;
        for (const int column : {Mode, Age})
            item.setForeground(column, isOld ? QBrush(m_theme.warning) : QBrush());
    }
    int row = 0;
    for (int i = 0; before && i < count; ++i)
        if (m_status.vehicles[static_cast<std::size_t>(i)].address == *before)
            row = i;
    m_list->setCurrentItem(count > 0 ? m_list->topLevelItem(row) : nullptr);
}

std::optional<LinkAddress> AircraftPanel::chosen() const
{
    const QTreeWidgetItem* item = m_list->currentItem();
    if (item == nullptr)
        return std::nullopt;
    const int key = item->data(Name, Qt::UserRole).toInt();
    return LinkAddress{.system = static_cast<std::uint8_t>(key / 256),
                       .component = static_cast<std::uint8_t>(key % 256)};
}

void AircraftPanel::showDetails()
{
    const std::optional<LinkAddress> address = chosen();
    const auto vehicle = std::ranges::find_if(
        m_status.vehicles, [&](const LinkVehicle& one) { return one.address == address; });
    const bool isThere = address && vehicle != m_status.vehicles.end();
    const auto found = isThere ? m_notes.find(*address) : m_notes.end();
    const AircraftNotes notes = found != m_notes.end() ? found->second : AircraftNotes{};
    m_details->setText(isThere ? detailsOf(*vehicle, locale()) : QString());
    m_details->setVisible(!m_details->text().isEmpty());
    m_uav->setCurrentIndex(std::max(0, m_uav->findData(QString::fromStdString(notes.uav))));
    m_battery->setText(notes.battery);
    m_battery->setVisible(!notes.battery.isEmpty());
    QPalette charge = m_battery->palette();
    charge.setColor(QPalette::WindowText,
                    notes.isBatteryShort ? m_theme.warning : palette().color(QPalette::WindowText));
    m_battery->setPalette(charge);
    m_onBoard->setText(notes.onBoard);
    m_onBoard->setVisible(!notes.onBoard.isEmpty());
    QPalette colours = m_onBoard->palette();
    colours.setColor(QPalette::WindowText, notes.isSame || notes.onBoard.isEmpty()
                                               ? palette().color(QPalette::WindowText)
                                               : m_theme.warning);
    m_onBoard->setPalette(colours);
    m_steering->setCurrentIndex(
        std::max(0, m_steering->findData(static_cast<int>(notes.steering.kind()))));
    m_steeringState->setText(steeringText(notes.steering, m_flight.isLive));
    m_steeringState->setVisible(!m_steeringState->text().isEmpty());
    const bool isBusy = isThere && isSyncRunning(*vehicle);
    const bool maySend =
        isThere && m_status.isSending && !vehicle->isLost && !isTracker(vehicle->address);
    m_uav->setEnabled(isThere);
    m_wind->setEnabled(isThere && vehicle->state.wind.has_value());
    m_upload->setEnabled(maySend && !isBusy && !notes.uav.empty());
    m_compare->setEnabled(maySend && !isBusy && !notes.uav.empty());
    m_flyMission->setEnabled(maySend && vehicle->state.isFlying.value_or(true));
    m_steering->setEnabled(maySend && !notes.uav.empty());
    m_flyLive->setEnabled(!m_flight.isLive && std::ranges::any_of(m_notes, [](const auto& entry) {
        return !entry.second.uav.empty();
    }));
}

void AircraftPanel::showFlight(const LiveFlightState& state)
{
    m_flight = state;
    m_rehearse->setChecked(state.isRehearsing);
    m_ice->setReporting(state.mayReport);
    m_rehearse->setEnabled(!m_status.replay && state.mayRehearse);
    m_flyLive->setText(state.isLive ? tr("The flight follows the aircraft")
                                    : tr("Fly with the aircraft"));
    showDetails();
}

void AircraftPanel::chooseNoShip()
{
    m_ships->chooseNone();
}

void AircraftPanel::takeOver(const AircraftPanel& other)
{
    m_events->setPlainText(other.m_events->toPlainText());
    m_events->moveCursor(QTextCursor::End);
    m_ships->takeOver(*other.m_ships);
    const std::optional<LinkAddress> address = other.chosen();
    for (int row = 0; address && row < m_list->topLevelItemCount(); ++row)
        if (m_list->topLevelItem(row)->data(Name, Qt::UserRole) == keyOf(*address))
            m_list->setCurrentItem(m_list->topLevelItem(row));
}

void AircraftPanel::addEvent(const QString& time, const QString& text, bool isAlarm)
{
    m_events->appendPlainText(isAlarm ? tr("%1  Attention: %2").arg(time, text)
                                      : u"%1  %2"_s.arg(time, text));
}

void AircraftPanel::showFault(const QString& fault)
{
    m_state->setText(fault);
    m_state->setVisible(!fault.isEmpty());
}

} // namespace berg
