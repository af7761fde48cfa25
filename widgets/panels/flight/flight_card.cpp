#include "widgets/panels/flight/flight_card.h"

#include "widgets/flight/compared_run.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"
#include "widgets/words/plan_text.h"

#include <QEvent>
#include <QGridLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kEdge_px = 12;
constexpr int kAboveScale_px = 74; ///< height of the scale bar and the margins below it
constexpr int kPadding_px = 12;
constexpr double kRadius_px = 7;

/** Returns whether the run was changed in flight, so that the prediction does not apply. */
bool isChanged(const ComparedRun& run)
{
    return run.wasChanged || !run.worldChanges.empty();
}

} // namespace

FlightSummary flightSummary(const FlightRecord& record,
                            const std::optional<ZetaPrediction>& predicted)
{
    const ComparedRun run = comparedRun(record);
    const RunFigures figures = figuresAt(run, run.flown_s);
    FlightSummary summary{.zeta_m2s = run.metrics.zeta_m2s,
                          .visits = run.metrics.visits,
                          .wasChanged = isChanged(run)};
    if (!summary.wasChanged)
        summary.predicted = predicted;
    if (const KnownBound bound = record.boundOfFlight(); bound.zeta_m2s) {
        summary.bound_m2s = bound.zeta_m2s;
        summary.boundShare = bound.whole ? 1 : bound.share;
        if (bound.whole)
            summary.isBoundFromRates = bound.whole->curve.back().isFromRates;
    }
    if (const std::optional<std::size_t>& longest = figures.longestUnseen) {
        summary.longestUnseen = shownName(record.now.icebergs[*longest]);
        summary.longestUnseen_s = figures.unseen[*longest].longest_s;
    }
    return summary;
}

FlightCard::FlightCard(QWidget* map)
    : QFrame(map)
    , m_title(new QLabel(tr("Run complete")))
    , m_close(new QToolButton)
    , m_zeta(new FigureLabel)
{
    setObjectName(u"flightCard"_s);
    setAccessibleName(tr("Result of the run"));
    setCursor(Qt::ArrowCursor);
    m_close->setObjectName(u"flightCardClose"_s);
    m_close->setText(u"\u00d7"_s);
    m_close->setAutoRaise(true);
    m_close->setAccessibleName(tr("Close"));
    m_close->setToolTip(tr("Closes this card until the next run ends."));
    m_zeta->setObjectName(u"flightCardZeta"_s);
    m_zeta->setAccessibleDescription(tr("Zeta ζ"));

    auto* column = new QGridLayout(this);
    column->setContentsMargins(kPadding_px, kPadding_px / 2, kPadding_px, kPadding_px);
    column->setVerticalSpacing(3);
    column->setHorizontalSpacing(kPadding_px);
    column->addWidget(m_title, 0, 0);
    column->addWidget(m_close, 0, 1, Qt::AlignRight);
    column->addWidget(m_zeta, 1, 0, 1, 2);
    m_predicted = addRow(*column, u"flightCardPredicted"_s, tr("vs prediction"),
                         tr("ζ compared with the prediction for the policy before take-off."));
    m_range = addRow(*column, u"flightCardRange"_s, tr("Predicted range"),
                     tr("Predicted range of ζ for 90 % of flights."));
    m_bound = addRow(*column, u"flightCardBound"_s, tr("Lower bound"), boundToolTip({}));
    m_visits = addRow(*column, u"flightCardVisits"_s, tr("Visits"), tr("Targets reached."));
    m_unseen = addRow(*column, u"flightCardUnseen"_s, tr("Longest unseen"),
                      tr("The iceberg that was out of view longest."));
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, kPadding_px / 2, 0, 0);
    const auto addButton = [&](const QString& name, const QString& text, const QString& toolTip,
                               void (FlightCard::*intent)()) {
        auto* button = new QPushButton(text);
        button->setObjectName(name);
        button->setToolTip(toolTip);
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard with the map
        connect(button, &QPushButton::clicked, this, intent);
        row->addWidget(button);
    };
    addButton(u"flightCardCompare"_s, tr("Compare"), tr("Compares the run with others."),
              &FlightCard::compareRequested);
    addButton(u"flightCardSave"_s, tr("Save run"), tr("Saves the run to a file."),
              &FlightCard::saveRequested);
    addButton(u"flightCardReport"_s, tr("Report"),
              tr("Exports the log of the run: planned and flown, sightings, deviations."),
              &FlightCard::reportRequested);
    column->addLayout(row, column->rowCount(), 0, 1, 2);
    connect(m_close, &QToolButton::clicked, this, [this] {
        hide();
        emit closed();
    });
    map->installEventFilter(this);
    setTheme(m_theme);
    hide();
}

