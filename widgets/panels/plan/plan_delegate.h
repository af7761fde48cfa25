#pragma once

#include "widgets/theme/theme.h"

#include <QStyledItemDelegate>

#include <optional>

namespace berg {

/**
 * Draws the plan table: the order in disks as on the map, sigma with its colour, lines of UAVs with
 * a shaded ground and their colour, a pin beside assigned icebergs. If course and ground speed have
 * no columns, they are shown in small print below name and leg.
 */
class PlanDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void setTheme(const Theme& theme) { m_theme = theme; }
    /** Sets sigma at the end of the colour scale. */
    void setSigmaFull(double full_m2) { m_sigmaFull_m2 = full_m2; }
    /** Sets which of the two values have no column and are shown below. */
    void setBelow(bool course, bool groundSpeed);
    /** Returns the height of rows that are `row_px` high without a second line. */
    [[nodiscard]] int rowHeight_px(int row_px) const;
    /** Returns the second, small line of a cell; empty if the cell has one line. */
    [[nodiscard]] QString textBelow(const QModelIndex& index) const;

    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override;

    /** Returns the width of the colour left of the text of sigma. */
    [[nodiscard]] static int swatchWidth();
    /**
     * Returns visits, length and last arrival of a UAV in the small font; the length is omitted if
     * it exceeds `room_px`.
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
    /** Draws the number in the colour of the UAV, or in the usual one if there is no other UAV. */
    void paintNumber(QPainter& painter, const QRect& cell, int number,
                     std::optional<int> uav) const;
    void paintSwatch(QPainter& painter, const QStyleOptionViewItem& option, double sigma_m2) const;
    void paintBelow(QPainter& painter, const QStyleOptionViewItem& option, const QString& text,
                    Qt::Alignment side) const;

    Theme m_theme = Theme::light();
    double m_sigmaFull_m2 = 0;
    bool m_hasCourseBelow = false;
    bool m_hasSpeedBelow = false;
};

} // namespace berg
