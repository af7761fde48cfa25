#pragma once

#include "widgets/theme/theme.h"

#include <QPointer>
#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;

namespace berg {

/** Target and text of one step of the tour. */
struct TourStep
{
    QPointer<QWidget> target;
    QString title;
    QString text;
    bool spaceFlies = false; ///< as its words say: Space ends the tour and flies
};

/**
 * Walks through the window: dims it but for one part and says what that is for. Enter or Right
 * goes on, Left back, Esc ends it, Space flies where the step says so. Covers its parent; ends for
 * good with `finished`.
 */
class Tour : public QWidget
{
    Q_OBJECT

public:
    /** `steps` is not empty. */
    Tour(std::vector<TourStep> steps, const Theme& theme, QWidget* parent);

    void setTheme(const Theme& theme);
    [[nodiscard]] std::size_t step() const { return m_step; }

signals:
    void finished();
    /** After `finished`: Space was pressed in a step that says so. */
    void flightRequested();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void makeBubble();
    void go(std::size_t step);
    void next();
    void back();
    void place();
    [[nodiscard]] QRect spotlight() const;

    std::vector<TourStep> m_steps;
    std::size_t m_step = 0;
    Theme m_theme;
    QWidget* m_bubble = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_text = nullptr;
    QLabel* m_count = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
    QPushButton* m_skip = nullptr;
};

} // namespace berg
