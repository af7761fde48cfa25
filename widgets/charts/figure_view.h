#pragma once

#include "widgets/charts/figure_painter.h"

#include <QWidget>

namespace berg {

/**
 * A figure on the screen: laid out for the size there is, its items are read under the pointer,
 * clicked, and walked through with the arrow keys.
 */
class FigureView : public QWidget
{
    Q_OBJECT

public:
    explicit FigureView(const Theme& theme, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    [[nodiscard]] const Theme& theme() const { return m_theme; }
    /** Title in a row of its own: for figures that stand alone. */
    void setTitleShown(bool shown);
    /** The item that stands out. */
    void setChosen(std::optional<std::size_t> item);
    [[nodiscard]] std::optional<std::size_t> chosen() const { return m_chosen; }

    /** As laid out. */
    [[nodiscard]] const Drawing& drawing() const { return m_drawing; }
    /** Everything but focus and pointer, as on the screen. */
    void paintPicture(QPainter& painter) const;

    [[nodiscard]] QSize sizeHint() const override { return {480, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 150}; }

signals:
    /** By the arrow keys. */
    void itemChosen(std::size_t item);
    /** Clicked, or Return. */
    void itemActivated(std::size_t item);

protected:
    /** What is shown; the title goes when it is not to be shown. */
    [[nodiscard]] virtual Figure figure() const = 0;

    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

    /** After anything that the figure depends on has changed. */
    void refresh();
    /** An item that there may be no longer is neither chosen nor hovered. */
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
    QAction* m_values; ///< shows them as a table
};

} // namespace berg
