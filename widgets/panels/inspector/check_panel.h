#pragma once

#include "widgets/model/scenario_document.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QListWidget;
class QStackedLayout;

namespace berg {

class CaptionLabel;

/**
 * Every finding about the scenario as it is now, worst first; one chosen by a click or Return is
 * told to whoever can show what it is about.
 */
class CheckPanel : public QWidget
{
    Q_OBJECT

public:
    /** `document` is borrowed and must outlive the panel. */
    explicit CheckPanel(const ScenarioDocument& document, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** What is to be said of the plan, after the findings about the scenario. */
    void setPlanIssues(std::vector<Issue> issues);
    /** All that is listed. */
    [[nodiscard]] const std::vector<Issue>& issues() const { return m_issues; }

signals:
    /** What is listed is new. */
    void changed();
    void chosen(const berg::Issue& issue);

private:
    void refresh();
    void fill();
    void choose(int row);

    const ScenarioDocument& m_document;
    Theme m_theme = Theme::light();
    std::vector<Issue> m_planIssues;
    std::vector<Issue> m_issues; ///< as listed
    QStringList m_lines;
    QStackedLayout* m_pages = nullptr;
    QListWidget* m_list = nullptr;
    CaptionLabel* m_empty = nullptr;
};

} // namespace berg
