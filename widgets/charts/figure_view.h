#pragma once

#include "widgets/charts/figure_painter.h"

#include <QWidget>

namespace berg {

/**
 * A figure on the screen, laid out for the widget's size. Its items show their values under the
 * pointer, can be clicked, and are selected with the arrow keys.
 */
class FigureView : public QWidget
{
    Q_OBJECT

public:
    explicit FigureView(const Theme& theme, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    [[nodiscard]] const Theme& theme() const { return m_theme; }
    /** Shows the title in a row of its own, for figures that stand alone. */
    void setTitleShown(bool shown);
    /** Highlights an item; nullopt highlights none. */
    void setChosen(std::optional<std::size_t> item);
    [[nodiscard]] std::optional<std::size_t> chosen() const { return m_chosen; }

    /** Present layout. */
    [[nodiscard]] const Drawing& drawing() const { return m_drawing; }
    /** Paints the figure as on the screen, without focus frame and hover readout. */
    void paintFigure(QPainter& painter) const;

    [[nodiscard]] QSize sizeHint() const override { return {480, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 150}; }

signals:
    /** An item was selected by the arrow keys. */
    void itemChosen(std::size_t item);
    /** An item was clicked, or confirmed by Return. */
    void itemActivated(std::size_t item);

protected:
    /** Content of the figure; the view drops its title if titles are not shown. */
    [[nodiscard]] virtual Figure figure() const = 0;

    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

    /** Call it after a change of anything that the figure depends on. */
    void refresh();
    /** Clears selection and hover of items with an id of `from` or more, which may be gone. */
    void forgetItems(std::size_t from);
    [[nodiscard]] std::optional<std::size_t> hovered() const { return m_hovered; }

private:
    void setHovered(std::optional<std::size_t> item);
    [[nodiscard]] const DrawnItem* itemOf(std::optional<std::size_t> id) const;
    [[nodiscard]] std::optional<std::size_t> itemNear(const QPointF& at) const;
    void showValues();
    void paintReadout(QPainter& painter, const DrawnItem& item) const;

    Theme m_theme;
    Drawing m_drawing;
    bool m_titleShown = false;
    std::optional<std::size_t> m_chosen;
    std::optional<std::size_t> m_hovered;
    QAction* m_values; ///< action that shows the values as a table
};

} // namespace berg
