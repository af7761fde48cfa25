#include "widgets/panels/aircraft/ship_rows.h"

#include "widgets/aircraft/link_ships.h"

#include <QComboBox>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {

ShipRows::ShipRows(QWidget* parent) : QWidget(parent), m_asset(new QComboBox), m_home(new QComboBox)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_asset->setObjectName(u"assetShip"_s);
    m_asset->setAccessibleName(tr("Ship that the asset follows"));
    m_asset->addItem(tr("The asset follows no ship"), quint64{0});
    m_home->setObjectName(u"homeShip"_s);
    m_home->setAccessibleName(tr("Ship with launch and home"));
    m_home->setToolTip(
        tr("Launch and home of the UAVs move with the ship, in the simulation and in "
           "uploads. The autopilot's own home stays where it took off."));
    m_home->addItem(tr("Launch and home are not on a ship"), quint64{0});
    for (QComboBox* box : {m_asset, m_home}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        column->addWidget(box);
    }
    connect(m_asset, &QComboBox::activated, this,
            [this] { emit assetShipEdited(m_asset->currentData().toULongLong()); });
    connect(m_home, &QComboBox::activated, this,
            [this] { emit homeShipEdited(m_home->currentData().toULongLong()); });
    hide();
}

void ShipRows::showShips(const LinkStatus& status)
{
    for (const LinkShip& ship : shipsOf(status)) {
        if (m_asset->findData(ship.key) < 0)
            m_asset->addItem(tr("The asset follows %1").arg(ship.name), ship.key);
        if (m_home->findData(ship.key) < 0)
            m_home->addItem(tr("Launch and home are on %1").arg(ship.name), ship.key);
    }
    setVisible(m_asset->count() > 1);
}

} // namespace berg