QLabel* FlightCard::addRow(QGridLayout& rows, const QString& name, const QString& caption,
                           const QString& toolTip)
{
    auto* value = new QLabel;
    value->setObjectName(name);
    value->setAccessibleDescription(caption);
    auto* before = new CaptionLabel(caption);
    for (QLabel* label : {value, static_cast<QLabel*>(before)})
        label->setToolTip(toolTip);
    const int row = rows.rowCount();
    rows.addWidget(before, row, 0);
    rows.addWidget(value, row, 1, Qt::AlignRight);
    return value;
}

void FlightCard::setTheme(const Theme& theme)
{
    m_theme = theme;
    setCaptionTheme(*this, theme);
    m_title->setFont(theme.strong());
    m_zeta->setFont(theme.figure());
    for (QLabel* label : {m_predicted, m_range, m_bound, m_visits, m_unseen})
        label->setFont(theme.body());
    update();
}

void FlightCard::showSummary(const FlightSummary& summary)
{
    const auto zeta = [&](double zeta_m2s) { return zetaText(zeta_m2s, locale()); };
    showValue(*m_zeta, u"ζ "_s + zeta(summary.zeta_m2s));
    showValue(*m_predicted,
              summary.predicted && summary.predicted->mean_m2s > 0
                  ? u"%1 (%2)"_s.arg(
                        changeText(summary.zeta_m2s / summary.predicted->mean_m2s - 1, locale()),
                        zeta(summary.predicted->mean_m2s))
              : summary.wasChanged ? tr("changed in flight")
                                   : missingValueText());
    showValue(*m_range, rangeText(summary));
    const QString bound = summary.bound_m2s ? zeta(*summary.bound_m2s) : missingValueText();
    const bool isComputing = summary.bound_m2s && summary.boundShare < 1;
    const bool isUseless =
        summary.bound_m2s && !isUsefulBound(*summary.bound_m2s, summary.zeta_m2s);
    showValue(*m_bound,
              isComputing
                  ? tr("being computed, %1 %").arg(fixedText(100 * summary.boundShare, 0, locale()))
              : isUseless ? tr("no useful bound")
                          : bound);
    m_bound->setToolTip(boundToolTip(summary));
    showValue(*m_visits, fixedText(summary.visits, 0, locale()));
    showValue(*m_unseen,
              summary.longestUnseen.isEmpty()
                  ? missingValueText()
                  : u"%1, %2"_s.arg(summary.longestUnseen, clockText(summary.longestUnseen_s)));
    place();
    show();
    raise();
}

QString FlightCard::boundToolTip(const FlightSummary& summary)
{
    return (QStringList(tr("Lower bound on ζ for these conditions, whatever the policy."))
            << boundSourceLines(summary.isBoundFromRates))
        .join(u'\n');
}

/** Returns the position of ζ in the predicted range. */
QString FlightCard::rangeText(const FlightSummary& summary) const
{
    if (!summary.predicted)
        return missingValueText();
    const double least_m2s = summary.predicted->least_m2s;
    const double most_m2s = summary.predicted->most_m2s;
    const QString text = summary.zeta_m2s < least_m2s  ? tr("below %1 to %2")
                         : summary.zeta_m2s > most_m2s ? tr("above %1 to %2")
                                                       : tr("inside %1 to %2");
    const ShownUnit unit = zetaUnit(summary.zeta_m2s); // the unit of the figure above
    return text.arg(significantText(unit.fromSi(least_m2s), 4, locale()),
                    significantText(unit.fromSi(most_m2s), 4, locale()));
}

/** Places the card in its corner or at the user's position, within the map. */
void FlightCard::place()
{
    adjustSize();
    const QSize room = parentWidget()->size() - size();
    const QPoint at =
        m_movedTo_px.value_or(QPoint(room.width() - kEdge_px, room.height() - kAboveScale_px));
    move(std::clamp(at.x(), 0, std::max(0, room.width())),
         std::clamp(at.y(), 0, std::max(0, room.height())));
}

bool FlightCard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void FlightCard::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.panelLine, 1));
    painter.setBrush(m_theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kRadius_px, kRadius_px);
}

void FlightCard::mousePressEvent(QMouseEvent* event)
{
    m_grabbed = event->position().toPoint();
}

void FlightCard::mouseMoveEvent(QMouseEvent* event)
{
    if (!event->buttons().testFlag(Qt::LeftButton))
        return;
    m_movedTo_px = mapToParent(event->position().toPoint()) - m_grabbed;
    place();
}

} // namespace berg
