#pragma once

#include "widgets/theme/theme.h"

#include <QStyledItemDelegate>

namespace berg {

/**
 * Draws the plan table: the order in disks as on the map, sigma with its colour, UAVs on a ground
 * of their own with their colour, a pin beside icebergs that are kept for one.
 */
class PlanDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void setTheme(const Theme& theme) { m_theme = theme; }
    void setSigmaFull(double full_m2) { m_sigmaFull_m2 = full_m2; }

    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override;

    /** Room that the colour takes left of the text of sigma. */
    [[nodiscard]] static int swatchWidth();
    /** Of the UAV: visits, length and last arrival, in the small font; the length needs the room.
     */
    [[nodiscard]] QString uavFigures(const QModelIndex& index, int room_px) const;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
    void paintGround(QPainter& painter, const QStyleOptionViewItem& option,
                     const QModelIndex& index) const;
    void paintEmpty(QPainter& painter, const QStyleOptionViewItem& option,
                    const QModelIndex& index) const;
    void paintMark(QPainter& painter, const QStyleOptionViewItem& option,
                   const QModelIndex& index) const;
    void paintUav(QPainter& painter, const QStyleOptionViewItem& option,
                  const QModelIndex& index) const;
    void paintChip(QPainter& painter, const QRect& cell, int uav) const;
    /** `uav` -1: there is but one. */
    void paintNumber(QPainter& painter, const QRect& cell, int number, int uav) const;
    void paintSwatch(QPainter& painter, const QStyleOptionViewItem& option, double sigma_m2) const;

    Theme m_theme = Theme::light();
    double m_sigmaFull_m2 = 0;
};

} // namespace berg
