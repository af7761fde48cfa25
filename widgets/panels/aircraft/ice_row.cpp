#include "widgets/panels/aircraft/ice_row.h"

#include "widgets/aircraft/link_text.h"
#include "widgets/panels/fields/wheel_guard.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>

#include <algorithm>
#include <vector>

using namespace Qt::StringLiterals;

namespace berg {

IceRow::IceRow(QWidget* parent)
    : QWidget(parent), m_targets(new QComboBox), m_report(new QPushButton(tr("Report sighting")))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    m_targets->setObjectName(u"iceTarget"_s);
    m_targets->setAccessibleName(tr("Ice tracked by radar or marked by AIS"));
    m_targets->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    guardWheel(*m_targets);
    m_report->setObjectName(u"reportIce"_s);
    m_report->setToolTip(
        tr("In flight: the nearest iceberg that it may be counts as seen by others; without one, "
           "a new iceberg appears."));
    m_report->setEnabled(false);
    row->addWidget(m_targets, 1);
    row->addWidget(m_report);
    connect(m_report, &QPushButton::clicked, this, [this] {
        if (m_targets->currentIndex() >= 0)
            emit iceReported(m_targets->currentData().toUInt());
    });
    hide();
}

void IceRow::showIce(const LinkStatus& status)
{
    std::vector<const TrafficTarget*> ice;
    for (const TrafficTarget& target : status.traffic)
        if (target.kind == TrafficTarget::Kind::Ice)
            ice.push_back(&target);
    // The list is open while somebody chooses, so unchanged rows stay.
    for (int row = m_targets->count() - 1; row >= 0; --row)
        if (std::ranges::none_of(ice, [&](const TrafficTarget* target) {
                return target->id == m_targets->itemData(row).toUInt();
            }))
            m_targets->removeItem(row);
    for (const TrafficTarget* target : ice) {
        const QString name = trafficName(*target);
        if (const int row = m_targets->findData(target->id); row < 0)
            m_targets->addItem(name, target->id);
        else if (m_targets->itemText(row) != name)
            m_targets->setItemText(row, name);
    }
    setVisible(!ice.empty());
}

void IceRow::setReporting(bool isPossible)
{
    m_report->setEnabled(isPossible);
}

} // namespace berg
