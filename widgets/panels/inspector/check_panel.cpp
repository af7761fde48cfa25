#include "widgets/panels/inspector/check_panel.h"

#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/icons.h"
#include "widgets/words/issue_text.h"

#include <QListWidget>
#include <QStackedLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMark_px = 16;
constexpr int kGap_px = 3;

IconName iconOf(Severity severity)
{
    switch (severity) {
    case Severity::Error:
        return IconName::Fault;
    case Severity::Warning:
        return IconName::Warning;
    case Severity::Hint:
        return IconName::Hint;
    }
    return IconName::Hint;
}

QString severityText(Severity severity)
{
    switch (severity) {
    case Severity::Error:
        return CheckPanel::tr("Error: must be fixed before planning");
    case Severity::Warning:
        return CheckPanel::tr("Warning: probably not intended");
    case Severity::Hint:
        return CheckPanel::tr("Hint: good to know");
    }
    return {};
}

} // namespace

CheckPanel::CheckPanel(const ScenarioDocument& document, QWidget* parent)
    : QWidget(parent), m_document(document)
{
    m_pages = new QStackedLayout(this);
    m_empty = new CaptionLabel(tr("No problems found"));
    m_empty->setObjectName(u"checksEmpty"_s);
    m_empty->setAlignment(Qt::AlignCenter);
    m_pages->addWidget(m_empty);
    m_list = new QListWidget;
    m_list->setObjectName(u"checkList"_s);
    m_list->setAccessibleName(tr("Findings about the scenario"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setIconSize(QSize(kMark_px, kMark_px));
    m_list->setSpacing(kGap_px);
    m_list->setWordWrap(true);
    m_list->setTextElideMode(Qt::ElideNone);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setResizeMode(QListView::Adjust);
    m_pages->addWidget(m_list);
    setFocusProxy(m_list);
    connect(m_list, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { choose(m_list->row(item)); });
    connect(m_list, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { choose(m_list->row(item)); });
    connect(&document, &ScenarioDocument::scenarioChanged, this, &CheckPanel::refresh);
    setTheme(m_theme);
    refresh();
}

void CheckPanel::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_list->setFont(theme.body());
    setCaptionTheme(*this, theme);
    fill();
}

/** Updates the list only if it changed, so that it does not jump while it is read. */
void CheckPanel::refresh()
{
    std::vector<Issue> issues = m_document.issues();
    issues.insert(issues.end(), m_planIssues.begin(), m_planIssues.end());
    std::stable_sort(issues.begin(), issues.end(),
                     [](const Issue& a, const Issue& b) { return a.severity < b.severity; });
    QStringList lines;
    for (const Issue& issue : issues)
        lines << issueLine(issue, m_document.scenario());
    const bool same = issues == m_issues && lines == m_lines;
    m_issues = std::move(issues);
    m_lines = std::move(lines);
    if (!same)
        fill();
    m_pages->setCurrentWidget(m_issues.empty() ? static_cast<QWidget*>(m_empty) : m_list);
    if (!same)
        emit changed();
}

void CheckPanel::setPlanIssues(std::vector<Issue> issues)
{
    m_planIssues = std::move(issues);
    refresh();
}

void CheckPanel::fill()
{
    const int row = m_list->currentRow();
    m_list->clear();
    for (std::size_t i = 0; i < m_issues.size(); ++i) {
        const Severity severity = m_issues[i].severity;
        const QString& line = m_lines[static_cast<qsizetype>(i)];
        auto* item = new QListWidgetItem(icon(iconOf(severity), m_theme), line, m_list);
        item->setToolTip(severityText(severity));
        item->setData(Qt::AccessibleTextRole, line);
        item->setData(Qt::AccessibleDescriptionRole, severityText(severity));
    }
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
}

void CheckPanel::choose(int row)
{
    if (row < 0 || row >= static_cast<int>(m_issues.size()))
        return;
    // A copy, because a receiver may change the list.
    const Issue issue = m_issues[static_cast<std::size_t>(row)];
    emit chosen(issue);
}

} // namespace berg
