#pragma once

#include "app/window/window_part.h"

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
    Icebergs
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
    /** A study wants more room than the docks have: a window of its own, as long as one wants it.
     */
    void openFloating(Dock which, const QSize& best_px) const;
    void openInspector() const;

    /** As the window is now: what `reset` goes back to. */
    void noteDefault();
    void reset() const;
    void save() const;
    void restore() const;

signals:
    /** A dock has come into sight. */
    void shown();

private:
    QDockWidget* add(const char* name, const QString& title, QWidget* content,
                     Qt::DockWidgetArea area);
    void addRight();
    void addBottom();
    void addStudies();

    std::vector<QDockWidget*> m_docks;
    QByteArray m_defaultLayout;
};

} // namespace berg
