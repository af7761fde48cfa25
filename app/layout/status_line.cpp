#include "app/layout/status_line.h"

#include "app/layout/panels.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/announcer.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/issue_text.h"
#include "widgets/workspace/workspace.h"

#include <QLabel>
#include <QMainWindow>
#include <QStatusBar>
#include <QToolButton>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kLongestState_px = 420;
constexpr int kLabelMargin_px = 8;

template <class Label>
Label* makeLabel(const QString& name)
{
    auto* label = new Label;
    label->setObjectName(name);
    return label;
}

} // namespace

StatusLine::StatusLine(WindowContext& context)
    : WindowPart(context)
    , m_hint(makeLabel<QLabel>(u"hintLabel"_s))
    , m_cursor(makeLabel<QLabel>(u"cursorLabel"_s))
    , m_state(makeLabel<QLabel>(u"stateLabel"_s))
    , m_findings(new QToolButton)
    , m_autosaved(makeLabel<CaptionLabel>(u"autosaveLabel"_s))
{
    m_findings->setObjectName(u"checksButton"_s);
    m_findings->setAutoRaise(true);
    m_findings->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_findings->setFocusPolicy(Qt::TabFocus);
    m_findings->setToolTip(tr("Shows the findings about the scenario."));
    QSizePolicy room = m_findings->sizePolicy();
    room.setRetainSizeWhenHidden(true); // or the map above gets another size
    m_findings->setSizePolicy(room);
    for (QLabel* label : {m_state, m_cursor}) // neighbours do not touch
        label->setContentsMargins(kLabelMargin_px, 0, kLabelMargin_px, 0);
    QStatusBar& bar = *window().statusBar();
    bar.addWidget(m_hint, 1);
    // The text that comes and goes with the pointer is leftmost, where it moves nothing.
    for (QWidget* widget : std::initializer_list<QWidget*>{m_cursor, m_findings, m_state,
                                                           m_autosaved, panels().announcer})
        bar.addPermanentWidget(widget);

    connect(m_findings, &QToolButton::clicked, this, &StatusLine::findingsRequested);
    const auto refuse = [this](const QString& text) { showMessage(text, kLongMessage_ms); };
    connect(&workspace(), &Workspace::refused, this, refuse);
    connect(panels().map, &MapView::refused, this, refuse);
    connect(panels().map, &MapView::cursorMoved, this, &StatusLine::showCursor);
    connect(panels().map, &MapView::cursorLeft, m_cursor, &QLabel::clear);
    connect(&panels().map->tools(), &MapToolbox::statusText, m_hint, &QLabel::setText);
}

void StatusLine::showCursor(const Point& position_m)
{
    const LatLon place =
        LocalFrame(workspace().document().scenario().origin).toGeographic(position_m);
    m_cursor->setText(tr("%1   %2 E  %3 N", "place, east and north of the origin")
                          .arg(placeText(place, 2, locale()), offsetText(position_m.x(), locale()),
                               offsetText(position_m.y(), locale())));
    m_cursor->setAccessibleName(tr("Cursor: %1").arg(m_cursor->text()));
}

void StatusLine::showState(const QString& text)
{
    m_state->setText(m_state->fontMetrics().elidedText(text, Qt::ElideRight, kLongestState_px));
    m_state->setAccessibleName(tr("State: %1").arg(text));
    m_state->setToolTip(text == m_state->text() ? QString() : text);
}

void StatusLine::showAutosaved(const QString& text)
{
    m_autosaved->setText(text);
}

void StatusLine::showFindings(const IssueCounts& counts)
{
    m_counts = counts;
    m_findings->setVisible(counts.errors + counts.warnings > 0);
    m_findings->setText(countsText(counts));
    m_findings->setIcon(icon(counts.errors > 0 ? IconName::Fault : IconName::Warning, theme()));
}

void StatusLine::setTheme(const Theme& theme)
{
    m_autosaved->setTheme(theme);
    showFindings(m_counts);
}

} // namespace berg
