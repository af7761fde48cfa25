#pragma once

#include "widgets/theme/theme.h"

#include <QStyledItemDelegate>

namespace berg {

/**
 * Draws the iceberg table with tabular figures and a sigma bar on the scale of the map, and edits
 * its cells with the Inspector's inputs.
 */
class IcebergTableDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void setTheme(const Theme& theme) { m_theme = theme; }
    /** Sets sigma at the end of the colour scale. */
    void setSigmaFull(double full_m2) { m_sigmaFull_m2 = full_m2; }

    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;

    /** Returns the width of the bar left of the text of sigma. */
    [[nodiscard]] static int barWidth();
    /** Returns the width of the alarm sign behind a name. */
    [[nodiscard]] static int alarmWidth();

signals:
    /** Ctrl+Return: requests to set this cell in all selected rows. */
    void allEdited(const QModelIndex& index, const QVariant& value) const;

protected:
    bool eventFilter(QObject* editor, QEvent* event) override;

private:
    void addAlarm(QStyleOptionViewItem& option) const;
    void paintNumber(QPainter& painter, const QStyleOptionViewItem& option,
                     const QString& text) const;
    void paintBar(QPainter& painter, const QStyleOptionViewItem& option, double sigma_m2) const;

    Theme m_theme = Theme::light();
    double m_sigmaFull_m2 = 0;
    bool m_editsAll = false; ///< whether an edit for all rows is being committed
};

} // namespace berg
