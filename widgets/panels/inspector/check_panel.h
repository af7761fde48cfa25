#pragma once

#include "widgets/document/scenario_document.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QListWidget;
class QStackedLayout;

namespace berg {

class CaptionLabel;

/**
 * List of all findings in the present scenario, worst first. Emits a finding chosen by a click or
 * Return.
 */
class CheckPanel : public QWidget
{
    Q_OBJECT

public:
    /** Borrows `document`, which must outlive the panel. */
    explicit CheckPanel(const ScenarioDocument& document, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Sets the findings about the plan, which are listed with those about the scenario. */
    void setPlanIssues(std::vector<Issue> issues);
    /** All listed findings. */
    [[nodiscard]] const std::vector<Issue>& issues() const { return m_issues; }

signals:
    /** Emitted when the list has changed. */
    void changed();
    void chosen(const berg::Issue& issue);

private:
    void refresh();
    void fill();
    void choose(int row);

    const ScenarioDocument& m_document;
    Theme m_theme = Theme::light();
    std::vector<Issue> m_planIssues;
    std::vector<Issue> m_issues; ///< in the order of the list
    QStringList m_lines;
    QStackedLayout* m_pages = nullptr;
    QListWidget* m_list = nullptr;
    CaptionLabel* m_empty = nullptr;
};

} // namespace berg
