#pragma once

#include "widgets/aircraft/link_status.h"

#include <QWidget>

#include <map>

class QComboBox;

namespace berg {

/** Choices of the ships that carry the asset, and launch and home; hidden while none is heard. */
class ShipRows : public QWidget
{
    Q_OBJECT

public:
    explicit ShipRows(QWidget* parent = nullptr);

    /** Offers every ship heard; a ship that has become silent stays in the lists. */
    void showShips(const LinkStatus& status);
    void chooseNone();
    /** Copies ships and choices from other rows. */
    void takeOver(const ShipRows& other);

signals:
    /** Emitted with the key of the ship (`LinkShip`) that the asset follows; 0 for none. */
    void assetShipEdited(quint64 key);
    /** Emitted with the key of the ship that launch and home are on; 0 for none. */
    void homeShipEdited(quint64 key);

private:
    void showShip(quint64 key, const QString& name);

    std::map<quint64, QString> m_names; ///< by key
    QComboBox* m_asset;
    QComboBox* m_home;
};

} // namespace berg
