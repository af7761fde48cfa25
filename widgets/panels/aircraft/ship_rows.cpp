#include "widgets/panels/aircraft/ship_rows.h"

#include "widgets/aircraft/link_ships.h"
#include "widgets/panels/fields/wheel_guard.h"

#include <QComboBox>
#include <QVBoxLayout>

#include <algorithm>

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
        guardWheel(*box);
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
    for (const LinkShip& ship : shipsOf(status))
        showShip(ship.key, ship.name);
    setVisible(m_asset->count() > 1);
}

/** The name of a ship may follow its first position. */
void ShipRows::showShip(quint64 key, const QString& name)
{
    QString& known = m_names[key];
    if (known == name)
        return;
    known = name;
    const auto showIn = [key](QComboBox& box, const QString& text) {
        if (const int row = box.findData(key); row >= 0)
            box.setItemText(row, text);
        else
            box.addItem(text, key);
    };
    showIn(*m_asset, tr("The asset follows %1").arg(name));
    showIn(*m_home, tr("Launch and home are on %1").arg(name));
}

void ShipRows::chooseNone()
{
    m_asset->setCurrentIndex(0);
    m_home->setCurrentIndex(0);
}

void ShipRows::takeOver(const ShipRows& other)
{
    for (const auto& [key, name] : other.m_names)
        showShip(key, name);
    m_asset->setCurrentIndex(std::max(0, m_asset->findData(other.m_asset->currentData())));
    m_home->setCurrentIndex(std::max(0, m_home->findData(other.m_home->currentData())));
    setVisible(m_asset->count() > 1);
}

} // namespace berg
