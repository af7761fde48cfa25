#pragma once

#include "app/layout/window_part.h"

#include <QByteArray>

#include <vector>

class QDockWidget;
class QSize;

namespace berg {

/** In the order of the menu of panels. */
enum class Dock
{
    Tradeoff,
    Plan,
    Inspector,
    Pareto,
    History,
    Zeta,
    Sigma,
    Events,
    ComparisonChart,
    Checks,
    SolveTime,
    Study,
    Comparison,
    Icebergs,
    Layers,
    Messages,
    Aircraft,
    Starts
};

/** Arrangements of the docks for one kind of work each. */
enum class Layout
{
    Plan,   ///< the map, what is chosen and what comes of it
    Fly,    ///< the map, the plan and how it goes
    Analyse ///< charts and tables round the map
};

/** The panels as docks round the map, and how the user has arranged them. */
class Docks : public WindowPart
{
    Q_OBJECT

public:
    explicit Docks(WindowContext& context);

    [[nodiscard]] QDockWidget* dock(Dock which) const;
    [[nodiscard]] const std::vector<QDockWidget*>& all() const { return m_docks; }
    /** Shows it, before the others of its tabs. */
    void raise(Dock which) const;
    /** Whether it is seen: shown, and not behind another tab. */
    [[nodiscard]] bool isInFront(Dock which) const;
    /** A study wants more room than the docks have: a window of its own, as long as one wants it.
     */
    void openFloating(Dock which, const QSize& best_px) const;
    void openInspector() const;

    /** Stores the present layout for `reset` and for the layout `Analyse`. */
    void noteDefault();
    void reset();
    /** In this one, as it is by itself. */
    void begin(Layout layout);
    /** Restores a layout as the user left it, and first stores the current one. */
    void showLayout(Layout layout);
    [[nodiscard]] Layout layout() const { return m_layout; }
    void save() const;
    void restore();

signals:
    /** A dock has come into sight. */
    void shown();
    void layoutChanged(berg::Layout layout);

private:
    QDockWidget* add(const char* name, const QString& title, QWidget* content,
                     Qt::DockWidgetArea area);
    void addRight();
    void addBottom();
    void addStudies();
    void arrange(Layout layout) const;
    void fitScreen() const;
    void shareRight() const;
    void setLayout(Layout layout);

    Layout m_layout = Layout::Analyse;
    std::vector<QDockWidget*> m_docks;
    QByteArray m_defaultLayout;
};

} // namespace berg
